#include "mention_shape.h"

#include <algorithm>
#include <cmath>

#include "roomgen/scene/requirement.h"
#include "table_size.h"

namespace roomgen::brief {

namespace {

const Vec3 unknown_size(0.5, 0.5, 0.8);

void become(Mention& mention, const Kind& category) {
  mention.category = category.name;
  mention.known = true;
  mention.mount = category.mount;
  if (!mention.sized) mention.size = category.size;
}

// What nobody knows is as large as such things are.
void guess_size(Mention& mention, const KindTable& table) {
  const Kind& like = table.get(mention.category);
  mention.size = like.is_stand_in() ? like.size : unknown_size;
  if (like.is_stand_in()) mention.mount = like.mount;
}

// Metres that a thing is planned to be long, and that it hangs above the floor, whatever is told; verdicts go by that.
double planned_length(double told) { return std::clamp(told, 0.05, 10.0); }
double planned_height(double told) { return std::clamp(told, 0.0, 10.0); }

// A side that is told: at most so long, at least so long, or exactly.
void set_side(Mention& mention, int axis, const char* side, const language::Measure& measure,
              int value = 0) {
  using Limit = language::Measure::Limit;
  const double length = planned_length(measure.values[value]);
  double& planned = mention.size[axis];
  planned = measure.limit == Limit::most    ? std::min(planned, length)
            : measure.limit == Limit::least ? std::max(planned, length)
                                            : length;
  mention.lengths.push_back({side, measure.values[value], measure.limit});
}

// Width and depth, and perhaps height.
void set_sides(Mention& mention, const language::Measure& measure) {
  static constexpr const char* names[] = {"width", "depth", "height"};
  mention.lengths.clear();
  for (int i = 0; i < measure.count; ++i) set_side(mention, i, names[i], measure, i);
}

bool is_round(const ThingPhrase& phrase) {
  return std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(), [](const std::string& word) {
    return word == "round" || word == "circular" || word == "oval";
  });
}

// "a 65 inch TV"
bool is_diagonal(const Mention& mention) {
  const auto& words = built_in_vocabulary();
  return words && words->diagonals.count(mention.category) > 0;
}

// Of a screen of 16 to 9, as nearly all are.
language::Measure width_of_diagonal(language::Measure measure) {
  for (double& value : measure.values) value *= 16.0 / std::hypot(16.0, 9.0);
  return measure;
}

}  // namespace

// One length is the longer side, two are width and depth, unless it is said which.
void set_length(Mention& mention, const language::Measure& measure) {
  using Measure = language::Measure;
  if (measure.kind == Measure::Kind::area || measure.side == Measure::Side::distance) return;
  mention.sized = true;
  if (measure.kind == Measure::Kind::sides) return set_sides(mention, measure);
  switch (measure.side) {
    case Measure::Side::height:
    case Measure::Side::thickness:
      return set_side(mention, 2, "height", measure);
    case Measure::Side::depth:
      return set_side(mention, 1, "depth", measure);
    case Measure::Side::diameter:
      set_side(mention, 0, "diameter", measure);
      mention.size.y() = mention.size.x();
      return;
    case Measure::Side::width:
      return set_side(mention, 0, "width", measure);
    default:
      return set_side(mention, 0, "longer side", is_diagonal(mention) ? width_of_diagonal(measure) : measure);
  }
}

void set_hanging_height(Mention& mention, const language::Measure& measure) {
  mention.lengths.push_back({std::string(height_above_floor), measure.values[0], measure.limit});
}

std::optional<double> hanging_height(const Mention& mention) {
  for (const auto& length : mention.lengths)
    if (length.side == height_above_floor) return planned_height(length.metres);
  return std::nullopt;
}

void shape(Mention& mention, const ThingPhrase& phrase, const Vocabulary& words,
           const KindTable& table) {
  const Kind* category = table.find(mention.category);
  if (mention.known && category && is_round(phrase))
    if (const Kind* round = table.by_name(category->forms.round)) category = round;
  if (mention.known && category)
    become(mention, *category);
  else
    guess_size(mention, table);
  if (mention.known && is_round(phrase) && !table.get(mention.category).traits.round &&
      table.is_a(mention.category, "table"))
    mention.size.y() = mention.size.x() = std::max(0.5, 0.8 * mention.size.x());
  for (const auto& word : phrase.modifiers)
    if (const auto size = words.sizes.find(word); size != words.sizes.end()) {
      mention.size = mention.size.cwiseProduct(size->second);
      mention.sized = true;
    }
  if (table.is_a(mention.category, "table") && !table.is_a(mention.category, "desk")) mention.seats = phrase.seats;
  if (mention.seats > 0) {
    mention.size = table_for(mention.size, table.get(mention.category).traits.round, phrase.seats);
    mention.sized = true;
  }
  for (const auto& measure : phrase.measures) set_length(mention, measure);
  const auto said = [&](const char* word) {
    return std::find(phrase.modifiers.begin(), phrase.modifiers.end(), word) !=
           phrase.modifiers.end();
  };
  mention.varied = said("different") || said("mismatched") || said("various") || said("assorted");
  if (said("ceiling"))
    hang(mention, Mount::ceiling, table);
  else if (said("mounted") || said("wall") || said("floating"))
    hang(mention, Mount::wall, table);
}

Mention mention_for_people(const std::string& kind, int number, const Vocabulary& words,
                           const KindTable& table) {
  Mention mention;
  mention.category = mention.noun = mention.description = kind;
  mention.quantity = number;
  mention.source = Requirement::Source::person;
  shape(mention, ThingPhrase(), words, table);
  return mention;
}

void hang(Mention& mention, Mount where, const KindTable& table) {
  if (mention.mount == where) return;
  if (where == Mount::floor) {
    if (mention.mount != Mount::surface) return;
    // Cushions on the floor are floor cushions.
    if (const Kind* standing = table.by_name("floor " + mention.noun)) return become(mention, *standing);
    mention.mount = where;
    return;
  }
  const Forms& forms = table.get(mention.category).forms;
  if (const Kind* hanging = table.by_name(where == Mount::wall ? forms.wall : forms.ceiling))
    return become(mention, *hanging);
  if (mention.mount == Mount::surface || where == Mount::ceiling || !mention.known)
    mention.mount = where;
}

bool become_small(Mention& mention, const KindTable& table) {
  const Kind* kind = table.find(mention.category);
  for (int i = 0; kind && i < 4; ++i) {
    if (const Kind* small = table.by_name(kind->forms.small)) {
      if (i == 0) {
        become(mention, *small);
      } else {
        mention.mount = Mount::surface;
        mention.size *= std::min(1.0, (small->size.array() / mention.size.array()).minCoeff());
        mention.sized = true;
      }
      return true;
    }
    kind = kind->parent.empty() ? nullptr : table.find(kind->parent);
  }
  return false;
}

bool keeps_things(const std::string& category, const KindTable& table) {
  return table.is_any_of(category,
                         {"table", "storage", "kitchen unit", "kitchen island", "washbasin"});
}

bool needs_wall(const Mention& mention, const KindTable& table) {
  return table.is_any_of(mention.category, {"storage", "console table", "room divider", "desk"});
}

}  // namespace roomgen::brief
