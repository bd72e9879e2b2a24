#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/plan.h"
#include "roomgen/scene/scene.h"
#include "roomgen/solve/solve.h"
#include "roomgen/view/view.h"

namespace roomgen::create {
struct Creation;
}

namespace roomgen {

/// One asset with one answer of the designer, and what became of it.
struct Attempt {
  std::string asset;       ///< asset_key()
  PlaceAdvice answer;      ///< of the designer, or of the host
  int candidates = 0;      ///< poses proposed
  int feasible = 0;        ///< of them, inside the room and clear of other things
  std::optional<PlacementTerms> chosen;     ///< of the pose taken
  std::optional<PlacementTerms> runner_up;  ///< of the best other one
  bool made_room = false;  ///< what stood on the same support was arranged anew for it
  std::vector<std::string> objections = {};  ///< what of the answer is not so at the pose taken
  std::string refused;     ///< why no pose could be taken, or the answer after it is; empty: one was
};

/// A thing that an improvement or a repair put elsewhere.
struct Move {
  std::string object;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< bottom centre
  double turn = 0.0;                            ///< radians, counter-clockwise

  double distance() const { return (to - from).norm(); }
};

/// What became of one planned object: a line of trace.jsonl (docs/trace.md).
struct Step {
  PlannedObject planned;
  std::string category, description;  ///< what retrieval was asked for
  bool has_assets = false;            ///< it found something to try
  std::vector<Attempt> attempts;      ///< in order
  std::string window;                 ///< the one that a curtain or blind covers
  std::optional<Pose> pose;           ///< where it stood at the end of the step
  bool repaired = false;              ///< neighbours made way
  std::vector<Move> moved;            ///< those neighbours
  std::string reason;                 ///< why it has no place; empty: it has one
  std::string room;                   ///< of a dwelling
  double seconds = 0.0;               ///< that the step took; not part of the trace
};

/// One line of trace.jsonl. Nothing in it depends on the clock.
Json to_json(const Step& step);
/// {"object", "from", "to", "by", "turned_deg"}: metres and degrees.
Json to_json(const Move& move);

/// What a designer was offered at once, and what it chose, or what it was asked to make: a line of
/// trace.jsonl before those of the steps.
struct ChoiceRound {
  std::vector<AssetOffer> offers;
  AssetChoices answer;
  std::vector<ThingToMake> making;  ///< with what was written, and what was wrong with that before
  std::vector<std::string> taken;  ///< by offer, or thing: asset_key(); "": the words decide, or left out
  std::vector<std::string> notes;  ///< what could not be had as it was chosen, is wrong with what was made
  std::string room;                ///< of a dwelling
};
Json to_json(const ChoiceRound& round);

/// How closely the suggestions of a model or a person were followed (papers: RoomGen, table 3): numbers of
/// objects in the finished scene. Places that rules chose do not count.
struct SuggestionFigures {
  static constexpr std::array<double, 5> thresholds = {0.25, 0.5, 1.0, 2.0, 3.0};  ///< metres
  int located = 0;  ///< placed, and a location was suggested
  std::array<int, 5> within = {};         ///< of them, in the end at most a threshold away
  std::array<int, 5> placed_within = {};  ///< the same at the end of their steps
  int faced = 0;        ///< placed, and a yaw was suggested
  int facing_kept = 0;  ///< of them, 15 degrees from it at most
};

/// What was asked of a language model while assets were chosen and things placed; zero for rules.
struct ModelUse {
  int calls = 0;
  long long input_tokens = 0;
  long long output_tokens = 0;
  double seconds = 0.0;
  int fallbacks = 0;  ///< objects for which rules decided in the end
};

/// A furnished room, or dwelling, and how it came about.
struct Generation {
  Scene scene;  ///< in the plan's order, with the requirements' verdicts; incomplete if it was stopped
  ModelTable models;  ///< of all openings and all objects placed
  std::vector<AssetInfo> assets;  ///< of all openings and all objects placed, without repetition
  std::vector<Step> trace;        ///< one a planned object that was tried, in order
  std::vector<ChoiceRound> choices;  ///< of assets, in order
  std::vector<Plan> chosen;  ///< the plans of all rooms with what was chosen; empty if nothing was
  std::vector<Move> moved;        ///< by the improvement at the end
  int constraints = 0;
  int held = 0;
  SuggestionFigures suggestions;
  ModelUse model_use;
  std::vector<std::string> notes;  ///< which objects are only stand-ins, what settle() left out, for people
  std::string stopped;  ///< why the designer was not asked any more, if so
};

/// What a builder tells while it works, on the thread that called it.
struct BuildEvent {
  enum class Kind {
    choosing,   ///< the designer is asked what things shall be: `text`
    making,     ///< and makes some: `text`
    begun,      ///< `object` is looked after now
    placed,     ///< `object` stands: `placed` has its pose
    left_out,   ///< `object` found no place: `step->reason`
    improving,  ///< what stands is moved about to win back what was lost
    improved,
    undone,     ///< the last step; `scene` is that before it
  };
  Kind kind = Kind::begun;
  std::size_t done = 0;   ///< planned objects that were tried
  std::size_t total = 0;  ///< planned objects
  std::string object = {};         ///< id; empty for what concerns all
  const Object* placed = nullptr;  ///< these live as long as the call
  const Step* step = nullptr;      ///< of placed and left_out: what the trace will say
  const Scene* scene = nullptr;    ///< what stands now; null before anything does
  std::string text = {};           ///< of choosing and making, for people
};

struct BuildOptions {
  PlaceOptions place;
  int assets_per_object = 3;   ///< assets that are tried before the designer is asked again
  int answers_per_object = 3;  ///< times the designer is asked for one object
  bool repair = true;          ///< others make way for an object that found no place
  int repair_rounds = 12;      ///< of improvement for that
  Improvement improvement = Improvement::minimal;
  int improve_rounds = 60;     ///< of improvement at the end
  int offers_per_item = 4;     ///< assets among which a designer chooses
  std::uint64_t seed = 0;      ///< which of equally good assets are taken
  bool tells_least = true;     ///< generate() measures the least size for an error too_small
  CancelToken cancel;          ///< stops the call at work, and those to come
  std::function<void(const BuildEvent&)> on_event;
  /// Draws what the designer sees; may be null.
  Renderer* renderer = nullptr;
  View marks_view{View::Kind::top, 1024, true, false};
};

/// Furnishes a room step by step (RoomBuilder): for each planned object retrieve an asset, ask the
/// designer, propose, score, fuse, place; when it does not fit, the next asset, then the designer
/// again with the reason, then a repair, then it is left out with the reason. A last improvement
/// wins back what was lost. One object that fails never costs another its place. When cancelled, or
/// when the designer may ask no more (Error::Kind::limit), what is placed so far is returned and
/// the scene is marked incomplete. Fails with too_small where nothing that makes the room what it
/// is called found a place (RoomBuilder::check_kind()); the message tells the least rectangle in
/// which the plan's things make one, measured by furnishing.
Result<Generation> generate(const Plan& plan, Designer& designer, const AssetLibrary& library,
                            const KindTable& categories, const BuildOptions& options = {});

/// Furnishes the rooms of a dwelling one after the other into one scene; events count through all of them.
/// What was stopped in one room is stopped in those after it. A room that is not what it is called is a failure
/// of the whole; the message begins with its id.
Result<Generation> generate(const DwellingPlan& plan, Designer& designer,
                            const AssetLibrary& library, const KindTable& categories,
                            const BuildOptions& options = {});

/// An error of a designer's plan() or of generate() for this request: where it is too_small, with
/// the least size in which the same prompt and seed make the room by rules with this library,
/// measured by planning and furnishing up to 25 larger rooms and those between (docs/rooms.md). It
/// begins at the request's size, else at the least that the error tells. For prompts of one room.
/// Other errors are returned as they are.
Error with_least_size(const Error& too_small, const PlanRequest& request,
                      const AssetLibrary& library, const KindTable& categories,
                      const BuildOptions& options = {});

/// Objects that a sentence names together ("a table with cups on it and four chairs around it"), set
/// out by the solver in an empty room: the first in the middle, the others as their relations to it
/// say, as many of each as were asked for. What finds no place is in Generation::scene.unplaced.
Result<Generation> set_out(const create::Creation& creation, const KindTable& categories,
                           std::uint64_t seed);

/// Everything that stands in the scene as one model, the first object's centre at the origin.
Model merged_model(const Scene& scene, const ModelTable& models);

/// A folder for a room's files. One that is empty or holds an earlier output of ours is taken; anything else
/// is refused unless `force` is set. An earlier room goes when the new one is committed, what else is in the
/// folder stays.
Result<OutputFolder> open_room_folder(const std::filesystem::path& folder, bool force);

/// Does scene.json of this name hold a scene that is not marked as incomplete? A stopped run leaves it there.
bool holds_whole_scene(const std::filesystem::path& scene_file);

/// A short folder name for a prompt: "a-cosy-bedroom-for-two".
std::string folder_name(const std::string& prompt);

/// scene.json, plan.json and trace.jsonl of a finished (or interrupted) generation; `plan` is that
/// of a room or of a dwelling.
Status write_documents(const OutputFolder& folder, const Json& plan, const Generation& generation);

}  // namespace roomgen
