#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "database.h"
#include "roomgen/assets/catalogue.h"
#include "roomgen/library/library.h"

namespace roomgen::assets {

/// One row of the catalogue: what a search needs, and where the mesh is.
struct IndexedAsset {
  AssetInfo info;
  std::string mesh;  ///< file in the library's tree
  Eigen::Matrix3d ours_from_source = Eigen::Matrix3d::Identity();
  std::string looks;  ///< words for colours and materials, for the text index only
};

/// Writes the catalogue of one library to a new file. `stamp` says what it was made from.
Status write_index(const std::filesystem::path& path, const std::string& stamp,
                   const std::vector<IndexedAsset>& assets, const std::vector<LeftOutMesh>& left_out);

/// The meshes that the catalogue of `library` had to leave out.
Result<std::vector<LeftOutMesh>> read_left_out(const Database& database, const std::string& library);

/// The stamp of a catalogue; empty if there is none or it is not readable.
std::string read_stamp(const std::filesystem::path& path);

/// The columns of a row, for "SELECT <columns> FROM assets …" and row_of().
extern const char* const row_columns;
IndexedAsset row_of(const Statement& statement);

}  // namespace roomgen::assets
