#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_values.h"
#include "base/resource.h"
#include "base/sha256.h"
#include "brief/picture_text.h"
#include "brief/said_wish.h"
#include "chat/interview.h"
#include "chat/loose_json.h"
#include "language/function_word.h"
#include "model_questions.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"

namespace roomgen {

namespace {

constexpr std::size_t most_told = 8;  // problems that a model is told of at once
constexpr std::size_t longest_shown = 8000, longest_scale = 300;  // bytes, of a picture
constexpr double least_understood =
    0.4;  // of the words: with less a reading is worth another question

// Of the schema of the file what a model answers: members that need not be there are written by
// rules.
void keep_required(Json& schema) {
  if (schema.is_object() && schema.contains("properties") && schema.contains("required")) {
    Json kept = Json::object();
    for (const auto& [key, value] : schema["properties"].items())
      if (std::find(schema["required"].begin(), schema["required"].end(), Json(key)) !=
          schema["required"].end())
        kept[key] = value;
    schema["properties"] = std::move(kept);
  }
  for (auto& value : schema)
    if (value.is_structured()) keep_required(value);
}

const Json& answer_schema() {
  static const Json schema = [] {
    Json json = json_literal(*resource("docs/brief.schema.json"));
    for (const char* key : {"$schema", "$id", "title", "description"}) json.erase(key);
    keep_required(json);
    return json;
  }();
  return schema;
}

// With what a model says of pictures, which it says first.
Json schema_for(std::size_t pictures) {
  Json schema = answer_schema();
  if (pictures == 0) return schema;
  const Json whole = json_literal(*resource("docs/brief.schema.json"));
  schema["properties"]["pictures"] = whole["properties"]["pictures"];
  schema["properties"]["pictures"].erase("maxItems");
  schema["required"].insert(schema["required"].begin(), "pictures");
  return schema;
}

/// What a model says of the pictures of a wish.
struct ShownWish {
  std::string prompt;               ///< the words, and a line for each picture
  std::vector<std::string> scales;  ///< notes of what lengths are reckoned from
};

// The words "Image 1" ask for nothing, which the form gets to say.
Result<ShownWish> shown_wish(Json& form, const PlanRequest& request) {
  const Json* list = member(form, {"pictures", "images"});
  std::vector<std::string> shown;
  ShownWish wish;
  for (std::size_t i = 0; i < request.pictures.size(); ++i) {
    const Json entry = list && list->is_array() && i < list->size() ? (*list)[i] : Json();
    const std::string number = std::to_string(i + 1);
    const auto said = [&](const char* key) {
      return text_in(entry.is_object() ? member(entry, {key}) : nullptr);
    };
    shown.push_back(entry.is_string() ? entry.get<std::string>() : said("says"));
    if (trim(shown.back()).empty())
      return Error{Error::Kind::invalid_input,
                   "give \"pictures\" with what image " + number + " shows in its \"says\""};
    shown.back() = shortened(shown.back(), longest_shown);
    if (const auto scale = said("scale"); !scale.empty())
      wish.scales.push_back("image " + number + ": scale: " + shortened(scale, longest_scale));
    if (!form["talk"].is_array()) form["talk"] = Json::array();
    form["talk"].push_back({{"as", "talk"}, {"words", {"Image " + number}}});
  }
  wish.prompt = brief::with_pictures(request.prompt, shown);
  return wish;
}

std::string relation_names() {
  std::vector<std::string> names;
  for (const auto& spelling : relation_spellings())
    if (name(spelling.kind) == spelling.text)
      names.push_back("\"" + std::string(spelling.text) + "\"");
  return join(names, ", ");
}

class ModelReader : public Reader {
 public:
  ModelReader(ChatModel& model, Prompts prompts, const KindTable& categories,
              ModelReaderOptions options)
      : prompts_(prompts),
        interview_(model, std::move(prompts), options.answers),
        categories_(categories),
        options_(std::move(options)) {}

  Status read(PlanRequest& request) override {
    consultation_ = {};
    const auto& kinds = brief::built_in_room_kinds();
    if (!kinds) return kinds.error();
    const bool is_empty = trim(request.prompt).empty() && request.pictures.empty();
    if (is_empty || request.prompt.size() > max_prompt_bytes)
      return {};  // designers say what is wrong
    auto wish_text = wish_of(request);
    if (!wish_text) return wish_text.error();
    Question question{.system = "read-system", .user = "read-user"};
    question.system_slots = {{"relations", relation_names()}};
    question.user_slots = {{"wish", *std::move(wish_text)}};
    question.images = request.pictures;
    question.schema = schema_for(request.pictures.size());
    question.schema_name = "brief";
    question.max_tokens = options_.tokens;
    question.cancel = request.cancel;
    consultation_.prompt_sha256 = sha256_hex(request.prompt);
    auto wish = interview_.ask(question, [&](const std::string& text) {
      return understood(text, request, *kinds);
    });
    consultation_.notes = interview_.take_notes();
    if (!wish) return without_model(request, wish.error(), *kinds);
    for (const auto& note : consultation_.notes) wish->brief.notes.push_back("reading: " + note);
    if (wish->dwelling) wish->dwelling->notes = wish->brief.notes;
    request.prompt = wish->prompt;
    request.said = std::make_shared<const brief::SaidWish>(*std::move(wish));
    return {};
  }

  Consultation consultation() const override { return consultation_; }

 private:
  Result<std::string> wish_of(const PlanRequest& request) const {
    if (request.pictures.empty()) return request.prompt;
    auto told = prompts_.render("read-pictures", {{"count", design::counted_pictures(request)}});
    if (!told) return told;
    return (trim(request.prompt).empty() ? "(no words)" : request.prompt) + "\n\n" + *told;
  }

  Result<Reading<brief::SaidWish>> understood(const std::string& text, const PlanRequest& request,
                                              const brief::RoomKinds& kinds) {
    ++consultation_.calls;
    auto found = find_json(text, {{"room", "things"}, {"rooms", "absences", "objects"}});
    if (!found) return found.error();
    const auto shown = shown_wish(found->json, request);
    if (!shown) return shown.error();
    auto reading = brief::wish_from_json(found->json, shown->prompt, kinds, categories_);
    for (const auto& scale : shown->scales) reading.wish.brief.notes.push_back(scale);
    if (reading.is_empty)
      return Error{Error::Kind::invalid_input,
                   reading.problems.empty()
                       ? "it says nothing of the wish; give its \"room\" and \"things\""
                       : join(reading.problems, "; ")};
    found->repairs.insert(found->repairs.end(), reading.repairs.begin(), reading.repairs.end());
    auto& problems = reading.problems;
    if (const auto lost = words_of_no_clause(reading.wish); !lost.empty())
      problems.insert(problems.begin(), "no clause quotes these words of the wish: " + lost);
    if (problems.size() > most_told) problems.resize(most_told);
    return Reading<brief::SaidWish>{std::move(reading.wish), std::move(found->repairs),
                                    join(problems, "; ")};
  }

  // Where so much is left out that little was read.
  static std::string words_of_no_clause(const brief::SaidWish& wish) {
    std::vector<bool> heard(wish.brief.tokens.size(), false);
    const auto mark = [&](const std::vector<brief::HeardWords>& all) {
      for (const auto& words : all)
        std::fill(heard.begin() + words.tokens.begin, heard.begin() + words.tokens.end, true);
    };
    mark(wish.brief.heard);
    for (std::size_t i = 0; wish.dwelling && i < wish.dwelling->rooms.size(); ++i)
      mark(wish.dwelling->rooms[i].brief.heard);
    std::vector<std::string> lost;
    std::size_t words = 0;
    for (std::size_t i = 0; i < heard.size(); ++i) {
      const language::Token& token = wish.brief.tokens[i];
      if (token.kind != language::Token::Kind::word || language::is_function_word(token)) continue;
      ++words;
      if (!heard[i]) lost.push_back(token.text);
    }
    const bool is_little =
        static_cast<double>(lost.size()) > (1.0 - least_understood) * static_cast<double>(words);
    return is_little ? shortened(join(lost, " "), 300) : "";
  }

  Status without_model(PlanRequest& request, const Error& error, const brief::RoomKinds& kinds) {
    const bool is_spent = options_.budget_is_spent && options_.budget_is_spent();
    if (error.kind == Error::Kind::unavailable || error.kind == Error::Kind::cancelled ||
        is_spent || options_.no_fallback)
      return with_context(error, "reading the wish");
    if (!request.pictures.empty())
      return Error{error.kind, "the pictures of the wish were not read: " + error.message +
                                   "; name a model that takes pictures, or leave them out"};
    consultation_.fell_back = true;
    auto wish = brief::wish_by_rules(request.prompt, kinds, categories_);
    const std::string note = "the model gave no reading of the wish that can be used (" +
                             error.message + "); rules read it";
    wish.brief.notes.push_back(note);
    if (wish.dwelling) wish.dwelling->notes.push_back(note);
    request.said = std::make_shared<const brief::SaidWish>(std::move(wish));
    return {};
  }

  const Prompts prompts_;
  Interview interview_;
  const KindTable& categories_;
  const ModelReaderOptions options_;
  Consultation consultation_;
};

}  // namespace

std::unique_ptr<Reader> make_model_reader(ChatModel& model, Prompts prompts,
                                          const KindTable& categories, ModelReaderOptions options) {
  return std::make_unique<ModelReader>(model, std::move(prompts), categories, std::move(options));
}

Result<Json> brief_json(const PlanRequest& request) {
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds) return kinds.error();
  if (const auto* read = brief::reading_of(request)) return read->form;
  return brief::wish_by_rules(request.prompt, *kinds, KindTable::built_in()).form;
}

}  // namespace roomgen
