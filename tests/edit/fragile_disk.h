#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/random.h"
#include "scene_files.h"

namespace roomgen {

/// Two files on a disk that may lose power: of what was written since the last sync any sectors may be there
/// or not or torn, in any order. scene.json, which is written aside and renamed, is the old one or the new one.
struct FragileDisk {
  static constexpr std::size_t sector = 512;

  std::string journal, kept_journal;  ///< as programs see it, and what surely survives
  std::string scene;
  bool has_scene = true;
  int calls_left = -1;  ///< until the power goes; -1: it stays
  bool is_off = false;
  Random random{1};

  struct Written {
    std::size_t at = 0;
    std::string bytes;
    bool is_cut = false;
  };
  std::vector<Written> pending;

  /// Does this call still come through? The last one may or may not have had its effect.
  bool lives() {
    if (calls_left < 0) return true;
    if (calls_left == 0) is_off = true;
    else --calls_left;
    return !is_off;
  }

  // Of a sector: all, nothing, or with bad luck what was written when the head lost its way.
  std::size_t bytes_kept(std::size_t length) {
    if (random.chance(0.1)) return static_cast<std::size_t>(random.integer(0, static_cast<int>(length)));
    return random.chance(0.5) ? length : 0;
  }

  /// What is found when the power is back.
  void restart() {
    std::string found = kept_journal;
    random.shuffle(pending);
    for (const auto& one : pending) {
      if (one.is_cut) {
        if (random.chance(0.5) && found.size() > one.at) found.resize(one.at);
        continue;
      }
      for (std::size_t from = 0; from < one.bytes.size(); from += sector) {
        // Sectors are those of the disk: the first piece ends at the next boundary.
        const std::size_t length = std::min(sector - (one.at + from) % sector, one.bytes.size() - from);
        if (const std::size_t whole = bytes_kept(length); whole > 0) {
          if (found.size() < one.at + from + whole) found.resize(one.at + from + whole, '\0');
          found.replace(one.at + from, whole, one.bytes, from, whole);
        }
        from -= sector - length;
      }
    }
    journal = kept_journal = found;
    pending.clear();
    calls_left = -1;
    is_off = false;
  }

  static SceneFiles files(const std::shared_ptr<FragileDisk>& disk) {
    const Error off{Error::Kind::io, "the power is off"};
    SceneFiles files;
    files.scene_name = "scene.json";
    files.journal_name = "scene.journal";
    files.read_scene = [disk]() -> Result<std::string> {
      if (!disk->has_scene) return Error{Error::Kind::not_found, "scene.json: no such file"};
      return disk->scene;
    };
    files.read_journal = [disk]() -> Result<std::string> { return disk->journal; };
    files.write_scene = [disk, off](std::string_view bytes) -> Status {
      const bool lives = disk->lives();
      if (lives || disk->random.chance(0.5)) disk->scene = bytes, disk->has_scene = true;
      return lives ? Status() : off;
    };
    files.append = [disk, off](std::string_view bytes) -> Status {
      disk->pending.push_back({disk->journal.size(), std::string(bytes), false});
      disk->journal += bytes;
      return disk->lives() ? Status() : off;
    };
    files.sync = [disk, off]() -> Status {
      const bool lives = disk->lives();
      if (lives) disk->kept_journal = disk->journal, disk->pending.clear();
      return lives ? Status() : off;
    };
    files.cut = [disk, off](std::size_t size) -> Status {
      disk->pending.push_back({size, "", true});
      disk->journal.resize(size);
      return disk->lives() ? Status() : off;
    };
    return files;
  }
};

}  // namespace roomgen
