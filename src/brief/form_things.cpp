// The clauses of brief.json that are about things: what they are and how many.
#include "form_things.h"

#include <algorithm>

#include "mention_shape.h"
#include "prompt_passes.h"
#include "reply_measure.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

using MeasureLimit = language::Measure::Limit;
using TokenRuns = std::vector<language::Run>;

constexpr std::size_t most_things = 120;
constexpr double most_counted = 10'000.0;

class ThingReader {
 public:
  explicit ThingReader(FormThings& things)
      : form_(things.form), brief_(form_.brief), things_(things), talk_(things.talk) {}

  void read() {
    const auto things = form_.root["things"].elements(10'000);
    for (const auto& thing : things) {
      if (brief_.mentions.size() >= most_things) {
        form_.repair("only the first " + std::to_string(most_things) + " of " +
                     std::to_string(things.size()) + " things were read");
        break;
      }
      read_thing(thing);
    }
  }

 private:
  void read_thing(const FormNode& node) {
    const std::string name = lower(node["name"].text());
    if (name.empty()) return form_.problem(node["name"], "is missing");
    TokenRuns said = form_.next_words(node["words"]);
    if (said.empty()) said = form_.quotes.find_from(name, 0);
    if (said.empty())
      return form_.problem(node["words"],
                           "nothing in the wish says that there is a \"" + name + "\"");
    const ThingPhrase phrase = phrase_of(node, name, said.front().begin);
    const auto whole = things_.find_id(node["some_of"].text());
    const bool are_the_rest =
        whole && phrase.count > 0 && brief_.mentions[*whole].quantity <= phrase.count;
    const auto index = are_the_rest ? whole : talk_.refer(phrase, 0);
    if (!index) return;
    Mention& mention = brief_.mentions[*index];
    if (are_the_rest)
      for (const auto& look : phrase.modifiers) talk_.describe(*index, look);
    else
      finish(node, phrase, mention);
    if (whole && !are_the_rest) talk_.adopt(*index, *whole);
    keep(node, *index, said);
    hear_looks(node, mention, said.front().begin);
  }

  // As the grammar of rules would hand it over.
  ThingPhrase phrase_of(const FormNode& node, const std::string& name, std::uint32_t near) {
    ThingPhrase phrase;
    const auto counted = form_.hear(node["count_words"], Heard::As::count, "", near);
    const MeasureLimit bound = bound_in_form(node["bound"]);
    phrase.count = whole_number(node["count"]);
    phrase.least = phrase.count, phrase.most = std::max(phrase.count, whole_number(node["most"]));
    if (phrase.most == phrase.least)
      phrase.least = phrase.most = 0;
    else
      phrase.count = (phrase.least + phrase.most) / 2;
    phrase.counted = phrase.count > 1 || (phrase.count == 1 && !counted.empty());
    phrase.at_least = bound == MeasureLimit::least, phrase.at_most = bound == MeasureLimit::most;
    phrase.article = true;
    FormName named = name_in_form(name, form_.table);
    // A model spells what it means: its minbar is no minibar.
    if (named.kind.basis == NounBasis::spelling) named = {};
    phrase.kind = named.kind;
    phrase.naming = named.sort;
    if (phrase.kind.length == 0) phrase.noun = name;
    for (const auto& look : node["looks"].elements(most_of_a_thing)) {
      std::string word = lower((look.json->is_object() ? look["look"] : look).text());
      if (!word.empty() && std::find(phrase.modifiers.begin(), phrase.modifiers.end(), word) ==
                               phrase.modifiers.end())
        phrase.modifiers.push_back(std::move(word));
    }
    return phrase;
  }

  void finish(const FormNode& node, const ThingPhrase& phrase, Mention& mention) const {
    if (!phrase.naming.empty())
      mention.description = join(phrase.naming, " ") + " " + mention.description;
    mention.owner = node["owner"].text();
    for (const auto& size : node["sizes"].elements(most_of_a_thing)) set_size(size, mention);
    if (const auto shape = lower(node["formation"]["shape"].text()); !shape.empty())
      mention.formation = formation_of(node["formation"], shape);
  }

  static Formation formation_of(const FormNode& node, const std::string& shape) {
    using Shape = Formation::Shape;
    Formation formation{std::min(whole_number(node["rows"]), 100),
                        std::min(whole_number(node["columns"]), 100)};
    formation.shape = shape.starts_with("circ")  ? Shape::circle
                      : shape.starts_with("arc") ? Shape::arc
                      : shape.starts_with("isl") ? Shape::islands
                                                 : Shape::rows;
    return formation;
  }

  void set_size(const FormNode& node, Mention& mention) const {
    using Side = language::Measure::Side;
    static const std::map<std::string, Side, std::less<>> sides = {{"width", Side::width},
                                                                   {"depth", Side::depth},
                                                                   {"height", Side::height},
                                                                   {"diameter", Side::diameter},
                                                                   {"longer side", Side::unsaid},
                                                                   {"length", Side::unsaid},
                                                                   {"", Side::unsaid}};
    language::Measure measure;
    measure.values[0] = node["m"].number().value_or(0.0);
    measure.limit = bound_in_form(node["bound"]);
    const std::string side = lower(node["side"].text());
    if (!(measure.values[0] > 0.0 && measure.values[0] < 1000.0))
      return form_.problem(node["m"], "must be metres, greater than 0");
    if (side == height_above_floor) return set_hanging_height(mention, measure);
    const auto known = sides.find(side);
    if (known == sides.end())
      return form_.problem(node["side"], "\"" + side + "\" is no side of a thing");
    measure.side = known->second;
    set_length(mention, measure);
  }

  // Under its id, with the words that name and count it.
  void keep(const FormNode& node, std::size_t index, const TokenRuns& said) {
    Mention& mention = brief_.mentions[index];
    for (const auto& run : said) add({form_.entry(run, Heard::As::thing, "")}, mention);
    const std::uint32_t near = said.empty() ? 0 : said.front().begin;
    add(form_.hear(node["count_words"], Heard::As::count, "", near), mention);
    if (!said.empty()) mention.sentence = sentence_of(near);
    const std::string id = node["id"].text();
    things_.ids.emplace(id.empty() ? "t" + std::to_string(things_.read.size() + 1) : id, index);
    things_.read.push_back({index, node});
  }
  static void add(const std::vector<std::size_t>& heard, Mention& mention) {
    for (const std::size_t one : heard)
      if (!is_among(mention.heard, one)) mention.heard.push_back(one);
  }
  int sentence_of(std::uint32_t token) const {
    return static_cast<int>(std::count_if(
        brief_.tokens.begin(), brief_.tokens.begin() + token,
        [](const language::Token& one) { return one.kind == language::Token::Kind::stop; }));
  }

  void hear_looks(const FormNode& node, Mention& mention, std::uint32_t near) {
    for (const auto& look : node["looks"].elements(most_of_a_thing))
      if (look.json->is_object())
        add(form_.hear(look["words"], Heard::As::attribute, lower(look["look"].text()), near),
            mention);
    for (const auto& part : node["parts"].elements(most_of_a_thing)) {
      const std::string what = lower(part["part"].text());
      if (what.empty()) continue;
      if (std::find(mention.parts.begin(), mention.parts.end(), what) == mention.parts.end())
        mention.parts.push_back(what);
      add(form_.hear(part["words"], Heard::As::attribute, what, near), mention);
    }
    for (const auto& size : node["sizes"].elements(most_of_a_thing))
      add(form_.hear(size["words"], Heard::As::attribute, said_length, near), mention);
  }

  Form& form_;
  Brief& brief_;
  FormThings& things_;
  Discourse& talk_;
};

}  // namespace

int whole_number(const FormNode& node) {
  const auto value = node.number();
  if (!value && node) return count_in(*node.json).value_or(0);
  return static_cast<int>(std::clamp(value.value_or(0.0), 0.0, most_counted));
}

Mount mount_named(const std::string& text, Mount otherwise) {
  for (const Mount mount : {Mount::floor, Mount::wall, Mount::ceiling, Mount::surface})
    if (text == name(mount)) return mount;
  return otherwise;
}

void read_form_things(Form& form, const Vocabulary& words) {
  FormThings things(form, words);
  ThingReader(things).read();
  read_form_places(things);
  read_form_limits(things);
}

}  // namespace roomgen::brief
