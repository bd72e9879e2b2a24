#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/scene/relation.h"

namespace roomgen::brief {

/// Who lives or comes somewhere, or what happens there, and what things that means.
struct Occupant {
  struct Thing {
    std::string kind;
    int count = 0;      ///< 0: not said
    bool each = false;  ///< one for each person
    std::optional<RelationKind> relation;
    std::string to;  ///< a kind of the same occupant; none for edge and corner
    bool always = true;  ///< else only where the kind of room brings none
  };

  std::string name;
  bool is_of_nothing = false;  ///< "the boys play", but not "an old man plays chess"
  bool is_activity = false;
  int count = 1;  ///< persons that the word means where no number is said
  double clearance = 0.0;  ///< metres that ways must be wide; 0: as usual
  std::vector<Thing> things;  ///< the first is the one without which the word is empty
};

/// data/occupants.json; docs/requirements.md explains it.
class Occupants {
 public:
  static Result<Occupants> parse(std::string_view text, const std::string& source);
  static const Result<Occupants>& built_in();

  /// By a name in the singular, or the base or -ing form of a verb; null if there is none.
  const Occupant* find(std::string_view name) const;
  /// Whether what people need belongs into that kind of room; activities happen where they are told.
  bool belongs(const std::string& kind, const std::string& room_type) const;
  const std::map<std::string, Occupant, std::less<>>& all() const { return occupants_; }

 private:
  std::map<std::string, Occupant, std::less<>> occupants_;
  std::map<std::string, std::string, std::less<>> names_;
  std::map<std::string, std::vector<std::string>, std::less<>> where_;
};

/// Words of the longest name.
inline constexpr std::size_t longest_occupant_name = 3;

}  // namespace roomgen::brief
