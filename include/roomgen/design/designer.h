#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/relation.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

class ChatModel;
class KindTable;
class Prompts;

/// How an answer came about, for the trace and the summary; empty for rules.
struct Consultation {
  int calls = 0;               ///< of a language model
  long long input_tokens = 0;
  long long output_tokens = 0;
  double seconds = 0.0;        ///< waiting for it
  std::string prompt_sha256;   ///< of the text it was shown last
  std::string image_sha256;    ///< of the picture, if any
  std::vector<std::string> notes;  ///< what was repaired or refused
  bool fell_back = false;      ///< the model had no usable answer: rules decided
};

/// Where an object shall go, roughly; the solver finds the exact pose.
struct PlaceAdvice {
  std::vector<Relation> relations;
  std::optional<Vec2> location;  ///< centre, in the scene's frame
  std::optional<double> yaw;     ///< radians
  /// The solver chooses what else holds and where, as things of its kind usually are arranged.
  bool usual = false;
  std::string reasoning;         ///< for the trace
  std::vector<std::string> lost = {};  ///< what the designer said and could not be understood
  std::string next = {};         ///< which of PlaceRequest::later shall come next; empty: the first
  Consultation consultation = {};
};

/// One object whose place is asked for. What is already placed is in `scene`.
struct PlaceRequest {
  const Plan& plan;
  const Scene& scene;
  const PlannedObject& planned;  ///< its item is plan.items[planned.item]
  const Object& object;          ///< id, category and real size are known, position and yaw are not
  std::vector<std::string> refusals = {};  ///< why earlier answers for this object did not fit
  std::vector<PlaceAdvice> earlier = {};  ///< the answers so far: those refused, and one to be thought over
  /// What of the last answer could not be followed where the object would stand then: that answer may be
  /// changed once.
  std::vector<std::string> objections = {};
  std::optional<Vec2> standing_at = {};
  std::vector<Bounds2> free_floor = {};  ///< with refusals: the largest free parts of the floor
  std::vector<std::string> later = {};  ///< ids of what is still to be placed, in the plan's order
  /// Draws the room with coordinate marks, and the top of what carries the object larger; may be empty.
  std::function<Result<std::vector<Image>>()> marks = {};
  CancelToken cancel = {};
};

/// Decides what a room holds and roughly where each thing goes: rules, or a language model.
class Designer {
 public:
  virtual ~Designer() = default;

  /// Equal requests give equal plans. The items are in the order in which they shall be placed:
  /// anchors first, what depends on others after them.
  virtual Result<Plan> plan(const PlanRequest& request) = 0;
  /// How the last plan came about.
  virtual Consultation plan_consultation() const { return {}; }

  /// Relations only name what is placed or a part of the room. Fails with limit when no more may be asked:
  /// then the room ends with what is placed.
  virtual Result<PlaceAdvice> place(const PlaceRequest& request) = 0;
};

/// Reads what a wish says. Without one, rules read it where a plan is made.
class Reader {
 public:
  virtual ~Reader() = default;

  /// Sets PlanRequest::said: designers plan by it, the plan's requirements come from it and from
  /// nothing else.
  virtual Status read(PlanRequest& request) = 0;
  /// How the last reading came about.
  virtual Consultation consultation() const = 0;
};

struct ModelReaderOptions {
  /// Asked for at most, where an answer cannot be used or parts of it cannot be read.
  int answers = 2;
  int tokens = 8192;         ///< longest answer
  bool no_fallback = false;  ///< fails without a reading of the model's, rules do not read then
  /// True when the calls, tokens or money that were granted are spent: then it fails with limit.
  std::function<bool()> budget_is_spent = {};
};

/// A reader that asks a language model once for each wish (docs/brief.schema.json). Where it has no
/// usable answer rules read, and a note of the plan says so; a model that cannot be reached at all
/// is an error. The model must outlive the reader.
std::unique_ptr<Reader> make_model_reader(ChatModel& model, Prompts prompts,
                                          const KindTable& categories,
                                          ModelReaderOptions options = {});

/// What was read in the prompt of a request, by rules unless a reader did, clause by clause:
/// brief.json (docs/brief.schema.json).
Result<Json> brief_json(const PlanRequest& request);

/// Longest prompt that is read, in bytes.
inline constexpr std::size_t max_prompt_bytes = 100'000;

/// A designer that needs no language model: it reads English prompts with a small grammar, completes
/// them from the knowledge in data/rooms.json and places things by data/arrangements.json. What the
/// prompt says outranks what rooms usually hold.
///
/// plan() fails with invalid_input for an empty prompt, for a size outside 0.5 to 50 m, and where nothing that
/// makes the room what it is called (data/rooms.json, "made_by": a bedroom's bed) finds a place: the message says
/// what, and the least size, measured by planning larger rooms, in which it does. Exempt are rooms of which the
/// prompt says that there is none, or nothing but what it names, and what it names itself. It fails with limit
/// for a prompt beyond max_prompt_bytes. A prompt that names no room and no furniture gives a living
/// room and a note. place() keeps no state: equal requests give equal advice, and each refusal in the
/// request makes it give up more of its own wishes.
std::unique_ptr<Designer> make_rule_designer();

/// The plan of a dwelling, if the prompt asks for several rooms (docs/dwellings.md) and the request
/// gives neither a floor plan nor a size of one room; else nothing. The rooms are laid out by
/// rules, and the designer plans each of them with what the prompt says of it.
Result<std::optional<DwellingPlan>> plan_dwelling(const PlanRequest& request, Designer& designer);

/// Settles what a plan leaves to rules before it is furnished: openings that are wanted get places
/// (Plan::openings); where the room has a style or a palette, what nobody said of floor, walls and
/// things is chosen by them. Notes tell what is left out, and where the plan says it
/// ("/openings/2: ...").
void settle(Plan& plan);
void settle(DwellingPlan& plan);

/// What the model sees and says of each object (papers: RoomGen, section 4.4.1). The fusion's alpha
/// belongs to it: 1 for the first two, where there is no suggestion to follow.
enum class ModelMode {
  constraints,  ///< the room as text without places; constraints come back
  image,        ///< the room as text and picture; constraints come back
  fused,        ///< the same, and a location besides
};

struct ModelDesignerOptions {
  ModelMode mode = ModelMode::fused;
  /// The frame of the picture's marks and of the answers: the scene's own, or x down from the top
  /// and y left from the right, as the paper has it.
  bool paper_frame = false;
  bool chooses_order = false;  ///< each answer also says which thing shall come next
  int answers = 3;  ///< asked for at most, for one plan or object, when answers cannot be used
  /// Longest answers, in tokens; what a model thinks before it answers counts too.
  int plan_tokens = 4096;
  int place_tokens = 1024;
  /// Makes a PNG or JPEG of a picture; without it no picture is shown.
  std::function<Result<std::string>(const Image&)> encode_picture;
  /// True when the calls, tokens or money that were granted are spent: then the designer fails with
  /// limit.
  std::function<bool()> budget_is_spent;
  LogSink log;  ///< told once of a model that takes no pictures and is asked without them
};

/// A designer that asks a language model. Answers are repaired where they are clear; else the model
/// is asked again with the reason; else `fallback` decides and the advice says so. A model that
/// cannot be reached when the plan is asked for is an error; later the fallback takes over for
/// good.
///
/// The model must outlive the designer.
std::unique_ptr<Designer> make_model_designer(ChatModel& model, std::unique_ptr<Designer> fallback,
                                              Prompts prompts, const KindTable& categories,
                                              ModelDesignerOptions options = {});

}  // namespace roomgen
