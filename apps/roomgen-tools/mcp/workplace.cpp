#include "workplace.h"

#include <utility>

#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "roomgen/render/pictures.h"
#include "views.h"

namespace roomgen::mcp {

namespace {

constexpr int small_picture = 512;
constexpr int best_compression = 9;

}  // namespace

void Workplace::renew_library() {
  const auto folder = made_folder();
  library = make_first_of({create::make_kept_library(folder ? *folder : ""), stock});
}

Result<OpenedRoom> open_room(Workplace& place, const std::string& room, std::vector<std::string>& notices,
                             cli::RoomAccess access) {
  const auto file = place.root.find_scene(room);
  if (!file) return file.error();
  access.tell = [&notices](const std::string& notice) { notices.push_back(notice); };
  auto session = cli::open_room(*file, *place.library, std::move(access));
  if (!session) return session.error();
  return OpenedRoom{*file, place.root.name_of(file->parent_path()), *std::move(session)};
}

Result<OpenedRoom> look_at_room(Workplace& place, const ToolCall& call, std::vector<std::string>& notices) {
  return open_room(place, call.arguments["room"].get<std::string>(), notices, {.look_only = true});
}

Result<std::string> draw(Workplace& place, const Scene& scene, const ModelTable& models, const std::string& view,
                         int pixels) {
  const auto renderer = place.drawer.renderer();
  if (!renderer) return renderer.error();
  const auto image = (*renderer)->render(scene, models, cli::view_named(view, pixels));
  if (!image) return image.error();
  return encode_png(*image, best_compression);
}

void add_wanted_picture(Workplace& place, const Scene& scene, const ModelTable& models, const ToolCall& call,
                        ToolAnswer& answer) {
  const std::string view = call.arguments.value("picture", "marks");
  if (view == "none") return;
  const auto picture = draw(place, scene, models, view, small_picture);
  if (picture) add_picture(answer, *picture);
  else answer.content.push_back({{"type", "text"}, {"text", "no picture: " + picture.error().message}});
}

std::string text_of(const std::vector<std::string>& lines) { return join(lines, "\n"); }

}  // namespace roomgen::mcp
