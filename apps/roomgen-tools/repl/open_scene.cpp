#include "open_scene.h"

#include "roomgen/base/file.h"

namespace roomgen::repl {

Result<OpenScene> OpenScene::open(std::filesystem::path file, const AssetLibrary& library, cli::RoomAccess access) {
  OpenScene scene(std::move(file), library, std::move(access));
  if (auto status = scene.reopen(); !status) return status.error();
  return scene;
}

Status OpenScene::reopen() {
  session_.reset();  // lets go of the journal
  auto session = cli::open_room(file_, *library_, access_);
  if (!session) return session.error();
  session_ = *std::move(session);
  return {};
}

bool OpenScene::is_changed_by_hand() const {
  if (!session_->is_saved()) return false;
  const auto text = read_file(file_);
  return !text || *text != session_->text();
}

Result<Session*> OpenScene::session() {
  if (!session_ || is_changed_by_hand())
    if (auto status = reopen(); !status) return status.error();
  return &*session_;
}

}  // namespace roomgen::repl
