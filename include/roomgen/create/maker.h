#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

/// Objects built from words (papers: primitives, section 3): a classifier, a decomposer, a generator
/// and a validator.
namespace roomgen::create {

/// How a part runs (papers: primitives, section 3.3).
enum class Course { straight, arc, s_curve, taper, spiral, wave };
enum class Strength { gentle, moderate, pronounced };

/// Where a part stands on a thing whose recipe does not know it (data/create/parts.json).
enum class Place {
  foot,     ///< carries the whole, one in the middle or several around
  base,     ///< slabs below everything, each upon the other
  deck,     ///< boards, one above the other
  column,   ///< uprights in the middle
  upright,  ///< uprights at the sides
  across,   ///< bars from side to side
  stack,    ///< piled up in the middle
  helix,    ///< winding up around the column
  radial,   ///< outward from the column on all sides
  wheel,    ///< outward from a hub in the front, as the blades of a mill
  around,   ///< in a ring on the floor
  front, side, back, top,
  hang,     ///< below a bar
};

/// How copies of one part differ, each from the one before (below).
struct Series {
  double scale = 1.0;  ///< of the width and depth
  double turn = 0.0;   ///< about the vertical axis, radians

  bool operator==(const Series&) const = default;
};

/// A part as a sentence asks for it; what it does not say is empty.
struct PartWish {
  std::string label;               ///< in the singular, as shape programs label parts: "leg"
  std::optional<int> count;        ///< 0: "without armrests"
  bool one = false;                ///< "a bucket": no number, but no more than one where that is free
  std::string shape;               ///< "round", "square"
  std::string construction;        ///< "turned", "hairpin", "slatted"
  std::string material;            ///< "brass"
  std::string color;               ///< "white"
  std::optional<double> lean;      ///< degrees outward: "slanted"
  std::optional<Course> course;
  Strength strength = Strength::moderate;
  std::string direction;           ///< of the course: "vertical", "outward"
  std::optional<Vec3> size;        ///< metres
  Vec3 scale = Vec3::Ones();       ///< against the usual: "thick", "long"
  std::vector<std::string> touches;  ///< labels of the parts it is joined to
  std::optional<Place> place;        ///< "on three stones": another place than the part's usual one
  Series series;
};

/// What a sentence says about one object.
struct Description {
  std::string prompt;              ///< the words about this object
  std::string noun;                ///< what it is called: "bar stool"
  std::string kind;                ///< the kind of data/shapes/kinds that will do; empty: none is near
  bool approximate = false;        ///< the kind is only the nearest one
  int count = 1;                   ///< how many of it
  std::string style;               ///< "industrial"
  std::string material, color;     ///< of the whole
  std::optional<Vec3> size;        ///< width, depth, height in metres, where said; NaN: not said
  Vec3 scale = Vec3::Ones();       ///< "large", "low", against the usual
  std::vector<PartWish> parts;
  bool contradicted = false;       ///< two numbers were said of one part, or two lengths of one side
  std::string relation;            ///< to the first object of the sentence: "on", "around"; may be empty
};

/// {"object", "kind", "count", "style", "material", "color", "size_cm", "parts": [{"label", ...}]}
Json to_json(const Description& description);
Result<Description> description_from_json(const Json& json, const std::string& source);

/// The agents that take part, for comparisons (papers: primitives, section 5.1).
enum class Variant {
  full,              ///< all steps
  no_validation,     ///< the same here; whoever validates leaves that out
  no_decomposition,  ///< the program straight from the words
  direct,            ///< triangles instead of a program
};
const char* name(Variant variant);
std::optional<Variant> variant_named(std::string_view name);

/// What the classifier says.
struct Verdict {
  bool passes = false;
  std::string reason;  ///< for people: what the thing is, or why it is none that stands in a room
};

/// What the generator makes a program of.
struct MakeRequest {
  Description description;
  std::uint64_t seed = 0;
  /// The nearest recipes' concrete programs, nearest first: examples for a language model.
  std::vector<shape::Program> examples = {};
  /// An earlier program that shall be changed as the description's prompt says; null: a new one.
  const shape::Program* earlier = nullptr;
  CancelToken cancel = {};
};

/// Turns words into shape programs: by knowledge and grammar, or by a language model. The validator comes after it and is
/// the same for all.
class Maker {
 public:
  virtual ~Maker() = default;

  /// Is it furniture or something that stands indoors?
  virtual Result<Verdict> classify(const std::string& prompt) = 0;
  /// The objects that a sentence names, each with its parts.
  virtual Result<std::vector<Description>> decompose(const std::string& prompt) = 0;
  /// Does generate() look at the examples? They take time to make.
  virtual bool wants_examples() const { return true; }
  /// May generate() be called again for the sake of millimetres?
  virtual bool is_cheap() const { return true; }
  /// A program; it need not be sound yet.
  virtual Result<shape::Program> generate(const MakeRequest& request) = 0;
  /// Variant::direct: triangles instead of a program, one body for each part, not always closed.
  virtual Result<shape::Shape> generate_mesh(const MakeRequest&) {
    return Error{Error::Kind::invalid_input, "only a language model makes triangles directly"};
  }
  /// Was the last program, or the last triangles, not what this maker is for, but its fallback's?
  virtual bool fell_back() const { return false; }
  /// What was assumed, repaired or left to rules since the last call of this function.
  virtual std::vector<std::string> take_notes() { return {}; }
};

/// Works offline: knowledge (data/create, data/shapes) and a grammar of English descriptions. Equal
/// requests give equal programs.
std::unique_ptr<Maker> make_rule_maker();

struct ModelMakerOptions {
  Variant variant = Variant::full;
  /// Kinds that a decomposition may name as the nearest (Description::kind); empty: all that are built in.
  std::vector<std::string> kinds = {};
  int answers = 3;  ///< asked for at most, for one step, when answers cannot be used
  /// Longest answers, in tokens; what a model thinks before it answers counts too.
  int classify_tokens = 512;
  int decompose_tokens = 4096;
  int generate_tokens = 8192;
  CancelToken cancel = {};  ///< of classify() and decompose(); requests have their own
  /// True when the calls, tokens or money that were granted are spent: then the steps fail with
  /// limit.
  std::function<bool()> budget_is_spent = {};
};

/// A maker that asks a language model. Answers are repaired where they are clear; else the model is
/// asked again with the exact error; else the fallback answers and take_notes() says so. A program
/// that can be used but is not what was described is asked for once more. A model that cannot be
/// reached before it ever answered is an error; later, and after three failures in a row, the
/// fallback takes over for good.
/// In Variant::direct generate() fails with invalid_input: there is no program. `fallback` is not
/// null; the model must outlive the maker.
std::unique_ptr<Maker> make_model_maker(ChatModel& model, std::unique_ptr<Maker> fallback,
                                             Prompts prompts, ModelMakerOptions options = {});

/// 1 (bad) to 5 (as good as bought), and one sentence why.
struct Score {
  int points = 0;
  std::string reason;
};

/// The three rubrics that people judged objects by (papers: primitives, section 5.2).
struct Scores {
  Score structure;  ///< does it hold together and stand, as a thing that could be built?
  Score realism;    ///< does it look like one whole thing of its kind?
  Score alignment;  ///< is it what the words say?

  double mean() const { return (structure.points + realism.points + alignment.points) / 3.0; }
};
Json to_json(const Scores& scores);

struct JudgeOptions {
  int answers = 3;  ///< asked for at most, when answers cannot be used
  int tokens = 1024;
  CancelToken cancel = {};
};

/// What a model that sees pictures says of an object. `views`: whole PNG files of it from several
/// sides, at least one. Fails as ChatModel::chat() does, and with invalid_input when no answer can
/// be used.
Result<Scores> judge(ChatModel& model, const Prompts& prompts, const std::string& prompt,
                     const std::vector<std::string>& views, const JudgeOptions& options = {});

}  // namespace roomgen::create
