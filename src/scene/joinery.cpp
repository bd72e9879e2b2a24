#include "joinery.h"

#include "wall_builder.h"

namespace roomgen::detail {

namespace {

// A coordinate that is mapped piece by piece: where it goes, and how much it is stretched there.
struct Mapped {
  double value;
  double scale;
};

// From metres behind the front of the mesh to metres behind the wall's face that it looks out of.
Mapped depth_in_wall(double behind_front, const Joinery& joinery) {
  const double in_wall = joinery.wall_back - joinery.wall_front;
  if (behind_front < joinery.wall_front) return {behind_front - joinery.wall_front, 1.0};
  if (behind_front > joinery.wall_back)
    return {wall_thickness + behind_front - joinery.wall_back, 1.0};
  const double scale = wall_thickness / in_wall;
  return {scale * (behind_front - joinery.wall_front), scale};
}

// Maps the model's coordinates to the wall's.
class Fitting {
 public:
  /// The `index`-th of those side by side.
  Fitting(const Room& room, const Opening& opening, const Bounds3& box, int index)
      : frame_(wall_frame(room, opening.wall)),
        opening_(opening),
        box_(box),
        width_scale_(opening.width() / opening.joinery.side_by_side / box.size().x()),
        middle_(opening.from + opening.width() * (index + 0.5) / opening.joinery.side_by_side),
        height_scale_((opening.head - opening.sill) / box.size().z()),
        // Seen from its front the mesh's +x is at the right, which is towards `from` in the room.
        outward_front_(opening.type != OpeningType::window && opening.swing == DoorSwing::out),
        along_((outward_front_ ? 1.0 : -1.0) * (opening.joinery.mirrored ? -1.0 : 1.0)) {}

  Mesh map(Mesh mesh) const {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      map(mesh.positions[i], i < mesh.normals.size() ? &mesh.normals[i] : nullptr);
    if (opening_.joinery.mirrored)
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
  }

 private:
  void map(Eigen::Vector3f& position, Eigen::Vector3f* normal) const {
    const Vec3 p = position.cast<double>();
    const Mapped depth = depth_in_wall(p.y() - box_.low.y(), opening_.joinery);
    const double s = middle_ + along_ * width_scale_ * (p.x() - box_.center().x());
    const double d = outward_front_ ? wall_thickness - depth.value : depth.value;
    const double z = opening_.sill + height_scale_ * (p.z() - box_.low.z());
    position = frame_.at(s, d, z).cast<float>();
    if (!normal) return;
    const Vec3 n = normal->cast<double>();
    const double across = (outward_front_ ? -1.0 : 1.0) * n.y() / depth.scale;
    const Vec2 level = along_ * n.x() / width_scale_ * frame_.along + across * frame_.outward;
    const Vec3 turned(level.x(), level.y(), n.z() / height_scale_);
    if (turned.norm() > 1e-12) *normal = turned.normalized().cast<float>();
  }

  WallFrame frame_;
  const Opening& opening_;
  Bounds3 box_;
  double width_scale_, middle_, height_scale_;
  bool outward_front_;
  double along_;
};

}  // namespace

std::shared_ptr<const Model> joinery_to_show(const Opening& opening, double height,
                                             const ShellOptions& options,
                                             const ModelTable& models) {
  const bool wanted = opening.type == OpeningType::window
                          ? options.window_frames
                          : options.door_frames && has_leaves(opening, options);
  if (!wanted || height < opening.head - 1e-6) return nullptr;
  const std::string key = asset_key(opening.joinery.asset);
  auto model = key.empty() ? nullptr : models.find(key);
  const bool has_size = model && !model->parts.empty() && bounds(*model).size().minCoeff() > 1e-6;
  return has_size ? model : nullptr;
}

Model fitted_joinery(const Room& room, const Opening& opening, const Model& model) {
  const Bounds3 box = bounds(model);
  Model fitted{{}, model.materials, {}};
  for (int i = 0; i < opening.joinery.side_by_side; ++i) {
    const Fitting fitting(room, opening, box, i);
    for (const auto& part : model.parts)
      fitted.parts.push_back({fitting.map(part.mesh), part.material});
  }
  return fitted;
}

}  // namespace roomgen::detail
