#include "exhaustive.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "generate/asset_task.h"
#include "generate/fits_as_it_is.h"
#include "generate/retrieve.h"
#include "roomgen/evaluate/report.h"
#include "scene/judgement.h"
#include "solve/fit_rugs.h"
#include "solve/layout.h"

namespace roomgen::bench {

namespace {

constexpr double pitch = 0.05;        // metres
constexpr double slack = 0.5;         // that what stays where it is may give way
constexpr double slack_on_top = 1.0;  // and what stands on it
constexpr double same_spot = 0.05;
constexpr std::size_t between_samples = 37, most_samples = 10;  // of poses that are refused
constexpr int most_assets = 3;
constexpr std::size_t most_alternatives = 12;

/// Where one thing and what it carries may go.
struct Question {
  Object root;
  std::vector<Object> carried;      ///< moves along, or is set up anew
  bool sets_up_anew = false;        ///< what it carries, on a thing that is another one now
  std::vector<Relation> relations;  ///< that must hold in the end
  std::optional<Pose> about;        ///< within `most_off` of it
  double most_off = 0.0;
  bool keeps_yaw = false;           ///< that of `about`
  bool may_stand_on_edges = false;  ///< of rugs
  std::vector<std::string> carriers;  ///< of what stands on others; empty: any
};

std::vector<Object> load_of(const Scene& scene, const std::string& id) {
  std::vector<Object> load;
  std::set<std::string> carriers = {id};
  for (std::size_t before = 0; before != carriers.size();) {
    before = carriers.size();
    for (const auto& object : scene.objects)
      if (carriers.count(object.on) && carriers.insert(object.id).second) load.push_back(object);
  }
  return load;
}

Object along(const Object& object, const Object& root_before, const Object& root) {
  const double turn = wrap_angle(root.yaw - root_before.yaw);
  const Vec2 offset = object.position.head<2>() - root_before.position.head<2>();
  const Vec2 at = root.position.head<2>() + rotated(offset, turn);
  return at_pose(object, {at, object.position.z() + root.position.z() - root_before.position.z(),
                          wrap_angle(object.yaw + turn)});
}

std::set<std::string> faults_of(const Scene& scene, const ModelTable& models) {
  std::set<std::string> faults;
  for (const auto& one : examine(scene, models, KindTable::built_in()).violations)
    faults.insert(std::string(name(one.fault)) + " " + one.object + " " + one.other);
  return faults;
}

/// One room without what is to be moved, and every pose in it.
class Poses {
 public:
  Poses(const Scene& scene, const ModelTable& models, const Question& question)
      : scene_(scene), models_(models), question_(question), room_(room_of(scene, question.root)),
        layout_(room_, KindTable::built_in(), models) {
    std::set<std::string> away = {question.root.id};
    for (const auto& object : question.carried) away.insert(object.id);
    for (const auto& object : scene.objects)
      if (object.room == question.root.room && !away.count(object.id)) layout_.add(object);
    Object asked = question.root;
    asked.relations = question.relations;
    relations_ = resolve(asked, room_, layout_.objects(), KindTable::built_in());
  }

  std::optional<std::vector<Object>> first_valid() {
    std::optional<std::vector<Object>> found;
    visit([&](const Object& root) { return (found = valid(root)).has_value(); });
    return found;
  }

  /// Some of the poses that were refused though they fit by their boxes.
  const std::vector<Object>& refused() const { return refused_; }

 private:
  using Visitor = std::function<bool(const Object&)>;  // true ends it

  void visit(const Visitor& visitor) {
    if (question_.about && question_.most_off == 0.0) {
      visitor(at_pose(question_.root, *question_.about));
      return;
    }
    switch (question_.root.mount) {
      case Mount::wall: return visit_walls(visitor);
      case Mount::surface: return visit_carriers(visitor);
      default: return visit_grid(visitor);
    }
  }

  std::vector<double> yaws() const {
    if (question_.keeps_yaw) return {question_.about->yaw};
    return {layout_.wall_yaws().begin(), layout_.wall_yaws().end()};
  }

  void visit_grid(const Visitor& visitor) {
    Bounds2 box = bounds(room_.polygon);
    Vec2 origin = box.low;
    if (question_.about) {
      origin = question_.about->position;
      box.low = origin.array() - question_.most_off, box.high = origin.array() + question_.most_off;
    }
    const double bottom = question_.root.mount == Mount::ceiling ? question_.root.position.z() : 0.0;
    const auto first = [&](int axis) { return static_cast<int>(std::ceil((box.low[axis] - origin[axis]) / pitch - 1e-9)); };
    const auto last = [&](int axis) { return static_cast<int>(std::floor((box.high[axis] - origin[axis]) / pitch + 1e-9)); };
    for (int i = first(0); i <= last(0); ++i)
      for (int j = first(1); j <= last(1); ++j)
        for (const double yaw : yaws())
          if (visitor(at_pose(question_.root, {origin + pitch * Vec2(i, j), bottom, yaw}))) return;
  }

  void visit_walls(const Visitor& visitor) {
    const double highest = room_.height - question_.root.size.z();
    for (std::size_t wall = 0; wall < room_.polygon.size(); ++wall) {
      const Segment line = room_.polygon.edge(wall);
      const Vec2 inward = room_.polygon.inward(wall);
      const Vec2 step = (line.b - line.a).normalized() * pitch;
      for (double at = 0.0; at <= (line.b - line.a).norm(); at += pitch)
        for (double bottom = 0.0; bottom <= highest + 1e-9; bottom += pitch)
          if (visitor(at_pose(question_.root, {line.a + step * (at / pitch) + 0.5 * question_.root.size.y() * inward, bottom,
                                               yaw_facing(inward)})))
            return;
    }
  }

  void visit_carriers(const Visitor& visitor) {
    const std::vector<Object> carriers(layout_.objects().begin(), layout_.objects().end());
    for (const auto& carrier : carriers) {
      const auto& wanted = question_.carriers;
      if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), carrier.id) == wanted.end()) continue;
      Object root = question_.root;
      root.on = carrier.id;
      for (const auto& pose : layout_.free_support_poses(root, carrier))
        if (visitor(at_pose(root, pose))) return;
    }
  }

  bool is_about(const Object& root) const {
    if (!question_.about) return true;
    return (root.position.head<2>() - question_.about->position).norm() <= question_.most_off + 1e-9 &&
           (!question_.keeps_yaw || std::abs(wrap_angle(root.yaw - question_.about->yaw)) < 0.02);
  }

  bool relations_hold(const Object& root) const {
    for (std::size_t i = 0; i < relations_.size(); ++i) {
      const Relation& asked = question_.relations[i];
      if (asked.kind == RelationKind::on ? root.on != asked.target
                                         : !judge(relations_[i], {footprint(root), bottom(root), top(root)}, room_).held)
        return false;
    }
    return true;
  }

  // At the height of the rug under it; nothing if it were on the edge of one.
  std::optional<Object> on_rugs(Object root) const {
    if (root.mount != Mount::floor) return root;
    double height = 0.0;
    for (const auto& other : layout_.objects()) {
      const bool is_rug = other.traits.flat && other.mount == Mount::floor;
      if (is_rug == root.traits.flat || other.mount != Mount::floor) continue;
      Object thing = root.traits.flat ? other : root;
      thing.position.z() = 0.0;
      const auto stand = stand_to_rug(thing, root.traits.flat ? root : other, models_);
      if (stand == RugStand::partly && !question_.may_stand_on_edges) return std::nullopt;
      if (stand == RugStand::on && is_rug) height = std::max(height, top(other));
    }
    root.position.z() = height;
    return root;
  }

  std::optional<std::vector<Object>> valid(const Object& pose) {
    if (!is_about(pose) || !relations_hold(pose)) return std::nullopt;
    if (!layout_.fits(layout_.candidate(pose), footprint(pose), bottom(pose))) return std::nullopt;
    const auto root = on_rugs(pose);
    if (!root) return std::nullopt;
    if (!fits_as_it_is(layout_, *root)) {
      if (refusals_++ % between_samples == 0) refused_.push_back(*root);
      return std::nullopt;
    }
    std::vector<Object> all = {*root};
    layout_.add(*root);
    const bool whole = question_.sets_up_anew ? set_up(all) : take_along(all);
    for (const auto& object : all) layout_.remove(object.id);
    return whole ? std::optional(all) : std::nullopt;
  }

  bool take_along(std::vector<Object>& all) {
    const Object root = all.front();
    for (const auto& object : question_.carried) {
      const Object moved = along(object, question_.root, root);
      if (!fits_as_it_is(layout_, moved)) return false;
      layout_.add(moved);
      all.push_back(moved);
    }
    return true;
  }

  bool set_up(std::vector<Object>& all) {
    for (const auto& object : question_.carried) {
      const auto* carrier = layout_.find(object.on);
      const Object carried_by = *carrier;
      const auto places = layout_.free_support_poses(object, carried_by);
      const auto fitting = std::find_if(places.begin(), places.end(), [&](const Pose& place) {
        return (place.position - object.position.head<2>()).norm() <= slack_on_top + slack &&
               fits_as_it_is(layout_, at_pose(object, place));
      });
      if (fitting == places.end()) return false;
      layout_.add(at_pose(object, *fitting));
      all.push_back(at_pose(object, *fitting));
    }
    return true;
  }

  const Scene& scene_;
  const ModelTable& models_;
  const Question& question_;
  Room room_;
  Layout layout_;
  std::vector<ResolvedRelation> relations_;
  std::vector<Object> refused_;
  std::size_t refusals_ = 0;
};

/// The questions that an edit comes down to: one of them is enough.
class Questions {
 public:
  Questions(const Scene& scene, ModelTable& models, const AssetLibrary& library)
      : scene_(scene), models_(models), library_(library) {}

  std::vector<Question> of(const edit::Operation& operation) {
    return std::visit([&](const auto& one) { return of(one); }, operation);
  }

 private:
  template <typename Other>
  std::vector<Question> of(const Other&) {
    return {};
  }

  Question about(const std::string& id, double most_off) const {
    Question question;
    question.root = *find_object(scene_, id);
    question.carried = load_of(scene_, id);
    question.about = Pose{question.root.position.head<2>(), question.root.position.z(), question.root.yaw};
    question.most_off = most_off;
    question.keeps_yaw = true;
    if (question.root.mount == Mount::surface) question.carriers = {question.root.on};
    return question;
  }

  static std::vector<std::string> said_carriers(const std::vector<Relation>& relations) {
    std::vector<std::string> carriers;
    for (const auto& relation : relations)
      if (relation.kind == RelationKind::on) carriers.push_back(relation.target);
    return carriers;
  }

  void keep_mesh(const AssetRef& asset) {
    if (auto model = library_.load(asset)) models_.add(asset_key(asset), *model);
  }

  Object made_of(const AssetInfo& asset, PlanItem item, const std::string& id, const Kind& kind, const Room& room) {
    keep_mesh(asset.ref);
    const auto model = models_.find(asset_key(asset.ref));
    return task_of_asset(id, item, kind, asset, model.get(), room).object;
  }

  std::vector<Question> of(const edit::Add& add) {
    const KindTable& kinds = KindTable::built_in();
    const bool rests = !said_carriers(add.relations).empty();
    const Kind* kind = &kinds.get(add.category);
    if (rests && kind->mount != Mount::surface && !kind->forms.small.empty())
      if (const Kind* small = kinds.by_name(kind->forms.small)) kind = &kinds.planned(*small);
    PlanItem item;
    item.category = kind->name;
    item.description = add.description.empty() ? add.category : add.description;
    item.mount = rests ? Mount::surface : kind->mount;
    item.asked = true;
    const auto assets = retrieve({library_, kinds, scene_.seed}, {}, item, {"newcomer", 0, 0}, most_assets);
    std::vector<Question> questions;
    for (const auto& asset : assets ? *assets : std::vector<AssetInfo>()) {
      Question question;
      question.root = made_of(asset, item, "newcomer", *kind, scene_.room);
      question.relations = add.relations;
      question.carriers = said_carriers(add.relations);
      questions.push_back(std::move(question));
    }
    return questions;
  }

  std::vector<Question> of(const edit::Move& move) {
    Question question = about(move.object, 0.0);
    question.about.reset();
    question.keeps_yaw = false;
    question.relations = move.relations;
    question.carriers = said_carriers(move.relations);
    return {question};
  }

  std::vector<Question> of(const edit::Put& put) {
    Question question = about(put.object, question_slack(put.object));
    question.about->position = put.position;
    question.about->yaw = put.yaw.value_or(question.about->yaw);
    question.may_stand_on_edges = true;
    return {question};
  }
  double question_slack(const std::string& id) const {
    return find_object(scene_, id)->mount == Mount::surface ? same_spot : 0.0;
  }

  std::vector<Question> of(const edit::Shift& shift) {
    const Object& object = *find_object(scene_, shift.object);
    return of(edit::Put{shift.object, Vec2(object.position.head<2>() + shift.by.head<2>()), object.yaw, object.on});
  }

  // There, as near as there is room, or there on the edge of a rug.
  std::vector<Question> turned(const std::string& id, double yaw, const std::vector<Relation>& relations) {
    Question question = about(id, slack);
    question.about->yaw = yaw;
    question.relations = relations;
    Question exactly = question;
    exactly.most_off = 0.0;
    exactly.may_stand_on_edges = true;
    return {exactly, question};
  }

  std::vector<Question> of(const edit::Turn& turn) {
    return turned(turn.object, wrap_angle(find_object(scene_, turn.object)->yaw + turn.by), {});
  }

  std::vector<Question> of(const edit::Face& face) {
    const Object& one = *find_object(scene_, face.object);
    const Object* target = find_object(scene_, face.target);
    if (!target) return {};
    std::vector<double> yaws = {yaw_facing(target->position.head<2>() - one.position.head<2>())};
    const ModelTable none;
    const Layout layout(room_of(scene_, one), KindTable::built_in(), none);
    yaws.insert(yaws.end(), layout.wall_yaws().begin(), layout.wall_yaws().end());
    std::vector<Question> questions;
    for (const double yaw : yaws)
      for (auto& question : turned(face.object, yaw, {{RelationKind::face_to, face.target}}))
        questions.push_back(std::move(question));
    return questions;
  }

  Question changed(const Object& object) {
    Question question = about(object.id, slack);
    question.root = object;
    question.sets_up_anew = true;
    return question;
  }

  std::vector<Question> of(const edit::Resize& resize) {
    Object object = *find_object(scene_, resize.object);
    object.size = resize.size;
    const auto model = models_.find(asset_key(object.asset));
    if (model && object.traits.round) object.traits.round = keeps_to_ellipse(*model, object.size);
    return {changed(object)};
  }

  std::vector<Question> of(const edit::Replace& replace) {
    const Object& object = *find_object(scene_, replace.object);
    AssetQuery query;
    query.category = query.description = object.category;
    query.size = object.size;
    query.mount = object.mount;
    query.asked = true;
    query.limit = most_alternatives;
    const auto matches = library_.search(query);
    std::vector<Question> questions;
    for (const auto& match : matches ? *matches : std::vector<AssetMatch>()) {
      if (match.asset.ref.library == object.asset.library && match.asset.ref.id == object.asset.id &&
          match.asset.ref.procedural == object.asset.procedural)
        continue;
      PlanItem item;
      item.category = object.category;
      item.description = object.description;
      item.mount = object.mount;
      item.asked = true;
      Object made = made_of(match.asset, item, object.id, KindTable::built_in().get(object.category), room_of(scene_, object));
      made.position = object.position, made.yaw = object.yaw, made.on = object.on, made.room = object.room;
      questions.push_back(changed(made));
    }
    return questions;
  }

  const Scene& scene_;
  ModelTable& models_;
  const AssetLibrary& library_;
};

void put(const Object& object, Scene& scene) {
  if (Object* there = find_object(scene, object.id)) *there = object;
  else scene.objects.push_back(object);
}

std::optional<Scene> without(const Scene& scene, const std::vector<std::string>& ids) {
  std::set<std::string> gone(ids.begin(), ids.end());
  for (const auto& id : ids)
    for (const auto& object : load_of(scene, id)) gone.insert(object.id);
  Scene after = scene;
  std::erase_if(after.objects, [&](const Object& object) { return gone.count(object.id) > 0; });
  return after;
}

}  // namespace

ExhaustiveCheck::ExhaustiveCheck(const Scene& scene, const ModelTable& models, const AssetLibrary& library)
    : scene_(scene), models_(models), library_(library) {}

std::optional<Scene> ExhaustiveCheck::possible(const edit::Operation& operation) {
  if (const auto* remove = std::get_if<edit::Remove>(&operation)) return without(scene_, remove->objects);
  for (const auto& question : Questions(scene_, models_, library_).of(operation)) {
    Poses poses(scene_, models_, question);
    const auto objects = poses.first_valid();
    if (objects && brings_no_fault(*objects)) return with(*objects);
    for (std::size_t i = 0; i < std::min(most_samples, poses.refused().size()) && question.carried.empty(); ++i) {
      ++sampled_;
      if (brings_no_fault({poses.refused()[i]})) ++too_strict_;
    }
  }
  return std::nullopt;
}

Scene ExhaustiveCheck::with(const std::vector<Object>& objects) const {
  Scene after = scene_;
  for (const auto& object : objects) put(object, after);
  return after;
}

bool ExhaustiveCheck::brings_no_fault(const std::vector<Object>& objects) const {
  const auto before = faults_of(scene_, models_), now = faults_of(with(objects), models_);
  return std::includes(before.begin(), before.end(), now.begin(), now.end());
}

}  // namespace roomgen::bench
