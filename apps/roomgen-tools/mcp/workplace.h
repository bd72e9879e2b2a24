#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "offer.h"
#include "room_session.h"
#include "root_folder.h"

namespace roomgen::mcp {

/// What the tools work with, one call at a time. Rooms are opened for each call, so that people and other
/// programs may edit them in between; meshes and pictures stay in memory.
struct Workplace {
  RootFolder root;
  std::shared_ptr<const AssetLibrary> stock;
  bool keeps_pictures = true;  ///< those in a room's folder are drawn anew after each change
  cli::PictureDrawer drawer = {};
  std::unique_ptr<AssetLibrary> library = {};  ///< what the agent had made, then the stock

  /// Where that is kept, below the root.
  Result<std::filesystem::path> made_folder() const { return root.find(".made"); }
  void renew_library();
};

/// Of the pictures in a room's folder.
inline constexpr int kept_pixels = 1024;

/// A room that a call is about.
struct OpenedRoom {
  std::filesystem::path scene_file;
  std::string name;  ///< as agents name it
  Session session;
};

/// What was noticed on the way goes into `notices`, which must outlive the room.
Result<OpenedRoom> open_room(Workplace& place, const std::string& room, std::vector<std::string>& notices,
                             cli::RoomAccess access);
/// For looking only, which is possible while somebody else edits.
Result<OpenedRoom> look_at_room(Workplace& place, const ToolCall& call, std::vector<std::string>& notices);

/// PNG bytes of a view that tools know (views.h).
Result<std::string> draw(Workplace& place, const Scene& scene, const ModelTable& models, const std::string& view,
                         int pixels);
/// The picture that the arguments ask for after a change; one that cannot be drawn is told in the answer.
void add_wanted_picture(Workplace& place, const Scene& scene, const ModelTable& models, const ToolCall& call,
                        ToolAnswer& answer);

/// One text of several lines.
std::string text_of(const std::vector<std::string>& lines);

}  // namespace roomgen::mcp
