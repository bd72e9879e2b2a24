#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "collision/solids.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/scene.h"
#include "solve/layout.h"

namespace roomgen {

/// What the edits of a session work with: the meshes, and a layout for each room, which stay from one edit to
/// the next for what they remember of meshes. `library` and `kinds` must outlive it.
class Workshop {
 public:
  Workshop(const AssetLibrary& library, const KindTable& kinds, SpareModels spare, LogSink log)
      : library_(library), kinds_(kinds), spare_(std::move(spare)), log_(std::move(log)), solids_(models_) {}
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const AssetLibrary& library() const { return library_; }
  const KindTable& kinds() const { return kinds_; }
  const ModelTable& models() const { return models_; }

  /// Reads the meshes of a scene that are not there yet.
  void fetch_models(const Scene& scene);
  /// The mesh of one asset; null for a plain box.
  Result<std::shared_ptr<const Model>> fetch_model(const AssetRef& asset);

  /// Width, depth and height of a mesh as it is; nothing of a plain box.
  std::optional<Vec3> mesh_size(const AssetRef& asset);
  /// What shares space with what, remembered from one edit to the next.
  Solids& solids() { return solids_; }

  /// The room of this id (empty: the only one) with its objects in the scene's order, but for some.
  Layout& layout(const Scene& scene, const std::string& room, const std::set<std::string>& without = {});

 private:
  struct FurnishedRoom {
    FurnishedRoom(const Room& the_room, const KindTable& kinds, const ModelTable& models);
    Room room;
    Layout layout;
  };

  const AssetLibrary& library_;
  const KindTable& kinds_;
  SpareModels spare_;
  LogSink log_;
  ModelTable models_;
  std::map<std::string, std::unique_ptr<FurnishedRoom>> rooms_;
  Solids solids_;
  std::map<const Model*, Vec3> mesh_sizes_;
  std::set<std::string> missing_;  ///< assets that nobody has: their objects stay boxes
};

}  // namespace roomgen
