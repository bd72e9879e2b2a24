#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/scene/object.h"

/// Sentences with what can be checked of the things they make, and the checks (papers: primitives,
/// section 5).
namespace roomgen::lab {

using create::CreatedObject;
using create::Creation;
using create::Score;
using create::Scores;
using create::Variant;

/// A part that a thing must have, or must not have.
struct WantedPart {
  std::vector<std::string> labels;  ///< any of them; "leg" is also a "front leg"
  int least = 1;
  std::optional<int> most;  ///< nothing: as many as there are
};

/// A sentence of bench/create/prompts.json.
struct SuiteSentence {
  std::string prompt;
  std::string group;  ///< "common", "edge", "strange"
  std::vector<WantedPart> parts;
  Vec3 least = Vec3::Zero(), most = Vec3::Zero();  ///< width, depth, height, metres
  Mount mount = Mount::floor;
};

Result<std::vector<SuiteSentence>> read_suite(const Json& json, const std::string& source);
/// SHA-256 of a suite's file: which sentences results belong to.
std::string suite_version(std::string_view text);

enum class Check { connected, grounded, supported, symmetric, stable, size };
inline constexpr std::size_t check_count = 6;
/// "connected".
const char* name(Check check);

/// What is true of a thing that a sentence made.
struct Assessment {
  bool made = false;
  int parts_asked = 0, parts_right = 0;  ///< right: there, as often as it was asked for
  /// Nothing where it does not apply: a lamp that hangs needs no ground, and what has no two like
  /// feet cannot have them alike.
  std::optional<bool> checks[check_count];
  std::vector<std::string> failures;  ///< what is wrong, for people

  std::optional<bool> operator[](Check check) const { return checks[static_cast<int>(check)]; }
  bool perfect() const;
};

/// Measured on the meshes, so that things without a program are judged alike:
///   connected  all closed surfaces touch (3 mm) as one whole
///   grounded   the lowest point is at z = 0 (1 mm), and no leg hangs in the air
///   supported  from each part a chain of touching parts leads to the ground, and what carries
///              something ends under it
///   symmetric  parts of which there are several on which the thing stands or one leans the arms are
///              of one size, each in a place of its own, and these lie evenly
///   stable     the centre of mass is over what touches the ground
///   size       within the sentence's width, depth and height (2 mm)
Assessment assess(const SuiteSentence& sentence, const CreatedObject& object);
/// The main object; sentences of suites mean one thing, and several stand apart. Precondition: there
/// are objects.
Assessment assess(const SuiteSentence& sentence, const Creation& creation);

/// Nothing was made: what is asked of such a thing fails.
Assessment not_made(const SuiteSentence& sentence, const std::string& why);

/// A sentence made once, in one variant.
struct SuiteResult {
  Variant variant = Variant::full;
  int number = 0;  ///< of the sentence, from 1
  std::string prompt, group;
  Assessment assessment;
  Vec3 size = Vec3::Zero();
  std::size_t triangles = 0;
  int repairs = 0;
  bool fell_back = false;  ///< rules made it in the place of a model
  double seconds = 0.0;
  std::optional<Scores> scores;
};

Json to_json(const SuiteResult& result);
Result<SuiteResult> suite_result_from_json(const Json& json, const std::string& source);

/// Tables in Markdown: for each variant a row of each group and one of all; then what failed. What
/// was not made counts as failed.
std::string suite_markdown(const std::vector<SuiteResult>& results);
/// The same figures for scripts, {"full": {"all": {"sentences", "made", ...}}}.
Json suite_summary(const std::vector<SuiteResult>& results);

}  // namespace roomgen::lab
