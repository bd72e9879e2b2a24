#include "choice.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "brief/room_kinds.h"
#include "roomgen/base/text.h"

namespace roomgen::book {

namespace {

// What the terms are worth, by judgement: of another kind of room than is wished for is only what
// nothing else serves.
constexpr double of_kind = 20.0, of_first_name = 1.0, of_type = 1.0, of_said_name = 3.0,
                 of_further_word = 2.5, of_size = 4.0, of_people = 3.0, of_word = 2.0,
                 of_thing = 1.0;
constexpr double most_of_words = 8.0, most_of_things = 6.0;

bool is_set(const Parameter& parameter, const Values& values) {
  return values.count(parameter.name) > 0;
}

// Does the smaller room hold the usual one, whichever way it lies?
bool holds(const Vec2& room, const Vec2& usual) {
  constexpr double tolerance = 0.15;
  const Vec2 one(room.maxCoeff(), room.minCoeff()), other(usual.maxCoeff(), usual.minCoeff());
  return ((one - other).array() >= -tolerance).all() ||
         (room.prod() >= usual.prod() && one.y() >= 0.85 * other.y());
}

void set_by_size(const Design& design, const Vec2& size, Values& values) {
  constexpr int steps = 40;
  for (int step = steps; step >= 0; --step) {
    Values tried = values;
    for (const auto& parameter : design.parameters)
      if (!is_set(parameter, values))
        tried[parameter.name] =
            std::round(parameter.least + (parameter.most - parameter.least) * step / steps);
    if (step > 0 && !holds(size, usual_size(design, tried))) continue;
    values = tried;
    return;
  }
}

std::set<std::string> things_of(const Design& design) {
  std::set<std::string> names;
  const auto add = [&](const Json& thing) {
    if (thing.is_object() && thing.contains("name") && thing["name"].is_string())
      names.insert(lower(thing["name"].get<std::string>()));
  };
  for (const auto& group : design.body.value("groups", Json::array()))
    if (group.is_object())
      for (const auto& thing : group.value("things", Json::array())) add(thing);
  for (const auto& object : design.body.value("objects", Json::array())) {
    add(object);
    if (object.is_object())
      for (const auto& top : object.value("on_top", Json::array())) add(top);
  }
  return names;
}

/// What a wish says, as words between spaces.
std::string padded(const std::string& text) {
  return " " + join(words(text), " ") + " ";
}

// Of the wish's kind, rather by the very name that the wish has for it.
double kind_score(const Design& design, const Wanted& wanted, const std::string& wish) {
  double best = 0.0;
  for (std::size_t i = 0; i < design.rooms.size(); ++i) {
    const std::string name = brief::room_name(design.rooms[i]);
    if (meant_room(name) != wanted.type) continue;
    const bool is_said = wish.find(" " + name + " ") != std::string::npos;
    double score = of_kind + (i == 0 ? of_first_name : 0.0) + (name == wanted.type ? of_type : 0.0);
    if (is_said)
      score += of_said_name + of_further_word * static_cast<double>(words(name).size() - 1);
    best = std::max(best, score);
  }
  return best;
}

double size_score(const Design& design, const Values& values, const std::optional<Vec2>& size) {
  if (!size) return 0.0;
  const Vec2 usual = usual_size(design, values);
  const auto sorted = [](const Vec2& v) { return Vec2(v.maxCoeff(), v.minCoeff()); };
  const Vec2 has = sorted(*size), least = sorted(design.least), most = sorted(design.most);
  const double off =
      std::abs(std::log(size->prod() / usual.prod())) +
      std::abs(std::log((has.x() / has.y()) / (sorted(usual).x() / sorted(usual).y())));
  const bool is_within =
      (has.array() >= least.array() - 0.05).all() && (has.array() <= most.array() + 0.05).all();
  return (is_within ? of_size : 0.0) - 2.0 * std::min(off, 2.0);
}

double people_score(const Design& design, const brief::Brief& brief) {
  if (brief.people == 0) return 0.0;
  for (const auto& parameter : design.parameters)
    if (parameter.name == people_parameter)
      return brief.people >= parameter.least && brief.people <= parameter.most ? of_people
                                                                               : -of_people;
  return 0.0;
}

double word_score(const Design& design, const Wanted& wanted, const std::string& wish) {
  double score = 0.0;
  for (const auto& word : design.words)
    if (wish.find(padded(word)) != std::string::npos) score += of_word;
  for (const auto& style : wanted.brief.styles)
    if (std::find(design.words.begin(), design.words.end(), style) != design.words.end())
      score += of_word;
  return std::min(score, most_of_words);
}

double thing_score(const Design& design, const brief::Brief& brief, const KindTable& kinds) {
  const auto names = things_of(design);
  double score = 0.0;
  for (const auto& mention : brief.mentions) {
    const bool has = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return name == mention.category || name == mention.noun || kinds.is_a(name, mention.category);
    });
    if (has) score += of_thing;
  }
  return std::min(score, most_of_things);
}

}  // namespace

Values values_for(const Design& design, const Wanted& wanted, const KindTable& kinds) {
  Values values;
  for (const auto& parameter : design.parameters) {
    double said = 0.0;
    if (parameter.name == people_parameter) said = wanted.brief.people;
    for (const auto& mention : wanted.brief.mentions)
      if (mention.counted && kinds.is_any_of(mention.category, parameter.counts))
        said = std::max<double>(said, mention.quantity);
    if (said > 0.0) values[parameter.name] = std::clamp(said, parameter.least, parameter.most);
  }
  if (wanted.size) set_by_size(design, *wanted.size, values);
  for (const auto& [name, value] : default_values(design)) values.try_emplace(name, value);
  return values;
}

std::vector<Candidate> candidates(const std::vector<const Design*>& designs, const Wanted& wanted,
                                  const KindTable& kinds) {
  const std::string wish = " " + brief::room_name(brief::words_of(wanted.brief)) + " ";
  std::vector<Candidate> all;
  for (const Design* design : designs) {
    Candidate one;
    one.design = design, one.values = values_for(*design, wanted, kinds);
    const double kind = kind_score(*design, wanted, wish),
                 size = size_score(*design, one.values, wanted.size),
                 people = people_score(*design, wanted.brief),
                 word = word_score(*design, wanted, wish),
                 thing = thing_score(*design, wanted.brief, kinds);
    one.is_of_kind = kind >= of_kind;
    one.things = thing;
    one.score = kind + size + people + word + thing;
    one.why = "kind " + format_number(kind, 1) + ", size " + format_number(size, 1) + ", people " +
              format_number(people, 1) + ", words " + format_number(word, 1) + ", things " +
              format_number(thing, 1);
    all.push_back(std::move(one));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  return all;
}

}  // namespace roomgen::book
