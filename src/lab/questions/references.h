#pragma once

#include <optional>
#include <string>
#include <vector>

#include "appearances.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen::lab::detail {

/// Words that mean one object of the scene and no other.
struct Reference {
  std::size_t object = 0;
  std::string text;       ///< "the red chair"
  bool by_time = false;   ///< says when it comes into sight
  bool any_twin = false;  ///< means any of several that are alike
  std::string way;        ///< "kind", "color", "on", "nearest", "tallest", "lowest", "first seen", "twin"
  std::string other;      ///< id of a second object that the words name
};

/// What is known of a scene for telling its things apart.
class References {
 public:
  References(const Scene& scene, const ModelTable& models, const KindTable& kinds,
             const std::vector<Appearance>& appearances);

  /// By kind alone, else by colour, by what it stands on, by what it is near, by height, by time; nothing if no
  /// words mean it alone, if it cannot be seen well or stands in for what nobody has a model of.
  const std::optional<Reference>& of(std::size_t object) const { return references_[object]; }
  /// Those of all objects that have one and do not speak of time.
  std::vector<const Reference*> all() const;
  /// Any of several that are alike, where of() has nothing; for what holds of all of them.
  std::optional<Reference> twin(std::size_t object) const;

  /// The colour of most of it, if one colour is most of it; or empty.
  const std::string& color(std::size_t object) const { return colors_[object]; }
  /// Everything that people may call by the kind of this object.
  std::vector<std::size_t> rivals(std::size_t object) const;
  /// Is what is called `kind` surely no more than objects of that kind or below it?
  bool is_settled(const std::string& kind) const;

 private:
  std::optional<Reference> find(std::size_t object) const;
  std::optional<Reference> by_kind(std::size_t object) const;
  std::optional<Reference> by_color(std::size_t object, const std::vector<std::size_t>& others) const;
  std::optional<Reference> by_carrier(std::size_t object, const std::vector<std::size_t>& others) const;
  std::optional<Reference> by_neighbour(std::size_t object, const std::vector<std::size_t>& others) const;
  std::optional<Reference> by_height(std::size_t object, const std::vector<std::size_t>& others) const;
  std::optional<Reference> by_time(std::size_t object, const std::vector<std::size_t>& others) const;
  Reference reference(std::size_t object, const std::string& way, const std::string& words,
                      const std::string& color = "", std::optional<std::size_t> other = {}) const;
  bool may_be_asked_about(std::size_t object) const;

  const Scene& scene_;
  const KindTable& kinds_;
  const std::vector<Appearance>& appearances_;
  std::vector<std::string> colors_;
  std::vector<std::optional<Reference>> plain_, references_;
};

}  // namespace roomgen::lab::detail
