#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/room_shell.h"
#include "view/camera.h"

namespace roomgen::detail {

/// Are coordinate marks drawn over the picture?
bool is_marked(const View& view);

/// The rooms themselves as a view shows them, part by part; names are those of layer_things().
std::vector<ShellPart> shown_shell(std::span<const Room> rooms, const ModelTable& models, const View& view,
                                   const Camera& camera);
/// Equal for equal shells.
std::string shell_key(std::span<const Room> rooms, const View& view, const Camera& camera);

/// Which objects the view shows.
std::function<bool(const Object&)> shown_objects(const Scene& scene, const View& view, const Camera& camera);

/// All parts as one model.
std::shared_ptr<const Model> merged(std::vector<ShellPart> parts);

}  // namespace roomgen::detail
