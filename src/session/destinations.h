#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit_text.h"
#include "references.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// Where words say that something is or shall go.
struct Whereabouts {
  std::vector<Relation> relations;  ///< "next to the bed"
  std::size_t end = 0;              ///< token behind it
};

/// "next to the bed", "against the wall under the window", "in the corner", from `at` on; nothing if no place
/// is named there, an error if it is not clear which. What is placed (`subjects`) is none of the targets.
std::optional<Result<Whereabouts>> destination_at(const EditText& text, std::size_t at,
                                                  const std::vector<std::string>& subjects);

/// The wall that is nearest to a thing: "wall-2".
std::string nearest_wall(const EditText& text, const Object& object);

/// A single target of a relation: the id of a thing or a part of the room.
struct Target {
  std::string id;
  std::size_t end = 0;
};
std::optional<Result<Target>> target_at(const EditText& text, std::size_t at, const std::vector<std::string>& subjects);

/// "30 cm to the left", "a bit away from the window by 0.2 m", of each of the subjects.
struct Shifting {
  std::optional<Vec3> direction;       ///< in the scene's frame, a unit vector
  std::optional<std::string> from;     ///< away from it
  std::optional<std::string> towards;  ///< closer to it
  std::optional<double> metres;
  std::size_t end = 0;
};
std::optional<Result<Shifting>> shifting_at(const EditText& text, std::size_t at,
                                            const std::vector<std::string>& subjects);

}  // namespace roomgen
