#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen::design {

/// What a text means by the name of a target.
struct NamedTarget {
  std::string id;      ///< empty if there is none
  std::string repair;  ///< how the name was understood, or why it was not; empty for the id itself
};

/// The things and parts of a room that a relation of an object can name, under all spellings that
/// mean just one of them.
class TargetNames {
 public:
  TargetNames(const Scene& scene, const Object& object, const KindTable& categories);

  NamedTarget find(std::string_view name) const;
  /// The id that these words spell, case and separators aside; empty if none.
  std::string spelt(const std::vector<std::string>& words) const;
  /// True if the words are the id of the object itself.
  bool is_self(const std::vector<std::string>& words) const;

 private:
  struct Entry {
    std::string id;
    std::string base;    ///< "coffee table"
    std::string number;  ///< "0"; empty for "corner"
    bool thing = false;   ///< no part of the room
    bool region = false;  ///< must be spelt as it is: "north wall" is no "north-half"
  };

  void add(const std::string& id, bool thing);
  // Of this number if one is given.
  using Entries = std::vector<const Entry*>;
  Entries of_base(const std::string& base, const std::string& number) const;
  Entries of_kind(const std::string& base, const std::string& number) const;
  Entries misspelt(const std::string& base, const std::string& number) const;

  const KindTable& categories_;
  std::vector<Entry> entries_;
  std::vector<std::string> self_;
};

}  // namespace roomgen::design
