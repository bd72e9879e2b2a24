#include "maker_questions.h"
#include "maker_replies.h"
#include "roomgen/create/maker.h"

#include "description_words.h"
#include "chat/interview.h"
#include "kinds.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

class AskingMaker final : public Maker {
 public:
  AskingMaker(ChatModel& model, std::unique_ptr<Maker> fallback, Prompts prompts,
              ModelMakerOptions options)
      : interview_(model, std::move(prompts), options.answers),
        fallback_(std::move(fallback)),
        options_(std::move(options)) {}

  Result<Verdict> classify(const std::string& prompt) override {
    Question question{"create-classify-system", "create-classify-user"};
    question.user_slots = {{"prompt", shortened(prompt, max_prompt)}};
    question.schema = verdict_schema();
    question.schema_name = "verdict";
    question.max_tokens = options_.classify_tokens;
    question.cancel = options_.cancel;
    return consult(question, read_verdict_reply, "verdict",
                   [&] { return fallback_->classify(prompt); });
  }

  Result<std::vector<Description>> decompose(const std::string& prompt) override {
    if (options_.variant == Variant::no_decomposition) return std::vector{undivided(prompt)};
    Question question{"create-decompose-system", "create-decompose-user"};
    const std::string shown = shortened(prompt, max_prompt);
    question.user_slots = {{"prompt", shown}, {"kinds", kinds_text(options_.kinds)}};
    question.schema = decompose_schema();
    question.schema_name = "objects";
    question.max_tokens = options_.decompose_tokens;
    question.cancel = options_.cancel;
    const auto read = [&](const std::string& text) {
      return read_decompose_reply(text, shown, options_.kinds);
    };
    return consult(question, read, "decomposition", [&] { return fallback_->decompose(prompt); });
  }

  Result<shape::Program> generate(const MakeRequest& request) override {
    if (options_.variant == Variant::direct)
      return Error{Error::Kind::invalid_input,
                   "triangles are no program; ask for the mesh in the direct variant"};
    const Description wanted = wanted_of(request);
    const auto read = [&](const std::string& text) {
      return read_program_reply(text, wanted, request.seed);
    };
    return consult(program_question(request, wanted), read, "program",
                   [&] { return fallback_->generate(request); });
  }

  Result<shape::Shape> generate_mesh(const MakeRequest& request) override {
    if (options_.variant != Variant::direct) return evaluated(generate(request));
    if (request.earlier)
      return Error{Error::Kind::invalid_input, "an earlier program cannot be changed by triangles"};
    const Description& wanted = request.description;
    Question question{"create-mesh-system", "create-mesh-user"};
    question.user_slots = {{"prompt", words_of(wanted)}, {"description", description_text(wanted)}};
    question.schema = mesh_schema();
    question.schema_name = "mesh";
    question.max_tokens = options_.generate_tokens;
    question.cancel = request.cancel;
    const auto read = [&](const std::string& text) { return read_mesh_reply(text, wanted.noun); };
    return consult(question, read, "mesh", [&] { return evaluated(fallback_->generate(request)); });
  }

  // Each program is a conversation; rules, once they took over, answer at once.
  bool is_cheap() const override { return !interview_.lost().empty(); }
  bool fell_back() const override { return fell_back_; }

  std::vector<std::string> take_notes() override { return std::exchange(notes_, {}); }

 private:
  static std::string words_of(const Description& description) {
    return shortened(description.prompt.empty() ? description.noun : description.prompt,
                     max_prompt);
  }

  static Description undivided(const std::string& prompt) {
    Description whole;
    whole.prompt = shortened(prompt, max_prompt);
    whole.noun = shortened(whole.prompt, max_word);
    return whole;
  }

  static Result<shape::Shape> evaluated(const Result<shape::Program>& program) {
    if (!program) return program.error();
    return shape::evaluate_within(*program);
  }

  // A change may leave nothing of what was once described.
  Description wanted_of(const MakeRequest& request) const {
    const bool whole = options_.variant == Variant::no_decomposition || request.earlier;
    return whole ? undivided(words_of(request.description)) : request.description;
  }

  Question program_question(const MakeRequest& request, const Description& wanted) const {
    Question question{"create-generate-system",
                      request.earlier ? "create-refine-user" : "create-generate-user"};
    question.user_slots = {{"prompt", words_of(wanted)}};
    if (request.earlier) {
      question.user_slots["earlier"] = program_text(*request.earlier);
    } else {
      question.user_slots["description"] = description_text(wanted);
      question.user_slots["examples"] = examples_text(request.examples);
    }
    question.schema = program_schema();
    question.schema_name = "shape";
    question.max_tokens = options_.generate_tokens;
    question.cancel = request.cancel;
    return question;
  }

  // Asks the model while it is worth it, else the fallback. `what` the answer is, for people.
  template <typename Read, typename Fallback>
  auto consult(const Question& question, Read read, const std::string& what, Fallback fallback)
      -> decltype(fallback()) {
    if (interview_.lost().empty()) {
      auto answer = interview_.ask(question, read);
      note(interview_.take_notes());
      fell_back_ = !answer;
      if (answer || ends_the_work(answer.error())) return answer;
      note({"the model gave no " + what + " that can be used (" + answer.error().message +
            "); rules made this one"});
    } else {
      fell_back_ = true;
      note({"rules take over: " + interview_.lost()});
    }
    auto answer = fallback();
    note(fallback_->take_notes());
    return answer;
  }

  // Before it ever answered, what keeps the model from answering at all is worth knowing.
  bool ends_the_work(const Error& error) const {
    const bool spent = options_.budget_is_spent && options_.budget_is_spent();
    const bool unreachable = error.kind == Error::Kind::unavailable && !interview_.has_answered();
    return error.kind == Error::Kind::cancelled || spent || unreachable;
  }

  void note(const std::vector<std::string>& notes) {
    notes_.insert(notes_.end(), notes.begin(), notes.end());
  }

  Interview interview_;
  std::unique_ptr<Maker> fallback_;
  ModelMakerOptions options_;
  std::vector<std::string> notes_;
  bool fell_back_ = false;  ///< for the last step that was asked
};

}  // namespace

std::unique_ptr<Maker> make_model_maker(ChatModel& model, std::unique_ptr<Maker> fallback,
                                             Prompts prompts, ModelMakerOptions options) {
  if (const auto& kinds = ShapeKinds::built_in(); kinds && options.kinds.empty())
    for (const auto& [name, kind] : kinds->all()) options.kinds.push_back(name);
  return std::make_unique<AskingMaker>(model, std::move(fallback), std::move(prompts),
                                       std::move(options));
}

}  // namespace roomgen::create
