#include "roomgen/design/model_designer.h"

#include <algorithm>
#include <map>

#include "base/json_literal.h"
#include "base/sha256.h"
#include "brief/prompt.h"
#include "place_reply.h"
#include "plan/claim.h"
#include "plan_reply.h"
#include "roomgen/base/text.h"
#include "scene_text.h"

namespace roomgen {

namespace {

using design::SceneText;

// Kinds still to come are named up to here: enough to leave room for them.
constexpr std::size_t most_named_later = 12;
constexpr std::size_t most_together = 8;    // things on one carrier that one answer places
constexpr std::size_t most_offered = 30;    // ids among which the model chooses the next
constexpr double second_temperature = 0.5;  // weak models repeat a bad answer word for word
constexpr std::size_t most_quoted = 4000;   // bytes of an answer that cannot be used
// Calls that fail one after the other before the model is given up: each may take all its time.
constexpr int most_failures = 3;

// The names of the prompts of a mode, without "-system" and "-user".
std::string_view place_prompt(ModelMode mode) {
  switch (mode) {
    case ModelMode::constraints:
      return "place-constraints";
    case ModelMode::image:
      return "place-image";
    case ModelMode::fused:
      break;
  }
  return "place";
}

// Long lists are bounded when they are read: grammar samplers grow slow with such bounds.
const Json& plan_schema() {
  static const Json schema = [] {
    const Json thing = json_literal(R"({"type": "object", "additionalProperties": false,
      "properties": {"name": {"type": "string"}, "description": {"type": "string"},
        "size_cm": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
        "quantity": {"type": "integer"}, "variance": {"type": "string", "enum": ["same", "varied"]},
        "place": {"type": "string"}},
      "required": ["name", "description", "size_cm", "quantity", "variance", "place"]})");
    Json carrier = thing;
    carrier["properties"]["on_top"] = {{"type", "array"}, {"items", thing}};
    carrier["required"].push_back("on_top");
    Json result = json_literal(R"({"type": "object", "additionalProperties": false,
      "properties": {"room": {"type": "object", "additionalProperties": false,
        "properties": {"type": {"type": "string"},
          "size_m": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
          "polygon_m": {"anyOf": [{"type": "null"}, {"type": "array",
            "items": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}}]},
          "height_m": {"type": "number"}},
        "required": ["type", "size_m", "polygon_m", "height_m"]},
        "excluded": {"type": "array", "items": {"type": "string"}}},
      "required": ["room", "objects", "excluded"]})");
    result["properties"]["objects"] = {{"type", "array"}, {"items", carrier}};
    return result;
  }();
  return schema;
}

Json place_schema(const ModelDesignerOptions& options) {
  Json schema = json_literal(R"({"type": "object", "additionalProperties": false,
    "properties": {"reasoning": {"type": "string"}, "constraints": {"type": "string"}},
    "required": ["reasoning", "constraints"]})");
  const auto require = [&](const char* key, const char* form) {
    schema["properties"][key] = json_literal(form);
    schema["required"].push_back(key);
  };
  if (options.mode == ModelMode::fused) {
    require("location", R"({"type": "array", "items": {"type": "number"}})");
    require("facing", R"({"anyOf": [{"type": "string"}, {"type": "number"}, {"type": "null"}]})");
  }
  if (options.chooses_order) require("next", R"({"type": "string"})");
  return schema;
}

// For several things at once: a list of the same, each with its id.
void add_others(Json& schema) {
  Json one = schema;
  one["properties"].erase("next");
  one["properties"]["id"] = {{"type", "string"}};
  one["required"] = Json::array();
  for (const auto& [key, value] : one["properties"].items()) one["required"].push_back(key);
  schema["properties"]["others"] = {{"type", "array"}, {"items", one}};
  schema["required"].push_back("others");
}

class ModelDesigner : public Designer {
 public:
  ModelDesigner(ChatModel& model, std::unique_ptr<Designer> fallback, Prompts prompts,
                const KindTable& categories, ModelDesignerOptions options)
      : model_(model),
        fallback_(std::move(fallback)),
        prompts_(std::move(prompts)),
        categories_(categories),
        options_(std::move(options)) {}

  Result<Plan> plan(const PlanRequest& request) override {
    auto question = plan_question(request);
    if (!question) return question.error();
    planning_ = {};
    planning_.prompt_sha256 = sha256_hex(question->messages.back().text);
    const design::Brief brief = brief_of(request);
    std::optional<design::PlanReply> incomplete;  // what is forgotten goes back once
    const auto read = [&](const std::string& text) -> Result<design::PlanReply> {
      auto answer = design::read_plan_reply(text, request, brief, categories_);
      if (!answer) return answer;
      if (auto status = design::check_floor(answer->plan, categories_); !status)
        return status.error();
      if (incomplete) return answer;
      const auto claimed = design::claim(answer->plan, brief, categories_);
      const auto objection = design::objection(claimed, brief);
      if (objection.empty()) return answer;
      incomplete = *std::move(answer);
      return Error{Error::Kind::invalid_input, objection};
    };
    auto reply = converse(*question, read, planning_);
    if (!reply && ends_the_room(reply.error())) return reply.error();
    if (!reply && incomplete) reply = *std::move(incomplete);
    if (reply) {
      const auto claimed = design::claim(reply->plan, brief, categories_);
      design::fulfil(claimed, brief, categories_, reply->plan);
      note(reply->plan, reply->repairs);
      note(reply->plan, planning_.notes);
      return std::move(reply->plan);
    }
    auto plan = fallback_->plan(request);
    if (!plan) return plan;
    planning_.fell_back = true;
    note(*plan, {"the model gave no plan that can be used (" + reply.error().message +
                 "); rules made this one"});
    return plan;
  }

  Consultation plan_consultation() const override { return planning_; }

  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    Consultation consultation;
    if (auto advice = told_already(request)) return *std::move(advice);
    if (model_is_lost_.empty()) {
      auto advice = ask(request, consultation);
      if (advice) {
        advice->consultation = std::move(consultation);
        return advice;
      }
      if (advice.error().kind == Error::Kind::cancelled || is_spent()) return advice;
      consultation.notes.push_back(advice.error().message);
    }
    auto advice = fallback_->place(request);
    if (!advice) return advice;
    consultation.fell_back = true;
    if (!model_is_lost_.empty()) consultation.notes.push_back("rules take over: " + model_is_lost_);
    advice->consultation = std::move(consultation);
    return advice;
  }

 private:
  static void note(Plan& plan, const std::vector<std::string>& notes) {
    plan.notes.insert(plan.notes.end(), notes.begin(), notes.end());
  }

  // What the prompt asks for holds whoever plans.
  design::Brief brief_of(const PlanRequest& request) const {
    const auto& kinds = design::built_in_room_kinds();
    return kinds ? design::read_prompt(request.prompt, *kinds, categories_) : design::Brief();
  }

  // Before anything is placed, what keeps the model from answering at all is worth knowing.
  bool ends_the_room(const Error& error) const {
    return error.kind == Error::Kind::unavailable || error.kind == Error::Kind::cancelled ||
           is_spent();
  }

  bool is_spent() const { return options_.budget_is_spent && options_.budget_is_spent(); }

  Result<ChatRequest> make_question(std::string_view name, const Prompts::Slots& system,
                                    const Prompts::Slots& user) const {
    auto introduction = prompts_.render(std::string(name) + "-system", system);
    if (!introduction) return introduction.error();
    auto task = prompts_.render(std::string(name) + "-user", user);
    if (!task) return task.error();
    ChatRequest question;
    question.messages = {{ChatMessage::Role::system, *std::move(introduction), {}},
                         {ChatMessage::Role::user, *std::move(task), {}}};
    return question;
  }

  Result<ChatRequest> plan_question(const PlanRequest& request) const {
    std::string room;
    if (request.room)
      room = "The room is given: " + SceneText(*request.room, false).room() + ".";
    else if (request.size)
      room = "The room is given: " + format_number(request.size->x(), 2) + " x " +
             format_number(request.size->y(), 2) + " m.";
    auto question = make_question("plan", {}, {{"prompt", request.prompt}, {"room", room}});
    if (!question) return question;
    question->schema = plan_schema();
    question->schema_name = "plan";
    question->max_tokens = options_.plan_tokens;
    question->cancel = request.cancel;
    return question;
  }

  design::PlaceReplyContext context_of(const PlaceRequest& request) const {
    return {request.scene, request.object, options_.paper_frame,
            options_.chooses_order ? request.later : std::vector<std::string>()};
  }

  // What was answered together with another thing on the same carrier, while everything stands as it did.
  std::optional<PlaceAdvice> told_already(const PlaceRequest& request) {
    const auto told = others_.find(request.object.id);
    if (told == others_.end()) return std::nullopt;
    const std::string text = told->second;
    others_.erase(told);
    const bool again = !request.refusals.empty() || !request.objections.empty();
    if (again || !stands_as_then(request.scene)) return std::nullopt;
    auto reply = design::read_place_reply(text, context_of(request));
    if (!reply) return std::nullopt;
    if (options_.mode != ModelMode::fused) reply->advice.location.reset(), reply->advice.yaw.reset();
    Consultation& consultation = reply->advice.consultation;
    consultation.prompt_sha256 = others_prompt_;
    consultation.notes = std::move(reply->repairs);
    consultation.notes.insert(consultation.notes.begin(), "answered together with what stands beside it");
    return std::move(reply->advice);
  }

  bool stands_as_then(const Scene& scene) const {
    return std::all_of(others_scene_.begin(), others_scene_.end(), [&](const Object& then) {
      return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& now) {
        return now.id == then.id && now.position == then.position && now.yaw == then.yaw;
      });
    });
  }

  // Those still to come that shall stand on the same thing.
  static std::vector<PlannedObject> companions(const PlaceRequest& request) {
    const PlanItem& own = request.plan.items[request.planned.item];
    std::vector<PlannedObject> found;
    if (own.mount != Mount::surface || own.on.empty()) return found;
    for (auto& planned : planned_objects(request.plan)) {
      const PlanItem& item = request.plan.items[planned.item];
      const bool waits = std::find(request.later.begin(), request.later.end(), planned.id) !=
                         request.later.end();
      if (waits && planned.id != request.object.id && item.mount == Mount::surface &&
          item.on == own.on && found.size() < most_together)
        found.push_back(std::move(planned));
    }
    return found;
  }

  static std::string together(const PlaceRequest& request) {
    const auto others = companions(request);
    if (others.empty()) return "";
    std::string text =
        "\nGive also \"others\", a list with the same members and \"id\" for each of these, which stand on "
        "the same thing:";
    for (const auto& other : others) {
      const PlanItem& item = request.plan.items[other.item];
      const Vec3 size = item.size.value_or(KindTable::built_in().get(item.category).size);
      text += "\n" + other.id + ": " + item.description + ", about " + design::size_text(size) + " m";
    }
    return text;
  }

  void keep_others(const PlaceRequest& request, design::PlaceReply& reply,
                   const Consultation& consultation) {
    if (reply.others.empty()) return;
    others_ = std::move(reply.others);
    others_prompt_ = consultation.prompt_sha256;
    others_scene_ = request.scene.objects;
  }

  Result<PlaceAdvice> ask(const PlaceRequest& request, Consultation& consultation) {
    auto question = place_question(request);
    if (!question) return question.error();
    consultation.prompt_sha256 = sha256_hex(question->messages.back().text);
    if (auto status = show_picture(request, *question, consultation); !status)
      return status.error();
    const bool located = options_.mode == ModelMode::fused;
    const auto read = [&](const std::string& text) {
      return design::read_place_reply(text, context_of(request));
    };
    auto reply = converse(*question, read, consultation);
    if (!reply) return reply.error();
    consultation.notes.insert(consultation.notes.end(), reply->repairs.begin(),
                              reply->repairs.end());
    if (!located) reply->advice.location.reset(), reply->advice.yaw.reset();
    keep_others(request, *reply, consultation);
    return std::move(reply->advice);
  }

  Result<Prompts::Slots> system_slots(const SceneText& text) const {
    auto vocabulary = prompts_.render("place-words", {});
    if (!vocabulary) return vocabulary.error();
    return Prompts::Slots{{"frame", text.frame()}, {"words", *std::move(vocabulary)}};
  }

  Result<ChatRequest> place_question(const PlaceRequest& request) const {
    const SceneText text(request.scene.room, options_.paper_frame);
    const bool sees_places = options_.mode != ModelMode::constraints;
    const auto system = system_slots(text);
    if (!system) return system.error();
    auto question = make_question(place_prompt(options_.mode), *system,
                                  {{"prompt", request.plan.prompt},
                                   {"room", text.room()},
                                   {"parts", text.parts()},
                                   {"placed", text.placed(request.scene.objects, sees_places)},
                                   {"later", later(request)},
                                   {"id", request.object.id},
                                   {"description", request.object.description},
                                   {"size", design::size_text(request.object.size)},
                                   {"mount", where(request)},
                                   {"refusals", refusals(request, text)},
                                   {"order", order(request) + together(request)}});
    if (!question) return question;
    question->schema = place_schema(options_);
    if (!companions(request).empty()) add_others(question->schema);
    question->schema_name = "placement";
    question->max_tokens = options_.place_tokens;
    question->cancel = request.cancel;
    return question;
  }

  Status show_picture(const PlaceRequest& request, ChatRequest& question,
                      Consultation& consultation) const {
    if (options_.mode == ModelMode::constraints || !request.marks || !options_.encode_picture)
      return {};
    const auto pictures = request.marks();
    if (!pictures) return pictures.error();
    std::string all;
    for (const auto& picture : *pictures) {
      auto encoded = options_.encode_picture(picture);
      if (!encoded) return encoded.error();
      all += *encoded;
      question.messages.back().images.push_back(*std::move(encoded));
    }
    consultation.image_sha256 = sha256_hex(all);
    return {};
  }

  static std::string where(const PlaceRequest& request) {
    const PlanItem& item = request.plan.items[request.planned.item];
    switch (item.mount) {
      case Mount::floor:
        return "on the floor";
      case Mount::wall:
        return "on a wall";
      case Mount::ceiling:
        return "under the ceiling";
      case Mount::surface:
        return item.on.empty() ? "on a table or cabinet" : "on " + item.on;
    }
    return "";
  }

  // Kinds with their numbers: enough to leave room for them.
  static std::string later(const PlaceRequest& request) {
    std::vector<std::pair<std::string, int>> kinds;
    for (const auto& id : request.later) {
      const std::string kind = id.substr(0, id.rfind('-'));
      const auto known = std::find_if(kinds.begin(), kinds.end(),
                                      [&](const auto& other) { return other.first == kind; });
      if (known != kinds.end())
        ++known->second;
      else if (kinds.size() < most_named_later)
        kinds.push_back({kind, 1});
    }
    std::vector<std::string> names;
    for (const auto& [kind, count] : kinds)
      names.push_back(count > 1 ? std::to_string(count) + " " + kind : kind);
    return names.empty() ? "nothing" : join(names, ", ");
  }

  std::string refusals(const PlaceRequest& request, const SceneText& text) const {
    const bool sees_places = options_.mode != ModelMode::constraints;
    std::string lines;
    for (std::size_t i = 0; i < request.refusals.size(); ++i) {
      lines += "An earlier answer did not work";
      if (i < request.earlier.size()) lines += " (" + text.answer(request.earlier[i]) + ")";
      lines += ": " + request.refusals[i] + "\n";
    }
    if (!request.objections.empty() && !request.earlier.empty() && request.standing_at)
      lines += "Your last answer (" + text.answer(request.earlier.back()) + ") puts it at " +
               (sees_places ? text.point(*request.standing_at) : "a place of its own") +
               ". Not all is as you said: " +
               join(request.objections, "; ") +
               ". Answer once more: change what should change, or repeat the answer if that will do.\n";
    if (!request.refusals.empty() && sees_places)
      lines +=
          "Free floor (shaded green in the picture): " + text.free_floor(request.free_floor) + "\n";
    return lines;
  }

  std::string order(const PlaceRequest& request) const {
    if (!options_.chooses_order || request.later.empty()) return "";
    std::vector<std::string> ids = request.later;
    if (ids.size() > most_offered) ids.resize(most_offered);
    return "Give also \"next\": which one shall be placed after this. Large things and those that "
           "others refer to come first. Of: " +
           join(ids, ", ") + ".";
  }

  // Asks, and asks again with what was wrong, until `read` can use an answer.
  template <typename Read>
  auto converse(ChatRequest& question, Read read, Consultation& consultation)
      -> decltype(read(std::string())) {
    for (int answer = 1;; ++answer) {
      auto reply = model_.chat(question);
      note_success(reply);
      if (!reply) return reply.error();
      consultation.calls += 1;
      consultation.input_tokens += reply->input_tokens;
      consultation.output_tokens += reply->output_tokens;
      consultation.seconds += reply->seconds;
      auto understood = read(reply->text);
      const std::string ending = reply->cut_off
                                     ? "the answer was cut off after " +
                                           std::to_string(question.max_tokens) + " tokens; be brief"
                                     : "";
      if (!ending.empty()) consultation.notes.push_back(ending);
      if (understood) return understood;
      std::string error = understood.error().message;
      if (!ending.empty()) error += "; " + ending;
      if (answer >= options_.answers) return Error{Error::Kind::invalid_input, error};
      consultation.notes.push_back("asked again: " + error);
      auto again = prompts_.render("again-user", {{"error", error}});
      if (!again) return again.error();
      question.messages.push_back(
          {ChatMessage::Role::assistant, shortened(reply->text, most_quoted), {}});
      question.messages.push_back({ChatMessage::Role::user, *std::move(again), {}});
      question.temperature = second_temperature;
    }
  }

  // A model that cannot be used, or fails again and again, is not asked any more.
  void note_success(const Result<ChatReply>& reply) {
    failures_ = reply ? 0 : failures_ + 1;
    if (reply || reply.error().kind == Error::Kind::cancelled) return;
    if (reply.error().kind == Error::Kind::unavailable || failures_ >= most_failures)
      model_is_lost_ = reply.error().message;
  }

  ChatModel& model_;
  std::unique_ptr<Designer> fallback_;
  Prompts prompts_;
  const KindTable& categories_;
  ModelDesignerOptions options_;
  Consultation planning_;
  std::map<std::string, std::string> others_;  ///< answers for things whose turn comes
  std::string others_prompt_;                  ///< hash of the question
  std::vector<Object> others_scene_;           ///< what stood then
  int failures_ = 0;           ///< calls that failed since the last answer
  std::string model_is_lost_;  ///< why it is not asked any more
};

}  // namespace

std::unique_ptr<Designer> make_model_designer(ChatModel& model, std::unique_ptr<Designer> fallback,
                                              Prompts prompts, const KindTable& categories,
                                              ModelDesignerOptions options) {
  return std::make_unique<ModelDesigner>(model, std::move(fallback), std::move(prompts), categories,
                                         std::move(options));
}

}  // namespace roomgen
