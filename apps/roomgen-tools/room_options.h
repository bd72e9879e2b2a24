#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "libraries.h"

namespace roomgen::cli {

/// What every command that changes a room is told.
struct RoomOptions {
  std::string scene, by = "person", repair = "on";
  bool no_pictures = false;
  int pixels = 1024;
  LibraryOptions libraries;

  bool may_repair() const { return repair != "off"; }
};

inline void add_scene(CLI::App& command, RoomOptions& options) {
  command.add_option("scene", options.scene, "scene.json; its journal is the .journal file beside it")->required();
}

inline void add_repair_option(CLI::App& command, RoomOptions& options) {
  command.add_option("--repair", options.repair, "May unlocked neighbours make way?")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
}

/// Who asks, and what becomes of the files that follow scene.json.
inline void add_file_options(CLI::App& command, RoomOptions& options) {
  command.add_option("--by", options.by, "Who asks, for the history")->capture_default_str();
  command.add_flag("--no-pictures", options.no_pictures, "Draw no pictures; older ones go");
  command.add_option("--pixels", options.pixels, "Length of the pictures' longer side")->capture_default_str();
  add_library_options(command, options.libraries);
}

}  // namespace roomgen::cli
