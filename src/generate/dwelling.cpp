#include <iterator>
#include <set>
#include <utility>

#include "evaluate/ledger.h"
#include "ready.h"
#include "roomgen/generate/generate.h"
#include "scene/dwelling.h"

namespace roomgen {

namespace {

void add(const SuggestionFigures& part, SuggestionFigures& sum) {
  sum.located += part.located;
  for (std::size_t i = 0; i < sum.within.size(); ++i) {
    sum.within[i] += part.within[i];
    sum.placed_within[i] += part.placed_within[i];
  }
  sum.faced += part.faced;
  sum.facing_kept += part.facing_kept;
}

void add(const ModelUse& part, ModelUse& sum) {
  sum.calls += part.calls;
  sum.input_tokens += part.input_tokens;
  sum.output_tokens += part.output_tokens;
  sum.seconds += part.seconds;
  sum.fallbacks += part.fallbacks;
}

/// Takes over one furnished room after the other.
class DwellingJoiner {
 public:
  explicit DwellingJoiner(const DwellingPlan& plan) {
    whole_.scene.prompt = plan.prompt;
    whole_.scene.seed = plan.seed;
    whole_.scene.heard = plan.heard;
  }

  void add_room(const Room& room, Generation part) {
    Scene& scene = whole_.scene;
    for (const auto& opening : part.scene.room.openings)
      add_model(opening.joinery.asset, part.models);
    scene.rooms.push_back(part.scene.room);
    scene.incomplete = scene.incomplete || part.scene.incomplete;
    for (auto& object : part.scene.objects) {
      object.room = room.id;
      add_model(object.asset, part.models);
      scene.objects.push_back(std::move(object));
    }
    for (auto& missing : part.scene.unplaced) scene.unplaced.push_back(std::move(missing));
    for (auto& verdict : part.scene.requirements) {
      verdict.requirement.room = room.id;
      scene.requirements.push_back(std::move(verdict));
    }
    for (auto& asset : part.assets)
      if (assets_.insert(asset_key(asset.ref)).second) whole_.assets.push_back(std::move(asset));
    for (auto& step : part.trace) {
      step.room = room.id;
      whole_.trace.push_back(std::move(step));
    }
    for (auto& round : part.choices) {
      round.room = room.id;
      whole_.choices.push_back(std::move(round));
    }
    for (auto& move : part.moved) whole_.moved.push_back(std::move(move));
    for (auto& note : part.notes) whole_.notes.push_back(room.id + ": " + note);
    whole_.constraints += part.constraints;
    whole_.held += part.held;
    add(part.suggestions, whole_.suggestions);
    add(part.model_use, whole_.model_use);
    if (whole_.stopped.empty()) whole_.stopped = part.stopped;
  }

  const std::string& stopped() const { return whole_.stopped; }
  Generation take() { return std::move(whole_); }

 private:
  void add_model(const AssetRef& asset, const ModelTable& models) {
    const std::string key = asset_key(asset);
    if (key.empty()) return;
    if (const auto model = models.find(key)) whole_.models.add(key, model);
  }

  Generation whole_;
  std::set<std::string> assets_;
};

// The events of one room as part of the whole.
std::function<void(const BuildEvent&)> shifted(const BuildOptions& options, std::size_t before,
                                               std::size_t total) {
  if (!options.on_event) return {};
  return [&options, before, total](BuildEvent event) {
    event.done += before;
    event.total = total;
    options.on_event(event);
  };
}

}  // namespace

Result<Generation> generate(const DwellingPlan& given, Designer& designer,
                            const AssetLibrary& library, const KindTable& categories,
                            const BuildOptions& options) {
  DwellingPlan plan = given;
  settle(plan);
  for (auto& room : plan.rooms) room = ready(std::move(room), categories);
  number_through(plan);
  std::vector<Room> rooms;
  std::vector<Plan> chosen;
  std::size_t total = 0, before = 0;
  for (const auto& room : plan.rooms) {
    rooms.push_back(room.room);
    total += planned_objects(room).size();
  }
  if (auto status = check_dwelling(rooms); !status) return status.error();
  DwellingJoiner joiner(plan);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    const Plan& room = plan.rooms[i];
    BuildOptions own = options;
    own.on_event = shifted(options, before, total);
    if (!joiner.stopped().empty()) {
      own.cancel = CancelToken();  // not the flag of others
      own.cancel.cancel();
    }
    auto part = generate(room, designer, library, categories, own);
    if (!part) return with_context(part.error(), "room \"" + room.room.id + "\"");
    before += planned_objects(room).size();
    const auto told = static_cast<std::ptrdiff_t>(given.rooms[i].notes.size());
    part->notes.insert(part->notes.begin(), room.notes.begin() + told, room.notes.end());
    chosen.push_back(part->chosen.empty() ? room : std::move(part->chosen.front()));
    joiner.add_room(room.room, *std::move(part));
  }
  Generation whole = joiner.take();
  if (!whole.choices.empty()) whole.chosen = std::move(chosen);
  auto verdicts = check_requirements(plan.requirements, whole.scene, categories, {});
  auto& all = whole.scene.requirements;
  all.insert(all.begin(), std::make_move_iterator(verdicts.begin()),
             std::make_move_iterator(verdicts.end()));
  return whole;
}

}  // namespace roomgen
