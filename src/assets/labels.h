#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/scene/object.h"

namespace roomgen::assets {

/// What a person who looked at an asset says about it, where its library says nothing or too
/// little.
struct Label {
  std::string category;  ///< a kind of the vocabulary
  std::vector<std::string> tags;
  std::optional<bool> front;
  std::optional<bool> round;
  std::optional<Mount> mount;
  bool unsteady = false;  ///< does not stand by itself as its mesh is: left out of the catalogue
};

/// data/furniture-labels.json: library, then asset id, to "category | tag tag | trait trait".
/// Traits are: round, frontless, unsteady, and the mounts.
class Labels {
 public:
  static Result<Labels> parse(std::string_view text, const std::string& source);
  static const Labels& built_in();

  /// Null if nobody labelled it.
  const Label* find(const std::string& library, const std::string& id) const;
  const std::map<std::string, Label>& all() const { return labels_; }

 private:
  std::map<std::string, Label> labels_;  ///< by "library/id"
};

}  // namespace roomgen::assets
