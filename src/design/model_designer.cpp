#include "roomgen/design/designer.h"

#include <algorithm>
#include <map>
#include <set>

#include "asset_choice.h"
#include "asset_making.h"
#include "base/sha256.h"
#include "brief/said_wish.h"
#include "chat/interview.h"
#include "chat/patience.h"
#include "model_questions.h"
#include "place_reply.h"
#include "plan/claim.h"
#include "plan_reply.h"
#include "planned_place.h"
#include "roomgen/base/text.h"
#include "roomgen/chat/chat_model.h"
#include "together.h"

namespace roomgen {

namespace {

constexpr int program_tokens = 5000, most_making_tokens = 32'000;

class ModelDesigner : public Designer {
 public:
  ModelDesigner(ChatModel& model, std::unique_ptr<Designer> fallback, Prompts prompts,
                const KindTable& categories, ModelDesignerOptions options)
      : model_(model),
        fallback_(std::move(fallback)),
        categories_(categories),
        options_(std::move(options)),
        prompts_(prompts),
        questions_(std::move(prompts), options_) {
    forget();
  }

  Result<Plan> plan(const PlanRequest& request) override {
    const brief::Brief brief = brief_of(request);
    auto question = questions_.to_plan(request, brief);
    if (!question) return question.error();
    planning_ = {};
    forget();
    bool is_told = false;  // what is forgotten goes back once
    const auto read = [&](const std::string& text) -> Result<Reading<design::PlanReply>> {
      auto answer = design::read_plan_reply(text, request, brief, categories_);
      if (!answer) return answer.error();
      if (auto status = design::check_floor(answer->plan, categories_); !status)
        return status.error();
      std::string missing;
      if (!std::exchange(is_told, true)) {
        const auto claimed = plan::claim(answer->plan, brief, categories_);
        missing = plan::objection(request, claimed, brief, answer->plan);
      }
      return Reading<design::PlanReply>{*std::move(answer), {}, std::move(missing), true};
    };
    auto reply = talk_in(planning_).talk(*std::move(question), read, planning_.notes);
    if (!reply && ends_the_room(reply.error())) return reply.error();
    if (reply) {
      const auto claimed = plan::claim(reply->plan, brief, categories_);
      plan::fulfil(request, claimed, brief, categories_, reply->plan);
      note(reply->plan, reply->repairs);
      note(reply->plan, planning_.notes);
      idea_ = std::move(reply->concept_text);
      if (brief::reading_of(request)) note(reply->plan, brief.notes);
      return std::move(reply->plan);
    }
    auto plan = fallback_->plan(request);
    if (!plan)
      return with_context(plan.error(), "the model gave no plan that can be used (" + reply.error().message + ")");
    planning_.fell_back = true;
    planning_.notes.push_back(reply.error().message);
    note(*plan, {"the model gave no plan that can be used (" + reply.error().message +
                 "); rules made this one"});
    return plan;
  }

  Consultation plan_consultation() const override { return planning_; }

  bool chooses() const override { return options_.chooses_assets && patience_.lost().empty(); }

  Result<AssetChoices> choose(const ChoiceRequest& request) override {
    AssetChoices answer;
    const design::Call talk = talk_about(request.sheets, answer.consultation);
    auto choices = design::ask_for_assets(request, talk, answer.consultation.notes);
    if (choices) answer.choices = *std::move(choices);
    if (auto status = end(choices, "the library chooses", answer.consultation); !status)
      return status.error();
    return answer;
  }

  bool makes() const override { return options_.makes_assets && chooses(); }

  Result<ThingsMade> make(const MakingRequest& request) override {
    ThingsMade answer;
    design::Call talk = talk_about(request.sheets, answer.consultation);
    const int wanted = program_tokens * static_cast<int>(request.things.size());
    talk.max_tokens = std::max(talk.max_tokens, std::min(wanted, most_making_tokens));
    auto programs = design::ask_for_programs(request, talk, answer.consultation.notes);
    if (programs) answer.programs = *std::move(programs);
    const char* instead = request.again ? "things stay as they were" : "rules make them";
    if (auto status = end(programs, instead, answer.consultation); !status) return status.error();
    return answer;
  }

  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    Consultation consultation;
    if (auto advice = told_already(request, consultation.notes)) return *std::move(advice);
    // What lies on a thing of its group is no question: it goes there as such things do.
    if (request.lost_place_in_group && request.object.mount == Mount::surface)
      return design::place_as_planned(request);
    if (patience_.lost().empty()) {
      auto advice = ask(request, consultation);
      if (advice) {
        advice->consultation = std::move(consultation);
        return advice;
      }
      if (advice.error().kind == Error::Kind::cancelled || is_spent()) return advice;
      consultation.notes.push_back(advice.error().message);
    }
    auto advice = fallback_->place(request);
    // One answer that is of no use costs its thing; the room goes on while the model does.
    if (!advice && patience_.lost().empty())
      return Error{Error::Kind::invalid_input,
                   join(consultation.notes, "; ") + "; " + advice.error().message};
    if (!advice) return with_context(advice.error(), patience_.lost());
    consultation.fell_back = true;
    if (!patience_.lost().empty()) consultation.notes.push_back("rules take over: " + patience_.lost());
    advice->consultation = std::move(consultation);
    return advice;
  }

 private:
  // Of an earlier room.
  void forget() {
    idea_.clear(), told_.clear(), told_elsewhere_.clear();
    for (const auto& [id, text] : options_.places) told_[id] = {text, "", nullptr};
  }

  static void note(Plan& plan, const std::vector<std::string>& notes) {
    plan.notes.insert(plan.notes.end(), notes.begin(), notes.end());
  }

  // What the prompt asks for holds whoever plans.
  brief::Brief brief_of(const PlanRequest& request) const {
    const auto& kinds = brief::built_in_room_kinds();
    return kinds ? brief::brief_of(request, *kinds, categories_) : brief::Brief();
  }

  // Before anything is placed, what keeps the model from answering at all is worth knowing.
  bool ends_the_room(const Error& error) const {
    return error.kind == Error::Kind::unavailable || error.kind == Error::Kind::cancelled ||
           is_spent();
  }

  // With the pictures, as far as there are any. The consultation must outlive it.
  design::Call talk_about(const std::function<Result<std::vector<Image>>()>& sheets,
                          Consultation& consultation) {
    design::Call talk = talk_in(consultation);
    if (auto status = show(sheets, talk.images, consultation); !status)
      consultation.notes.push_back("there are no pictures: " + status.error().message);
    return talk;
  }

  // The consultation must outlive it.
  design::Call talk_in(Consultation& consultation) {
    design::Call talk{{}, {}, prompts_, options_.answers, options_.plan_tokens, makes()};
    talk.chat = [&](ChatRequest question) {
      if (consultation.prompt_sha256.empty())
        consultation.prompt_sha256 = sha256_hex(question.messages.back().text);
      auto reply = call(question, consultation);
      if (reply) count(*reply, consultation);
      return reply;
    };
    return talk;
  }

  // Without an answer something else is done instead, unless nothing may be asked any more.
  template <typename Answer>
  Status end(const Result<Answer>& answer, const std::string& instead,
             Consultation& consultation) const {
    consultation.fell_back = !answer;
    if (answer) return {};
    if (answer.error().kind == Error::Kind::cancelled || is_spent()) return answer.error();
    consultation.notes.push_back(answer.error().message + "; " + instead);
    return {};
  }

  bool is_spent() const { return options_.budget_is_spent && options_.budget_is_spent(); }

  design::PlaceReplyContext context_of(const PlaceRequest& request) const {
    return {request.scene, request.object, options_.paper_frame,
            options_.chooses_order ? request.later : std::vector<std::string>()};
  }

  /// An answer for a thing whose turn comes later.
  struct Told {
    std::string text, prompt;  ///< the hash of the question
    std::shared_ptr<const std::vector<Object>> then;  ///< what stood, where the place is one on a thing; else null
    std::optional<Vec2> in_row = {};  ///< PlaceAdvice::spread
  };

  // What was answered together with another thing, while what carries both stands as it did.
  std::optional<PlaceAdvice> told_already(const PlaceRequest& request,
                                          std::vector<std::string>& notes) {
    const auto found = told_.find(request.object.id);
    if (found == told_.end()) return std::nullopt;
    const Told told = std::move(found->second);
    told_.erase(found);
    const bool again = !request.refusals.empty() || !request.objections.empty();
    if (again || (told.then && !stand_as_then(*told.then, request.scene))) return std::nullopt;
    auto reply = design::read_place_reply(told.text, context_of(request));
    if (!reply) return notes.push_back(reply.error().message), std::nullopt;
    if (options_.mode != ModelMode::fused) reply->advice.location.reset(), reply->advice.yaw.reset();
    if (reply->advice.yaw && lies_across(request))
      reply->advice.yaw = wrap_angle(*reply->advice.yaw + 0.5 * pi);
    if (told.in_row) reply->advice.location = told.in_row, reply->advice.spread = true;
    Consultation& consultation = reply->advice.consultation;
    consultation.prompt_sha256 = told.prompt;
    consultation.notes = std::move(reply->repairs);
    consultation.notes.insert(consultation.notes.begin(), "answered together with others");
    return std::move(reply->advice);
  }

  // What has no front may lie across what the list of things said of it: it is as long as it was told there.
  static bool lies_across(const PlaceRequest& request) {
    const auto& told = request.plan.items[request.planned.item].size;
    const Vec2 real = request.object.size.head<2>();
    return told && !request.object.traits.front &&
           (real - told->head<2>()).norm() > (real - Vec2(told->y(), told->x())).norm() + 1e-6;
  }

  // What was told once is not told again.
  design::ModelQuestions::Known known(const PlaceRequest& request) {
    design::ModelQuestions::Known known{idea_, {}, {}};
    for (const auto& [id, told] : told_) known.answered.insert(id);
    if (request.elsewhere)
      for (auto& one : request.elsewhere())
        if (told_elsewhere_.insert(one).second) known.news.push_back(std::move(one));
    return known;
  }

  static bool stand_as_then(const std::vector<Object>& then, const Scene& scene) {
    return std::all_of(then.begin(), then.end(), [&](const Object& one) {
      return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& now) {
        return now.id == one.id && now.position == one.position && now.yaw == one.yaw;
      });
    });
  }

  void keep_others(const PlaceRequest& request, const design::PlaceReply& reply,
                   const Consultation& consultation) {
    const bool on_thing = request.object.mount == Mount::surface;
    const auto then = on_thing ? std::make_shared<const std::vector<Object>>(request.scene.objects) : nullptr;
    for (const auto& [id, text] : reply.others) told_[id] = {text, consultation.prompt_sha256, then};
  }

  void spread(const PlaceRequest& request, design::PlaceReply& reply) {
    std::vector<std::pair<std::string, PlaceAdvice>> answers = {{request.object.id, reply.advice}};
    for (const auto& [id, text] : reply.others)
      if (auto other = design::read_place_reply(text, context_of(request)))
        answers.emplace_back(id, std::move(other->advice));
    for (const auto& [id, place] : design::places_in_rows(answers, request.scene))
      if (id == request.object.id) reply.advice.location = place, reply.advice.spread = true;
      else told_[id].in_row = place;
  }

  Result<PlaceAdvice> ask(const PlaceRequest& request, Consultation& consultation) {
    auto question = questions_.to_place(request, known(request));
    if (!question) return question.error();
    if (auto status = show(request.marks, question->messages.back().images, consultation); !status)
      return status.error();
    const bool located = options_.mode == ModelMode::fused;
    const auto read = [&](const std::string& text) -> Result<Reading<design::PlaceReply>> {
      auto answer = design::read_place_reply(text, context_of(request));
      if (!answer) return answer.error();
      return Reading<design::PlaceReply>{*std::move(answer), {}, {}, true};
    };
    auto reply = talk_in(consultation).talk(*std::move(question), read, consultation.notes);
    if (!reply) return reply.error();
    consultation.notes.insert(consultation.notes.end(), reply->repairs.begin(),
                              reply->repairs.end());
    if (!located) reply->advice.location.reset(), reply->advice.yaw.reset();
    keep_others(request, *reply, consultation);
    if (located && request.object.mount == Mount::surface) spread(request, *reply);
    return std::move(reply->advice);
  }

  Status show(const std::function<Result<std::vector<Image>>()>& drawer,
              std::vector<std::string>& images, Consultation& consultation) const {
    if (options_.mode == ModelMode::constraints || !drawer || !options_.encode_picture || is_blind_)
      return {};
    const auto pictures = drawer();
    if (!pictures) return pictures.error();
    std::string all;
    for (const auto& picture : *pictures) {
      auto encoded = options_.encode_picture(picture);
      if (!encoded) return encoded.error();
      all += *encoded;
      images.push_back(*std::move(encoded));
    }
    consultation.image_sha256 = sha256_hex(all);
    return {};
  }

  // A model without eyes goes on without pictures: the text says where everything stands.
  Result<ChatReply> call(ChatRequest question, Consultation& consultation) {
    if (is_blind_)
      for (auto& message : question.messages) message.images.clear();
    auto reply = model_.chat(question);
    if (!reply && reply.error().kind == Error::Kind::invalid_input && !is_blind_) {
      is_blind_ = true;
      const std::string note = reply.error().message + "; it is asked without them from now on";
      consultation.notes.push_back(note);
      consultation.image_sha256.clear();
      log(options_.log, LogLevel::warning, note);
      for (auto& message : question.messages) message.images.clear();
      reply = model_.chat(question);
    }
    patience_.note(reply);
    return reply;
  }

  static void count(const ChatReply& reply, Consultation& consultation) {
    consultation.calls += 1;
    consultation.input_tokens += reply.input_tokens;
    consultation.output_tokens += reply.output_tokens;
    consultation.seconds += reply.seconds;
  }

  ChatModel& model_;
  std::unique_ptr<Designer> fallback_;
  const KindTable& categories_;
  const ModelDesignerOptions options_;
  const Prompts prompts_;
  const design::ModelQuestions questions_;
  Consultation planning_;
  std::map<std::string, Told> told_;  ///< by id
  std::set<std::string> told_elsewhere_;
  std::string idea_;  ///< what the room shall be like, in the model's words
  Patience patience_;
  bool is_blind_ = false;  ///< the model takes no pictures
};

}  // namespace

std::unique_ptr<Designer> make_model_designer(ChatModel& model, std::unique_ptr<Designer> fallback,
                                              Prompts prompts, const KindTable& categories,
                                              ModelDesignerOptions options) {
  const bool one_by_one = options.mode != ModelMode::fused || options.paper_frame || options.chooses_order;
  if (one_by_one) options.steps = ModelSteps::objects;
  return std::make_unique<ModelDesigner>(model, std::move(fallback), std::move(prompts), categories,
                                         std::move(options));
}

}  // namespace roomgen
