#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/kinds/mount.h"

namespace roomgen {

/// What a data file says about a kind of thing apart from how it is made or what it needs.
struct KindRecord {
  std::string name;                ///< "test tube rack"
  std::string parent;              ///< "is": every one of it is one of these too; may be empty
  std::vector<std::string> names;  ///< what people call it besides
  std::optional<Vec3> size;        ///< usual width, depth, height in metres
  std::optional<Mount> mount;
};

/// The "kinds" of a file of data/shapes/kinds, or of data/vocabulary.json, in the file's order. What
/// else the file says of them is passed over, so that this takes a fraction of reading it all.
Result<std::vector<KindRecord>> read_kind_records(std::string_view text, const std::string& source);

/// Those of all files of data/shapes/kinds that are compiled in: what can be built.
Result<std::vector<KindRecord>> shape_kind_records();

}  // namespace roomgen
