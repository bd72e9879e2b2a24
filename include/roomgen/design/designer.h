#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/library/library.h"
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

/// A thing that stands and shall stand elsewhere, with its group and what is on it.
struct WantedMove {
  std::string object;
  Vec2 location = Vec2::Zero();  ///< of its centre
  std::optional<double> yaw;     ///< radians; else it looks as it did
};

/// An asset that things of a plan may take.
struct OfferedAsset {
  AssetInfo asset;
  Vec3 size = Vec3::Ones();                        ///< as it would stand, metres
  Vec3 least = Vec3::Ones(), most = Vec3::Ones();  ///< how small and how large it may be made
};

/// What there is for the things of a plan that are asked for in the same words.
struct AssetOffer {
  std::string id;                  ///< "7"
  std::vector<std::size_t> items;  ///< of the plan
  int count = 1;                   ///< things of them all
  std::string words;               ///< what was searched for
  Vec3 size = Vec3::Ones();        ///< asked for, or usual
  bool carries = false;            ///< the plan puts things onto it
  bool is_shown = true;            ///< something in stock is known to be what is asked for
  std::vector<OfferedAsset> assets;  ///< best first; of those searched again the first of before is the last
  std::optional<AssetInfo> made;  ///< what the words would be made into; nothing: nobody knows how

  /// Of an asset, on sheets and in answers: "7b".
  std::string label(std::size_t asset) const { return id + static_cast<char>('a' + asset); }
};

/// What a designer chooses from before anything is placed.
struct ChoiceRequest {
  const Plan& plan;
  std::vector<AssetOffer> offers;
  bool again = false;  ///< found by other words, as the answer before wished; there is no more search
  /// Draws what is offered, with its labels; empty where nothing draws.
  std::function<Result<std::vector<Image>>()> sheets = {};
  CancelToken cancel = {};
};

/// What the things of one offer shall be.
struct AssetChoice {
  enum class Kind { asset, search, make, leave_out };
  std::size_t offer = 0;  ///< of the request
  Kind kind = Kind::asset;
  std::size_t asset = 0;     ///< of the offer
  std::string words;         ///< to search for, or of what shall be made
  std::optional<Vec3> size;  ///< else as offered
  std::string paint;         ///< looks that it shall get: "navy velvet with brass legs"
  std::string reason;
};

struct AssetChoices {
  std::vector<AssetChoice> choices;  ///< one an offer; without one it keeps the library's first
  Consultation consultation = {};
};

/// A thing that is made, for nothing that is offered is it.
struct ThingToMake {
  AssetOffer offer;  ///< with the words and the size as it shall be
  std::string program;  ///< JSON that was written for it; empty: none yet
  std::vector<std::string> notes;  ///< what is wrong with that, with JSON pointers in it
};

/// What a designer makes at once, or looks at and mends.
struct MakingRequest {
  const Plan& plan;
  std::vector<ThingToMake> things;
  const Json& form;    ///< the JSON schema of programs (docs/shapes.md)
  bool again = false;  ///< they were written, as far as they have programs: what shall be otherwise?
  /// Draws what was made, under the offers' numbers; empty where nothing draws.
  std::function<Result<std::vector<Image>>()> sheets = {};
  CancelToken cancel = {};
};

struct ThingsMade {
  std::map<std::size_t, std::string> programs;  ///< JSON by things of the request, as it was written
  Consultation consultation = {};
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
  std::string leave_out = {};    ///< why it shall not be there after all; empty: it shall
  bool spread = false;  ///< nobody said the location: it is one of a row along what carries it
  std::optional<double> bottom = {};     ///< of what hangs: of its lower edge, metres from the floor
  std::optional<Vec3> size = {};         ///< another one than planned, metres
  std::vector<WantedMove> moves = {};    ///< first of all
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
  /// What stands otherwise than was suggested, or does not stand: "sofa-0 stands 0.3 m from where
  /// you put it"; may be empty.
  std::function<std::vector<std::string>()> elsewhere = {};
  std::vector<Bounds2> free_floor = {};  ///< with refusals: the largest free parts of the floor
  std::vector<std::string> later = {};  ///< ids of what is still to be placed, in the plan's order
  /// Of these, what comes with the anchor of its group: it is not asked for. May be empty.
  std::function<std::set<std::string>()> with_group = {};
  bool lost_place_in_group = false;  ///< it has a place in its group, and there was no room for it
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

  /// Does it choose assets? Else nothing is offered to it.
  virtual bool chooses() const { return false; }
  /// Asked once for a room, and once more for what it wants to be searched by other words. Fails as
  /// place() does.
  virtual Result<AssetChoices> choose(const ChoiceRequest&) { return AssetChoices{}; }
  /// Does it make what it wants to be made? Else rules do.
  virtual bool makes() const { return false; }
  /// Asked once for all that shall be made, and once more when it can see that. Fails as place() does.
  virtual Result<ThingsMade> make(const MakingRequest&) { return ThingsMade{}; }

  /// Relations only name what is placed or a part of the room. Fails with limit when no more may be asked:
  /// then the room ends with what is placed.
  virtual Result<PlaceAdvice> place(const PlaceRequest& request) = 0;
};

/// Reads what a wish says and its pictures show. Without one, rules read it where a plan is made.
class Reader {
 public:
  virtual ~Reader() = default;

  /// Sets PlanRequest::said: designers plan by it, the plan's requirements come from it and from
  /// nothing else. The prompt gets a line for each picture; without a reading of these it fails.
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

/// Where a designer by book takes its designs from (docs/designs.md).
struct BookOptions {
  std::filesystem::path folder = {};  ///< of further designs, which go before the built-in ones
  std::filesystem::path design = {};  ///< a file: this design and no other
  LogSink log = {};                   ///< told of files of the folder that are no designs
};

/// A designer that needs no language model: it reads English prompts with a small grammar, takes the design of
/// data/designs that serves the wish best, fits it to the room and puts what the wish asks for into it. Otherwise
/// as make_rule_designer().
Result<std::unique_ptr<Designer>> make_book_designer(const BookOptions& options = {});

/// How a finished room becomes a design.
struct LearnOptions {
  std::string name = {};                ///< else the room's prompt
  std::vector<std::string> rooms = {};  ///< kinds of rooms that it is a design of; else the room's own
  bool keep_assets = false;             ///< of libraries, too, where else words decide again
};

/// A design (docs/designs.md) after which a room of the same size becomes this one again, and others
/// accordingly. Fails for dwellings, empty rooms and scenes that are not sound.
Result<Json> learn_design(const Scene& scene, const LearnOptions& options = {});
/// What a sound design is made of, for people. Located errors for what is none.
Result<std::string> check_design(const Json& json, const std::string& source);

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

/// What a model designs in one answer.
enum class ModelSteps {
  objects,  ///< an inventory, then thing by thing (papers: RoomGen, section 4)
  groups,   ///< the whole room, then all that stands on the floor, what hangs, and what is on each carrier
};

struct ModelDesignerOptions {
  ModelMode mode = ModelMode::fused;
  ModelSteps steps = ModelSteps::groups;  ///< with another mode, the paper's frame or an order of the model's own: objects
  /// The frame of the picture's marks and of the answers: the scene's own, or x down from the top
  /// and y left from the right, as the paper has it.
  bool paper_frame = false;
  bool chooses_assets = true;  ///< of each thing, before anything is placed
  bool makes_assets = true;    ///< writes shape programs of what it wants to be made; else rules make it
  bool chooses_order = false;  ///< each answer also says which thing shall come next
  int answers = 3;  ///< asked for at most, for one plan or object, when answers cannot be used
  /// Answers about places that are known beforehand, by the ids of things, as a model gives them.
  std::map<std::string, std::string> places = {};
  /// Longest answers, in tokens; what a model thinks before it answers counts too.
  int plan_tokens = 12'000;
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
