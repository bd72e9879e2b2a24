#include "hand_edits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "roomgen/base/text.h"
#include "scene/box_model.h"

namespace roomgen {

namespace {

// Files keep single precision, and programs round.
constexpr double same_place = 2e-3;  // metres
constexpr double noticed_turn = 2e-3;    // radians
constexpr double same_scale = 2e-3;  // share
constexpr double upright = 1e-2;     // of a unit vector

/// Where a node puts a thing, if that is a place where things can be.
struct Placed {
  edit::Arrange::Spot spot;
  bool has_changed = false;
};

Result<Placed> placed_by(const SceneNode& node, const Object& object, const Bounds3& box) {
  const auto cannot_be = [&](const std::string& why) {
    return Error{Error::Kind::invalid_input, object.id + " " + why};
  };
  const Eigen::Matrix3d linear = node.to_room.topLeftCorner<3, 3>();
  if (!node.to_room.allFinite()) return cannot_be("has no finite transform");
  const Vec3 scale = linear.colwise().norm();
  if (scale.minCoeff() < 1e-6) return cannot_be("is scaled to nothing");
  Eigen::Matrix3d turn = linear;
  for (int axis = 0; axis < 3; ++axis) turn.col(axis) /= scale[axis];
  if ((turn.transpose() * turn - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > upright)
    return cannot_be("is sheared");
  if (turn.determinant() < 0.0) return cannot_be("is mirrored");
  if (turn(2, 2) < 1.0 - upright) return cannot_be("is tilted; things stand upright");
  const Vec3 middle = 0.5 * (box.low + box.high);
  const Vec3 bottom = (node.to_room * Eigen::Vector4d(middle.x(), middle.y(), box.low.z(), 1.0)).head<3>();
  Placed placed;
  placed.spot = {object.id, bottom, std::atan2(turn(1, 0), turn(0, 0)), {}};
  const Vec3 size = scale.cwiseProduct(box.high - box.low);
  const bool is_resized =
      ((size - object.size).array() / object.size.array().max(1e-3)).abs().maxCoeff() > same_scale &&
      (size - object.size).cwiseAbs().maxCoeff() > same_place;
  if (is_resized) placed.spot.size = size;
  placed.has_changed = is_resized || (bottom - object.position).norm() > same_place ||
                       std::abs(wrap_angle(placed.spot.yaw - object.yaw)) > noticed_turn;
  return placed;
}

}  // namespace

Result<HandEdits> read_hand_edits(const Scene& scene, const ModelTable& models, std::span<const SceneNode> nodes) {
  const auto matched = match_nodes(scene, nodes);
  if (!matched) return matched.error();
  HandEdits edits;
  for (const auto& copy : matched->copies)
    edits.notes.push_back(copy.name + " is a copy of " + copy.of +
                          " and is left out; add it with \"add ...\"");
  edit::Arrange arrange;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const SceneNode* node = matched->nodes[i];
    if (!node) {
      edits.missing.push_back(object.id);
      continue;
    }
    auto placed = placed_by(*node, object, bounds(*model_or_box(object, models)));
    if (!placed) edits.notes.push_back(placed.error().message + "; it stays as it was");
    else if (placed->has_changed) arrange.spots.push_back(std::move(placed->spot));
  }
  if (edits.missing.size() == scene.objects.size() && !scene.objects.empty())
    return Error{Error::Kind::invalid_input,
                 "no node is called as a thing of the scene, or has its \"id\" in its extras; "
                 "nodes keep the names of scene.glb"};
  if (!arrange.spots.empty()) edits.operations.push_back(std::move(arrange));
  return edits;
}

}  // namespace roomgen
