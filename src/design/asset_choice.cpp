#include "asset_choice.h"

#include <algorithm>
#include <map>
#include <set>

#include "asset_text.h"
#include "base/json_values.h"
#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

using Take = AssetChoice::Kind;

constexpr std::size_t longest_text = 400;  // bytes
constexpr std::size_t most_problems = 20;
constexpr double shortest_side = 0.005, longest_side = 20.0;  // metres

// What making is good for, by who does it.
constexpr const char* made_by_itself =
    "What you want to be made you write yourself, in one further answer, as programs of solids with "
    "colours, materials and patterns, and you see it drawn. So make what gives this room its "
    "character and is not in stock, above all what the wish names: what rules made of the words "
    "seldom is it at a glance. Common furniture in stock looks better than what is made.";
constexpr const char* made_by_rules =
    "What is made is plainer than what is in stock: make a thing where nothing offered is what it "
    "should be.";

const std::vector<std::string> list_keys = {"choices", "choice", "items", "assets"};
const std::vector<std::string> item_keys = {"item", "id", "number", "row"};
const std::vector<std::string> take_keys = {"take",  "choice", "candidate",
                                            "asset", "pick",   "label"};
const std::vector<std::string> choice_words_keys = {"words", "description", "search", "query"};
const std::vector<std::string> choice_size_keys = {"size cm", "size"};
const std::vector<std::string> paint_keys = {"paint", "finish", "colour", "color"};
const std::vector<std::string> why_keys = {"why", "reason", "reasoning"};

/// Words for what is no asset.
const std::map<std::string, Take, std::less<>>& kind_words() {
  static const std::map<std::string, Take, std::less<>> words = {
      {"search", Take::search},       {"words", Take::search},   {"other", Take::search},
      {"make", Take::make},           {"made", Take::make},      {"create", Take::make},
      {"leave out", Take::leave_out}, {"omit", Take::leave_out}, {"none", Take::leave_out},
      {"drop", Take::leave_out}};
  return words;
}

const Json& answer_schema() {
  static const Json schema = json_literal(R"({"type": "object", "additionalProperties": false,
    "properties": {"choices": {"type": "array", "items": {"type": "object", "additionalProperties": false,
      "properties": {"item": {"type": "string"}, "take": {"type": "string"}, "words": {"type": "string"},
        "size_cm": {"anyOf": [{"type": "null"},
          {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}]},
        "paint": {"type": "string"}, "why": {"type": "string"}},
      "required": ["item", "take", "words", "size_cm", "paint", "why"]}}},
    "required": ["choices"]})");
  return schema;
}

std::string said_in(const Json& json, const std::vector<std::string>& keys) {
  const Json* value = member(json, keys);
  if (!value) return "";
  if (value->is_number_integer()) return std::to_string(value->get<long long>());
  return value->is_string()
             ? shortened(std::string(trim(value->get_ref<const std::string&>())), longest_text)
             : "";
}

/// Reads the choices of one answer.
class ChoiceReader {
 public:
  ChoiceReader(const ChoiceRequest& request, ReadChoices& read) : request_(request), read_(read) {}

  void read(const Json& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
      read_one(list[i], "/choices/" + std::to_string(i));
  }

  // {"7": "7b", "8": {"take": "make", ...}}
  void read_map(const Json& map) {
    for (const auto& [key, value] : map.items()) {
      Json one = value.is_object() ? value : Json{{"take", value}};
      if (!member(one, item_keys)) one["item"] = key;
      read_one(one, "/choices/" + key);
    }
  }

 private:
  void problem(const std::string& place, const std::string& what) {
    if (read_.problems.size() < most_problems) read_.problems.push_back(place + ": " + what);
  }

  void read_one(const Json& given, const std::string& place) {
    const Json json = given.is_string() ? Json{{"take", given}} : given;
    if (!json.is_object()) return problem(place, "is no choice");
    const std::string take = lower(said_in(json, take_keys));
    const auto offer = offer_of(said_in(json, item_keys), take);
    if (!offer)
      return problem(place + "/item",
                     "\"" + said_in(json, item_keys) + "\" is no item of the list");
    if (!answered_.insert(*offer).second) {
      read_.repairs.push_back(place + ": item " + request_.offers[*offer].id +
                              " was chosen for before; the first counts");
      return;
    }
    AssetChoice choice;
    choice.offer = *offer;
    if (!read_take(take, place, choice)) return;
    choice.words = said_in(json, choice_words_keys);
    choice.paint = said_in(json, paint_keys);
    choice.reason = said_in(json, why_keys);
    if (const Json* size = member(json, choice_size_keys)) choice.size = read_size(*size, place);
    const bool has_words = !choice.words.empty() || choice.kind != Take::search;
    if (!has_words) return problem(place + "/words", "a search needs words");
    read_.choices.push_back(std::move(choice));
  }

  // By its number, else by the label of what is taken.
  std::optional<std::size_t> offer_of(std::string item, const std::string& take) const {
    while (!item.empty() && (item.back() == '.' || item.back() == ' ')) item.pop_back();
    const auto& offers = request_.offers;
    for (std::size_t i = 0; i < offers.size(); ++i)
      if (offers[i].id == item) return i;
    for (std::size_t i = 0; i < offers.size() && item.empty(); ++i)
      for (std::size_t a = 0; a < offers[i].assets.size(); ++a)
        if (offers[i].label(a) == take) return i;
    return std::nullopt;
  }

  bool read_take(const std::string& take, const std::string& place, AssetChoice& choice) {
    const AssetOffer& offer = request_.offers[choice.offer];
    const std::string plain = join(words(take), " ");
    for (std::size_t a = 0; a < offer.assets.size(); ++a) {
      const std::string label = offer.label(a);
      if (join(words(take), "") == label || plain == label.substr(offer.id.size()))
        return choice.asset = a, true;
    }
    const auto kind = kind_words().find(plain);
    if (kind != kind_words().end()) choice.kind = kind->second;
    const bool is_over = choice.kind == Take::search && request_.again;
    if (kind != kind_words().end() && !is_over) return true;
    const std::string last = offer.assets.empty() ? "" : offer.label(offer.assets.size() - 1);
    const std::string there =
        last.empty() ? "nothing on the sheet" : offer.label(0) + " to " + last;
    problem(place + "/take",
            is_over ? "\"search\": it was searched again already; take one of " + there
                    : "\"" + take + "\" is not on the sheet; item " + offer.id + " has " + there);
    return false;
  }

  std::optional<Vec3> read_size(const Json& json, const std::string& place) {
    if (json.is_null()) return std::nullopt;
    if (const auto size = brief::size_in(json, {shortest_side, longest_side})) return size;
    read_.repairs.push_back(place +
                            "/size_cm: three sides in centimetres were expected; left as offered");
    return std::nullopt;
  }

  const ChoiceRequest& request_;
  ReadChoices& read_;
  std::set<std::size_t> answered_;
};

// Those of this answer, and the earlier ones for what it leaves out.
void add_earlier(const std::vector<AssetChoice>& earlier, std::vector<AssetChoice>& choices) {
  for (const auto& choice : earlier)
    if (std::none_of(choices.begin(), choices.end(),
                     [&](const auto& own) { return own.offer == choice.offer; }))
      choices.push_back(choice);
  std::sort(choices.begin(), choices.end(),
            [](const auto& a, const auto& b) { return a.offer < b.offer; });
}

void tell_missing(const ChoiceRequest& request, ReadChoices& read) {
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < request.offers.size(); ++i)
    if (std::none_of(read.choices.begin(), read.choices.end(),
                     [&](const auto& choice) { return choice.offer == i; }))
      missing.push_back(request.offers[i].id);
  if (!missing.empty())
    read.problems.push_back("/choices: nothing usable is said of item " + join(missing, ", "));
}

Question question_of(const ChoiceRequest& request, bool makes_itself) {
  Question question;
  question.system = "choose-system";
  question.user = "choose-user";
  std::vector<std::string> offers;
  for (const auto& offer : request.offers)
    offers.push_back(offer_text(request.plan, offer, !makes_itself));
  const std::string again = "These were searched again as you said; there is no further search.";
  question.user_slots = {{"prompt", request.plan.prompt},
                         {"room", room_line(request.plan.room)},
                         {"making", makes_itself ? made_by_itself : made_by_rules},
                         {"again", request.again ? again : ""},
                         {"offers", join(offers, "\n")}};
  question.schema = answer_schema();
  question.schema_name = "choices";
  question.cancel = request.cancel;
  return question;
}

}  // namespace

Result<ReadChoices> read_choices(std::string_view text, const ChoiceRequest& request,
                                 const std::vector<AssetChoice>& earlier) {
  auto found = find_json(text, {{"choices"}, list_keys});
  if (!found) return found.error();
  const Json* list = member(found->json, list_keys);
  ReadChoices result{{}, std::move(found->repairs), {}};
  ChoiceReader reader(request, result);
  if (list && list->is_array())
    reader.read(*list);
  else
    reader.read_map(list && list->is_object() ? *list : found->json);
  if (result.choices.empty() && earlier.empty())
    return Error{Error::Kind::invalid_input,
                 "the answer chooses nothing; give \"choices\": [{\"item\": \"1\", \"take\": "
                 "\"1a\", …}, …]; " +
                     join(result.problems, "; ")};
  add_earlier(earlier, result.choices);
  tell_missing(request, result);
  return result;
}

Result<std::vector<AssetChoice>> ask_for_assets(const ChoiceRequest& request, const Call& call,
                                                std::vector<std::string>& notes) {
  std::vector<AssetChoice> so_far;
  const auto reader = [&](const std::string& text) {
    using Read = Reading<std::vector<AssetChoice>>;
    auto read = read_choices(text, request, so_far);
    if (!read) return Result<Read>(read.error());
    so_far = read->choices;
    return Result<Read>(
        Read{std::move(read->choices), std::move(read->repairs), join(read->problems, "; ")});
  };
  return call.ask(question_of(request, call.makes_itself), reader, notes);
}

}  // namespace roomgen::design
