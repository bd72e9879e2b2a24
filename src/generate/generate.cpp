#include "roomgen/generate/generate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "fit_openings.h"
#include "loads.h"
#include "retrieve.h"
#include "roomgen/base/json.h"
#include "roomgen/evaluate/attributes.h"
#include "roomgen/evaluate/ledger.h"
#include "roomgen/geometry/free_rectangles.h"
#include "roomgen/library/vocabulary.h"
#include "roomgen/scene/judgement.h"
#include "roomgen/solve/improve.h"
#include "roomgen/solve/make_room.h"
#include "sizing.h"
#include "trace_json.h"
#include "window_cover.h"

namespace roomgen {

namespace {

// A picture or mirror hangs this far above what it is above.
constexpr double gap_above = 0.15;

// What is made to the measure of a window may be stretched a little.
constexpr double least_to_measure = 0.75, most_to_measure = 1.3;

// Of the free parts of the floor that a designer is told of: metres, and how many.
constexpr double least_free_side = 0.3;
constexpr std::size_t most_free_parts = 6;

// A yaw this far from the suggested one still follows it.
constexpr double facing_tolerance = pi / 12;

// After how many refusals a small thing goes elsewhere; how much smaller it gets where others make room.
constexpr std::size_t patience_with_support = 2;
constexpr double least_squeeze = 0.65;
constexpr double squeeze_step = 0.81;

// Assets that are looked at for one that can carry what it shall.
constexpr int most_carriers = 6;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Generator {
 public:
  Generator(const Plan& plan, Designer& designer, const AssetLibrary& library,
            const KindTable& categories, const GenerateOptions& options)
      : plan_(plan),
        designer_(designer),
        library_(library),
        categories_(categories),
        options_(options),
        retriever_(library, categories, options.seed),
        random_(Random(options.seed).fork("placement")),
        room_(plan.room),
        layout_(room_, categories, result_.models) {}

  Result<Generation> run() {
    if (auto status = join_openings(); !status) return status.error();
    const auto objects = planned_objects(plan_);
    left_ = objects;
    for (std::size_t i = 0; i < objects.size() && !has_stopped(); ++i) {
      const PlannedObject planned = take_next();
      if (options_.on_step) options_.on_step({i, objects.size(), planned.id});
      step(planned);
    }
    if (!has_stopped()) {
      if (options_.on_step) options_.on_step({objects.size(), objects.size(), "improving"});
      improve_all(options_.improve_rounds);
    }
    finish(objects);
    return std::move(result_);
  }

 private:
  // Doors and windows get their meshes first: what stands before them shall know them.
  Status join_openings() {
    const auto& kinds = OpeningKinds::built_in();
    if (!kinds) return kinds.error();
    auto used = fit_openings(room_, *kinds, library_, Random(options_.seed).fork("openings"));
    if (!used) return used.error();
    for (const auto& asset : *used) {
      auto model = library_.load(asset.ref);
      if (!model) return model.error();
      result_.models.add(asset_key(asset.ref), *std::move(model));
    }
    result_.assets = *std::move(used);
    return {};
  }

  bool has_stopped() const { return options_.cancel.cancelled() || !result_.stopped.empty(); }

  // The one that the designer asked for, else the first in the plan's order.
  PlannedObject take_next() {
    auto next = std::find_if(left_.begin(), left_.end(),
                             [&](const PlannedObject& planned) { return planned.id == next_; });
    if (next == left_.end()) next = left_.begin();
    PlannedObject planned = std::move(*next);
    left_.erase(next);
    next_.clear();
    return planned;
  }

  // Things that may come next: what stands on others waits for all that might carry it.
  std::vector<std::string> later() const {
    std::set<std::size_t> items;
    for (const auto& planned : left_) items.insert(planned.item);
    std::set<std::size_t> waiting;
    for (std::size_t i : items) {
      const PlanItem& item = plan_.items[i];
      if (item.mount == Mount::surface && std::any_of(items.begin(), items.end(), [&](std::size_t k) {
            return could_carry(plan_.items[k].category, item.on);
          }))
        waiting.insert(i);
    }
    std::vector<std::string> ids;
    for (const auto& planned : left_)
      if (!waiting.count(planned.item)) ids.push_back(planned.id);
    return ids;
  }

  bool could_carry(const std::string& category, const std::string& wanted) const {
    return wanted.empty() ? categories_.is_any_of(category, {"table", "storage"})
                          : categories_.is_a(category, wanted);
  }

  // One planned object from retrieval to its place. Failures end in reasons_, never in an error.
  void step(const PlannedObject& planned) {
    const auto start = Clock::now();
    const PlanItem& item = plan_.items[planned.item];
    Json record;
    record["object"] = planned.id;
    record["asked"] = {{"category", item.category}, {"description", item.description}};
    if (categories_.get(item.category).covers_window)
      return finish_step(planned, cover_window(planned, record), std::move(record), start);
    std::string reason;
    auto assets = able_candidates(planned);
    if (!assets)
      reason = assets.error().message;
    else if (assets->empty())
      reason = why_nothing(item);
    else
      reason = try_assets(planned, *assets, record);
    finish_step(planned, reason, std::move(record), start);
  }

  // What shall carry things takes an asset that can, if there is one.
  Result<std::vector<AssetInfo>> able_candidates(const PlannedObject& planned) {
    const PlanItem& item = plan_.items[planned.item];
    const auto loads = loads_on(planned.id, plan_, categories_);
    const int count = options_.assets_per_object;
    if (loads.empty()) return retriever_.candidates(item, planned, count);
    auto assets = retriever_.candidates(item, planned, std::max(count, most_carriers));
    if (!assets) return assets;
    const auto able = std::find_if(assets->begin(), assets->end(), [&](const AssetInfo& asset) {
      const auto task = prepare(planned, asset);
      return task && can_carry(task->object, loads, layout_.perches());
    });
    if (able != assets->end()) std::rotate(assets->begin(), able, able + 1);
    if (assets->size() > static_cast<std::size_t>(count)) assets->resize(static_cast<std::size_t>(count));
    return assets;
  }

  void finish_step(const PlannedObject& planned, const std::string& reason, Json record,
                   Clock::time_point start) {
    if (reason.empty()) {
      record["outcome"] = "placed";
    } else {
      record["outcome"] = "unplaced";
      record["reason"] = reason;
      reasons_[planned.id] = reason;
    }
    record["seconds"] = rounded(seconds_since(start));
    result_.trace.push_back({planned, std::move(record)});
  }

  // A curtain or blind is made to the measure of a window that has none, and needs no advice.
  // Returns why it does not hang anywhere, or nothing.
  std::string cover_window(const PlannedObject& planned, Json& record) {
    const PlanItem& item = plan_.items[planned.item];
    const Kind& category = categories_.get(item.category);
    std::vector<const Opening*> windows = windows_to_cover(room_, layout_.objects(), item.category);
    for (const auto& relation : item.relations)
      std::stable_partition(windows.begin(), windows.end(),
                            [&](const Opening* window) { return window->id == relation.target; });
    if (windows.empty()) return "the room has no window at which it could hang";
    for (const Opening* window : windows) {
      Object object;
      object.id = planned.id;
      object.category = item.category;
      object.mount = Mount::wall;
      object.traits = category.traits;
      object.size = category.size;
      for (auto& hung : hangings(object, category, room_, *window)) {
        const auto asset = made_to_measure(planned, hung);
        if (!asset) return asset.error().message;
        if (!*asset || !hang(planned, **asset, std::move(hung))) continue;
        record["window"] = window->id;
        return "";
      }
    }
    return "at no window is there room for it";
  }

  // An asset for the box, or nothing if none is of this size.
  Result<std::optional<AssetInfo>> made_to_measure(const PlannedObject& planned,
                                                   const Object& hung) {
    PlanItem item = plan_.items[planned.item];
    item.size = hung.size;
    item.asked = true;
    item.varied = true;  // windows differ
    const auto assets = retriever_.candidates(item, planned, options_.assets_per_object);
    if (!assets) return assets.error();
    for (const auto& asset : *assets) {
      const Vec3 stretch = hung.size.cwiseQuotient(asset.size);
      if (stretch.minCoeff() >= least_to_measure && stretch.maxCoeff() <= most_to_measure)
        return std::optional(asset);
    }
    return std::optional<AssetInfo>();
  }

  bool hang(const PlannedObject& planned, const AssetInfo& asset, Object hung) {
    auto model = library_.load(asset.ref);
    if (!model) return false;
    const PlanItem& item = plan_.items[planned.item];
    hung.description = item.description.empty() ? asset.name : item.description;
    hung.asset = asset.ref;
    hung.locked = true;  // its window stays where it is
    hung.traits.front = hung.traits.front && asset.has_front;
    if (!asset_key(asset.ref).empty()) result_.models.add(asset_key(asset.ref), *model);
    const auto candidate = layout_.candidate(hung);
    if (!layout_.fits(candidate, footprint(hung), bottom(hung)) || !layout_.fits_exactly(candidate))
      return false;
    layout_.add(std::move(hung));
    take(planned, asset);
    return true;
  }

  static std::string why_nothing(const PlanItem& item) {
    if (!item.asked || Vocabulary::built_in().understand(item.category).known)
      return "no asset is a " + item.category + " of this size";
    return "\"" + item.category + "\" is no kind that is known, and the words do not say of which parts " +
           "it is made";
  }

  // Each asset, and for the first one again with other answers, then a repair. Returns why it
  // failed, or nothing.
  std::string try_assets(const PlannedObject& planned, const std::vector<AssetInfo>& assets,
                         Json& record) {
    std::vector<std::string> refusals;
    std::optional<PlacementTask> first;
    record["attempts"] = Json::array();
    // When one of a kind found no place after all, the next ones are not worth the same pains.
    const bool brief = hopeless_items_.count(planned.item) > 0;
    const int answers = brief ? 1 : options_.answers_per_object;
    for (int answer = 0; answer < answers; ++answer) {
      const std::size_t count = answer == 0 && !brief ? assets.size() : 1;
      for (std::size_t a = 0; a < count; ++a) {
        if (options_.cancel.cancelled()) return "stopped before it was tried";
        auto task = prepare(planned, assets[a]);
        if (!task) return task.error().message;
        Json attempt;
        auto advice = ask(planned, *task, refusals);
        if (!advice) {
          if (advice.error().kind == Error::Kind::limit) result_.stopped = advice.error().message;
          return advice.error().message;
        }
        tally(advice->consultation);
        next_ = advice->next;
        attempt["asset"] = asset_key(assets[a].ref);
        attempt["answer"] = advice_json(*advice);
        if (Json asked = consultation_json(advice->consultation); !asked.is_null())
          attempt["model"] = std::move(asked);
        if (auto status = apply(*advice, planned, refusals.size(), *task); !status)
          return status.error().message;
        auto placed = place(layout_, *task, {}, options_.place, random_);
        if (!first) first = *task;
        if (placed) {
          accept(planned, assets[a], *task, *placed, attempt);
          record["attempts"].push_back(std::move(attempt));
          return "";
        }
        if (squeeze_in(*task)) {
          tasks_.push_back(*task);
          take(planned, assets[a]);
          attempt["made_room"] = true;
          record["attempts"].push_back(std::move(attempt));
          return "";
        }
        refusals.push_back(placed.error().message);
        attempt["refused"] = placed.error().message;
        record["attempts"].push_back(std::move(attempt));
      }
    }
    if (brief) return refusals.back();
    return repair(planned, assets.front(), *first, refusals.back(), record);
  }

  // Where a small thing was asked for and found no room: others there make some, and it gets smaller.
  bool squeeze_in(PlacementTask& task) {
    if (!task.asked || task.object.mount != Mount::surface) return false;
    PlacementTask smaller = task;
    for (double factor = 1.0; factor >= least_squeeze; factor *= squeeze_step) {
      if (options_.cancel.cancelled()) return false;
      smaller.object.size = factor * task.object.size;
      if (!make_room(layout_, smaller, tasks_, options_.cancel, random_)) continue;
      task = smaller;
      return true;
    }
    return false;
  }

  Result<PlaceAdvice> ask(const PlannedObject& planned, const PlacementTask& task,
                          const std::vector<std::string>& refusals) {
    const Scene scene = current_scene();
    PlaceRequest request{plan_, scene, planned, task.object, refusals};
    request.later = later();
    request.cancel = options_.cancel;
    if (!refusals.empty()) request.free_floor = free_floor();
    if (options_.renderer)
      request.marks = [&] {
        View view = options_.marks_view;
        view.free_floor = request.free_floor;
        return options_.renderer->render(scene, result_.models, view);
      };
    return designer_.place(request);
  }

  // Where there is room left, for a designer whose answer did not fit.
  std::vector<Bounds2> free_floor() const {
    const auto doors = layout_.door_areas();
    std::vector<Footprint> taken(doors.begin(), doors.end());
    for (const auto& thing : layout_.things())
      if (blocks_floor(*thing.object, *thing.category)) taken.push_back(thing.footprint);
    return free_rectangles(room_.polygon, taken, least_free_side, most_free_parts);
  }

  void tally(const Consultation& consultation) {
    ModelUse& use = result_.model_use;
    use.calls += consultation.calls;
    use.input_tokens += consultation.input_tokens;
    use.output_tokens += consultation.output_tokens;
    use.seconds += consultation.seconds;
    use.fallbacks += consultation.fell_back ? 1 : 0;
  }

  // The advice decides what carries the object or what it hangs above, and so its height.
  Status apply(const PlaceAdvice& advice, const PlannedObject& planned, std::size_t refused,
               PlacementTask& task) const {
    Object& object = task.object;
    object.relations = advice.relations;
    task.wishes = put_wishes_first(plan_.items[planned.item], object.relations);
    task.location = advice.location;
    task.facing = advice.yaw;
    if (object.mount == Mount::surface)
      return put_on_support(plan_.items[planned.item], refused, object);
    if (object.mount != Mount::wall) return {};
    for (const auto& relation : advice.relations) {
      const Object* target = layout_.find(relation.target);
      if (relation.kind != RelationKind::above || !target) continue;
      const double highest = room_.height - object.size.z() - 0.05;
      object.position.z() =
          std::min(highest, std::max(object.position.z(), top(*target) + gap_above));
    }
    return {};
  }

  // What the plan asks for, before what the designer adds; how many they are.
  static int put_wishes_first(const PlanItem& item, std::vector<Relation>& relations) {
    const auto end = std::stable_partition(
        relations.begin(), relations.end(), [&](const Relation& relation) {
          return std::find(item.relations.begin(), item.relations.end(), relation) !=
                 item.relations.end();
        });
    return item.asked ? static_cast<int>(end - relations.begin()) : 0;
  }

  // The object as the asset makes it, with its mounting height.
  Result<PlacementTask> prepare(const PlannedObject& planned, const AssetInfo& asset) {
    const PlanItem& item = plan_.items[planned.item];
    const Kind& category = categories_.get(item.category);
    auto model = library_.load(asset.ref);
    if (!model) return model.error();
    if (!asset_key(asset.ref).empty()) result_.models.add(asset_key(asset.ref), *model);
    PlacementTask task;
    Object& object = task.object;
    object.id = planned.id;
    object.category = item.category;
    object.description = item.description.empty() ? asset.name : item.description;
    object.asset = asset.ref;
    object.traits = category.traits;
    object.traits.front = category.traits.front && asset.has_front;
    object.traits.round = asset.round;
    object.size = fitted_size(asset, item, category);
    object.mount = item.mount;
    object.relations = item.relations;
    task.location = item.location;
    task.asked = item.asked;
    set_height(category, asset, object);
    return task;
  }

  // The usual height; what stands on something gets its own when that is known.
  void set_height(const Kind& category, const AssetInfo& asset, Object& object) const {
    const double room_left = room_.height - object.size.z();
    if (object.mount == Mount::ceiling) object.position.z() = room_left;
    if (object.mount == Mount::wall) {
      const double usual = category.elevation > 0 ? category.elevation : asset.elevation;
      object.position.z() = std::clamp(usual, 0.0, std::max(0.0, room_left - 0.05));
    }
  }

  Status put_on_support(const PlanItem& item, std::size_t refused, Object& object) const {
    const Object* support = nullptr;
    for (const auto& relation : object.relations)
      if (relation.kind == RelationKind::on && !support) support = layout_.find(relation.target);
    // What finds no place where it was asked for stands on something else rather than nowhere.
    if (support && item.asked && refused >= patience_with_support) support = nullptr;
    if (!support) support = find_support(item.on, object);
    if (!support)
      return Error{Error::Kind::not_found,
                   "nothing in the room can carry it" +
                       (item.on.empty() ? std::string() : " (wanted: " + item.on + ")")};
    object.on = support->id;
    if (item.asked)
      object.size *= shrink_factor(object, layout_.perches().surfaces(*support), refused);
    return {};
  }

  // The placed thing of the wanted kind, or else a table or cabinet, with the most free places; if
  // all are full, the one that could carry it, which then says why it does not.
  const Object* find_support(const std::string& wanted, const Object& object) const {
    const Object* usual = find_support(object, [&](const Object& other) {
      return other.id == wanted || could_carry(other.category, wanted);
    });
    if (usual || !wanted.empty()) return usual;
    return find_support(object, [](const Object&) { return true; });
  }

  template <typename Test>
  const Object* find_support(const Object& object, Test could_carry) const {
    const Object* best = nullptr;
    std::size_t best_room = 0;
    for (const auto& other : layout_.objects()) {
      if (!could_carry(other)) continue;
      if (layout_.perches().surfaces(other).empty()) continue;
      const std::size_t room = layout_.free_perches(object, other).size();
      if (!best || room > best_room) best = &other, best_room = room;
    }
    return best;
  }

  void accept(const PlannedObject& planned, const AssetInfo& asset, const PlacementTask& task,
              const Placement& placement, Json& attempt) {
    attempt["candidates"] = placement.candidates;
    attempt["feasible"] = placement.feasible;
    attempt["chosen"] = terms_json(placement.terms);
    if (placement.runner_up) attempt["runner_up"] = terms_json(*placement.runner_up);
    layout_.add(placement.object);
    tasks_.push_back(task);
    take(planned, asset);
  }

  void take(const PlannedObject& planned, const AssetInfo& asset) {
    retriever_.remember(plan_.items[planned.item], asset);
    assets_[planned.id] = asset;
  }

  // Neighbours make way for an object that found no place.
  std::string repair(const PlannedObject& planned, const AssetInfo& asset,
                     const PlacementTask& task, const std::string& refusal, Json& record) {
    if (layout_.find(planned.id)) return "";
    tasks_.push_back(task);
    take(planned, asset);
    reasons_[planned.id] = refusal;
    improve_all(options_.repair_rounds);
    if (layout_.find(planned.id)) {
      record["repaired"] = true;
      return "";
    }
    hopeless_items_.insert(planned.item);
    return refusal;
  }

  void improve_all(int rounds) {
    ImproveOptions improve_options;
    improve_options.place = options_.place;
    improve_options.rounds = rounds;
    improve_options.cancel = options_.cancel;
    improve(layout_, tasks_, reasons_, improve_options, random_);
  }

  Scene current_scene() const {
    Scene scene;
    scene.prompt = plan_.prompt;
    scene.seed = plan_.seed;
    scene.room = room_;
    scene.objects.assign(layout_.objects().begin(), layout_.objects().end());
    return scene;
  }

  // In the order of the plan, with coordinates as a file holds them.
  void finish(const std::vector<PlannedObject>& planned_objects) {
    Scene& scene = result_.scene;
    scene = current_scene();
    scene.objects.clear();
    scene.incomplete = has_stopped();
    std::set<std::string> seen;
    for (const auto& planned : planned_objects) {
      const PlanItem& item = plan_.items[planned.item];
      if (const Object* placed = layout_.find(planned.id)) {
        scene.objects.push_back(with_rounded_pose(*placed));
        const AssetInfo& asset = assets_.at(planned.id);
        if (seen.insert(asset_key(asset.ref)).second) result_.assets.push_back(asset);
        if (asset.approximate)
          result_.notes.push_back(planned.id + " is approximate: \"" + item.category +
                                  "\" is no kind that is known, and it was put together from the words");
      } else {
        const auto reason = reasons_.find(planned.id);
        scene.unplaced.push_back(
            {planned.id, item.category,
             reason == reasons_.end() ? "stopped before it was tried" : reason->second});
      }
    }
    scene.requirements = check_requirements(
        plan_.requirements, scene, categories_, [&](const Object& object, const std::string& word) {
          const auto verdict = judge_attribute(known_looks(object, result_.models), word);
          return verdict.held ? std::string() : "is not known to be " + word + ": " + verdict.reason;
        });
    for (const auto& task : tasks_)
      result_.constraints += static_cast<int>(task.object.relations.size());
    for (const auto& verdict : judge_scene(scene, categories_))
      result_.held += verdict.judgement.held ? 1 : 0;
    for (const auto& task : tasks_)
      if (const Object* placed = layout_.find(task.object.id)) compare(task, *placed);
  }

  // How far the object ended from where it was suggested.
  void compare(const PlacementTask& task, const Object& placed) {
    SuggestionFigures& figures = result_.suggestions;
    if (task.location) {
      const double distance = (placed.position.head<2>() - *task.location).norm();
      ++figures.located;
      figures.within_half += distance <= 0.5 ? 1 : 0;
      figures.within_one += distance <= 1.0 ? 1 : 0;
    }
    if (task.facing) {
      ++figures.faced;
      figures.facing_kept +=
          std::abs(wrap_angle(placed.yaw - *task.facing)) <= facing_tolerance ? 1 : 0;
    }
  }

  const Plan& plan_;
  Designer& designer_;
  const AssetLibrary& library_;
  const KindTable& categories_;
  const GenerateOptions& options_;
  Retriever retriever_;
  Random random_;
  Generation result_;
  Room room_;  ///< the plan's, with meshes in its openings
  Layout layout_;
  std::vector<PlannedObject> left_;                ///< still to be tried, in the plan's order
  std::string next_;                               ///< of them, what the designer wants next
  std::vector<PlacementTask> tasks_;               ///< of all objects that have an asset, in order
  std::map<std::string, std::string> reasons_;     ///< why objects are not in the layout
  std::set<std::size_t> hopeless_items_;           ///< of which one found no place
  std::map<std::string, AssetInfo> assets_;        ///< by object
};

}  // namespace

Result<Generation> generate(const Plan& plan, Designer& designer, const AssetLibrary& library,
                            const KindTable& categories, const GenerateOptions& options) {
  if (auto status = options.place.validate(); !status) return status.error();
  return Generator(plan, designer, library, categories, options).run();
}

}  // namespace roomgen
