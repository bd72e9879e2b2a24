#include "review_room.h"

#include <nlohmann/json.hpp>

#include "print.h"
#include "room_files.h"
#include "room_session.h"
#include "roomgen/base/file.h"

namespace roomgen::cli {

namespace {

constexpr int seen_pixels = 1024;

Status append_to_trace(const std::filesystem::path& file, const std::vector<ReviewRound>& rounds) {
  auto text = read_file(file);
  if (!text) return text.error();
  for (std::size_t i = 0; i < rounds.size(); ++i)
    *text += json_line({{"review", i + 1}, {"judgement", rounds[i].judgement}, {"changes", rounds[i].changes},
                        {"refused", rounds[i].refused}}) + "\n";
  return write_file(file, *text);
}

}  // namespace

Result<std::vector<ReviewRound>> review_room(const RoomToReview& room, Scene& scene) {
  const auto file = room.folder / "scene.json";
  auto prompts = room.designer.prompts.empty() ? Result<Prompts>(Prompts::built_in()) : Prompts::from_folder(room.designer.prompts);
  if (!prompts) return prompts.error();
  auto session = open_room(file, room.library, {.tell = warn, .cancel = room.cancel});
  if (!session) return session.error();
  PictureDrawer drawer;
  Reviewing reviewing{*room.composed.model, *std::move(prompts)};
  if (room.designer.model_mode() != ModelMode::constraints)
    reviewing.pictures = [&](Session& looked_at) {
      return pictures_for_model(room.designer, drawer, looked_at, {"marks", "iso", "eye"}, seen_pixels);
    };
  reviewing.rounds = room.rounds;
  reviewing.tokens = room.designer.plan_tokens;  // it may draw things, as for the plan
  reviewing.cancel = room.cancel;
  auto rounds = review(*session, reviewing);
  if (!rounds) return rounds;
  if (auto status = append_to_trace(room.folder / "trace.jsonl", *rounds); !status) return status.error();
  if (session->is_saved()) return rounds;
  auto status = write_room(file, *session, room.has_pictures ? &drawer : nullptr, room.pixels, warn, room.cancel);
  if (!status) return status.error();
  scene = session->scene();
  return rounds;
}

}  // namespace roomgen::cli
