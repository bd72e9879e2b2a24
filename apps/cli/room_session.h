#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "designers.h"
#include "room_files.h"
#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/library/library.h"
#include "roomgen/edit/session.h"
#include "roomgen/edit_reader/understand.h"

namespace roomgen::cli {

/// Hears what people should know besides the answer.
using Tell = std::function<void(const std::string&)>;

struct RoomAccess {
  bool look_only = false;
  bool repair = true;
  Tell tell = {};  ///< notices, and meshes that are missing
  CancelToken cancel = {};
};

/// A room's session, with the meshes that were written beside its scene.json. `library` must outlive it.
Result<Session> open_room(const std::filesystem::path& scene_file, const AssetLibrary& library, RoomAccess access);

/// scene.json, and what lies beside it of the room's other files. Pictures that are not drawn anew (without a
/// drawer) go: they would show the room as it was. What was acknowledged stands in the journal, whatever
/// becomes of the files that follow it: that they could not be written is told.
Status write_room(const std::filesystem::path& scene_file, Session& session, PictureDrawer* drawer, int pixels,
                  const Tell& tell, const CancelToken& cancel = {});

/// The rooms of a session as a model sees them, in these views of so many pixels, room by room.
Result<std::vector<std::string>> pictures_for_model(const DesignerOptions& options,
                                                    PictureDrawer& drawer, Session& session,
                                                    std::initializer_list<const char*> views,
                                                    int pixels);

/// Of words that ask for nothing.
std::string remark_line(const std::string& remark);
Json operations_json(const std::vector<edit::Operation>& operations);
/// What an edit did.
Json report_json(const EditReport& report);
std::vector<std::string> report_lines(const EditReport& report);
/// What a pose would mean.
Json preview_json(const Preview& preview);
std::vector<std::string> preview_lines(const Preview& preview);
/// All entries; in lines, * is the current state, - what was undone.
Json history_json(const Session& session);
std::vector<std::string> history_lines(const Session& session);

}  // namespace roomgen::cli
