#include "references.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <functional>

#include "roomgen/base/text.h"
#include "scene_nouns.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

constexpr double clearly_apart = 0.15;   // metres by which one is farther to a side than the others
constexpr double clearly_larger = 1.03;  // factor

std::string joined_ids(const std::vector<std::string>& ids) { return join(ids, ", "); }

std::vector<Object> all_objects(const EditText& text) {
  std::vector<Object> all = text.scene.objects;
  all.insert(all.end(), text.coming.begin(), text.coming.end());
  return all;
}

// Of several, those at the far end in a direction.
Result<std::vector<std::string>> farthest(const EditText& text, std::vector<std::string> ids, std::size_t count,
                                          const std::string& words, const std::function<double(const Object&)>& measure,
                                          const std::function<bool(double, double)>& clearly) {
  std::stable_sort(ids.begin(), ids.end(), [&](const std::string& a, const std::string& b) {
    return measure(*text.object(a)) > measure(*text.object(b));
  });
  if (count >= ids.size()) return ids;
  if (!clearly(measure(*text.object(ids[count - 1])), measure(*text.object(ids[count]))))
    return not_understood("\"" + words + "\" may be " + joined_ids(ids) +
                          ", which are much alike in that; say which one by its id");
  ids.resize(count);
  return ids;
}

double along(const EditText& text, const std::string& id, const Vec2& way) {
  return Vec2(text.object(id)->position.head<2>()).dot(way);
}

double spread(const EditText& text, const std::vector<std::string>& ids, const Vec2& way) {
  double least = 1e9, most = -1e9;
  for (const auto& id : ids) least = std::min(least, along(text, id, way)), most = std::max(most, along(text, id, way));
  return most - least;
}

// What stands in a line that runs up the picture is seen from in front of it, or of the desk that it stands on.
Vec2 way_to_side(const EditText& text, const std::vector<std::string>& ids, const Vec2& side) {
  const std::string& host = text.object(ids.front())->on;
  const bool is_shared =
      std::all_of(ids.begin(), ids.end(), [&](const std::string& id) { return text.object(id)->on == host; });
  const Object* under = is_shared && !host.empty() ? text.object(host) : nullptr;
  if (spread(text, ids, side) >= clearly_apart) return side;
  const double yaw = text.object(ids.front())->yaw;
  const bool look_alike = std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
    return text.object(id)->traits.front && std::abs(std::remainder(text.object(id)->yaw - yaw, 2.0 * pi)) < 0.2;
  });
  if (!under && !look_alike) return side;
  const Footprint area = footprint(under ? *under : *text.object(ids.front()));
  return -side.x() * area.x_axis() + side.y() * area.y_axis();
}

// The `count` farthest that way; below 0 the one of that place, counted from there.
Result<std::vector<std::string>> at_side(const EditText& text, std::vector<std::string> ids, int count,
                                         const std::string& words, const Vec2& way) {
  const auto measure = [&](const Object& object) { return Vec2(object.position.head<2>()).dot(way); };
  const auto clearly = [](double first, double second) { return first - second >= clearly_apart; };
  if (count >= 0) return farthest(text, std::move(ids), static_cast<std::size_t>(count), words, measure, clearly);
  const auto nth = static_cast<std::size_t>(-count);
  if (nth > ids.size()) return not_understood("\"" + words + "\": there are " + std::to_string(ids.size()));
  auto first = farthest(text, ids, nth, words, measure, clearly);
  if (!first) return first;
  return std::vector<std::string>{first->back()};
}

// "the chairs on the left": those before the widest gap between them.
Result<std::vector<std::string>> half_at_side(const EditText& text, std::vector<std::string> ids,
                                              const std::string& words, const Vec2& way) {
  std::sort(ids.begin(), ids.end(),
            [&](const std::string& a, const std::string& b) { return along(text, a, way) > along(text, b, way); });
  std::size_t widest = 1;
  const auto gap_before = [&](std::size_t i) { return along(text, ids[i - 1], way) - along(text, ids[i], way); };
  for (std::size_t i = 2; i < ids.size(); ++i)
    if (gap_before(i) > gap_before(widest) + 1e-6) widest = i;
  if (gap_before(widest) < clearly_apart || 2 * gap_before(widest) < spread(text, ids, way))
    return not_understood("it is not clear which of " + joined_ids(ids) + " are \"" + words + "\"");
  ids.resize(widest);
  return ids;
}

// Of three in a row the second.
Result<std::vector<std::string>> middle_of(const EditText& text, std::vector<std::string> ids,
                                           const std::string& words) {
  const Vec2 way = spread(text, ids, Vec2(1, 0)) >= spread(text, ids, Vec2(0, 1)) ? Vec2(1, 0) : Vec2(0, 1);
  std::sort(ids.begin(), ids.end(),
            [&](const std::string& a, const std::string& b) { return along(text, a, way) < along(text, b, way); });
  const std::size_t half = ids.size() / 2;
  const bool is_clear = ids.size() % 2 == 1 &&
                        along(text, ids[half], way) - along(text, ids[half - 1], way) >= clearly_apart &&
                        along(text, ids[half + 1], way) - along(text, ids[half], way) >= clearly_apart;
  if (!is_clear)
    return not_understood("\"" + words + "\" may be " + joined_ids(ids) + ", none of which is clearly in the middle");
  return std::vector<std::string>{ids[half]};
}

Result<std::vector<std::string>> narrowed(const EditText& text, const NamedThing& thing, std::vector<std::string> ids) {
  const std::string words = text.words_from(thing.begin, thing.end);
  const std::size_t count = thing.count > 0 ? static_cast<std::size_t>(thing.count) : 1;
  if (thing.place) {
    const auto n = static_cast<std::size_t>(*thing.place);
    if (n > ids.size()) return not_understood("\"" + words + "\": there are " + std::to_string(ids.size()));
    return std::vector<std::string>{ids[n - 1]};
  }
  if (thing.middle && ids.size() > 1) return middle_of(text, std::move(ids), words);
  if (thing.side && ids.size() > 1) {
    const Vec2 way = way_to_side(text, ids, *thing.side);
    const bool is_counted = thing.nth && thing.further;
    const bool is_half = thing.plural && thing.count == 0 && !is_counted;
    if (is_half) return half_at_side(text, ids, words, way);
    return at_side(text, std::move(ids), is_counted ? -*thing.nth : static_cast<int>(count), words, way);
  }
  if (thing.size != 0.0 && ids.size() > 1)
    return farthest(text, std::move(ids), count, words,
                    [&](const Object& object) {
                      const double axis = std::abs(thing.size);
                      const bool hangs = object.mount == Mount::wall || object.mount == Mount::ceiling;
                      const double size = axis == 3   ? (hangs ? bottom(object) : object.size.z())
                                          : axis == 2 ? object.size.x()
                                                      : object.size.prod();
                      return thing.size > 0 ? size : 1.0 / size;
                    },
                    [](double first, double second) { return first >= clearly_larger * second; });
  return ids;
}

// Words of looks that some of them are described by tell these from the others.
std::vector<std::string> described(const EditText& text, const NamedThing& thing, std::vector<std::string> ids) {
  for (const auto& look : thing.looks) {
    if (text.edits.existing.count(look)) continue;
    std::vector<std::string> such;
    for (const auto& id : ids) {
      const Object& object = *text.object(id);
      auto known = words(object.description + " " + object.category);
      for (const auto& [stuff, finish] : object.asset.finish)
        for (auto& word : words(finish)) known.push_back(word);
      if (std::find(known.begin(), known.end(), look) != known.end()) such.push_back(id);
    }
    if (!such.empty()) ids = std::move(such);
    else if (thing.size == 0.0 && ids.size() > 1) return {};
  }
  return ids;
}

constexpr double about_so_long = 0.1;  // share by which a thing that is told by its size may differ

bool measures_so(const Object& object, const language::Measure& measure) {
  using Side = language::Measure::Side;
  const auto is = [](double side, double said) { return std::abs(side - said) <= about_so_long * said; };
  const auto& [x, y, z] = std::tuple(object.size.x(), object.size.y(), object.size.z());
  const double said = measure.values[0];
  if (measure.kind == language::Measure::Kind::sides)
    return (is(x, said) && is(y, measure.values[1])) || (is(y, said) && is(x, measure.values[1]));
  if (measure.side == Side::height || measure.side == Side::thickness) return is(z, said);
  if (measure.side == Side::width || measure.side == Side::diameter) return is(x, said);
  if (measure.side == Side::depth) return is(y, said);
  return is(std::max(x, y), said) || is(z, said);
}

// "the 3 m sofa"
std::vector<std::string> measured(const EditText& text, const NamedThing& thing, std::vector<std::string> ids) {
  for (const auto& measure : thing.measures)
    std::erase_if(ids, [&](const std::string& id) { return !measures_so(*text.object(id), measure); });
  return ids;
}

// "the stool and the plant on it": what the words before name.
std::vector<std::string> named_before(const EditText& text, std::size_t at) {
  for (std::size_t i = 0; i < at; ++i) {
    const auto thing = named_thing_at(text, i);
    if (!thing || thing->end > at || thing->which != NamedThing::Which::definite || !thing->kind.category ||
        thing->bare)
      continue;
    if (auto ids = meant(text, *thing)) return *std::move(ids);
  }
  return {};
}

Result<std::vector<std::string>> meant_by_pronoun(const EditText& text, const NamedThing& thing) {
  const std::string words = text.words_from(thing.begin, thing.end);
  auto known = !text.latest.empty()         ? text.latest
               : !text.recall.added.empty() ? text.recall.added
                                            : text.recall.touched;
  if (known.empty()) known = named_before(text, thing.begin);
  if (known.empty()) return not_understood("nothing was spoken of before that \"" + words + "\" could mean");
  if (thing.plural || known.size() == 1) return known;
  return not_understood("\"" + words + "\" may be " + joined_ids(known) + "; say which one");
}

// "the other one": those of this text, or else those of the edit before, are not meant.
void leave_out_those_spoken_of(const EditText& text, std::vector<std::string>& ids) {
  for (const auto* known : {&text.mentioned, &text.recall.touched}) {
    const std::size_t before = ids.size();
    std::vector<std::string> others = ids;
    std::erase_if(others, [&](const std::string& id) { return std::count(known->begin(), known->end(), id) > 0; });
    if (others.empty() || others.size() == before) continue;
    ids = std::move(others);
    return;
  }
}

// Has the number of what fits anything to say?
Result<std::vector<std::string>> by_number(const EditText& text, const NamedThing& thing,
                                           std::vector<std::string> ids) {
  const std::string words = text.words_from(thing.begin, thing.end);
  const double of_all = thing.share * static_cast<double>(ids.size());
  if (of_all != std::floor(of_all))
    return not_understood("\"" + words + "\": there are " + std::to_string(ids.size()) +
                          ", which cannot be divided so");
  const auto wanted = static_cast<std::size_t>(of_all > 0.0 ? of_all : thing.count);
  using Ids = std::vector<std::string>;
  if (!thing.any && (thing.which == Which::all || (thing.plural && thing.which == Which::definite))) {
    if (thing.count == 0 || wanted == ids.size()) return ids;
    return not_understood("\"" + words + "\": there are " + std::to_string(ids.size()) + ": " + joined_ids(ids));
  }
  if (thing.any && wanted <= ids.size()) return Ids(ids.end() - static_cast<std::ptrdiff_t>(wanted), ids.end());
  if (ids.size() == 1) return ids;
  std::vector<std::string> spoken_of;
  for (const auto& id : ids)
    if (std::count(text.mentioned.begin(), text.mentioned.end(), id)) spoken_of.push_back(id);
  if (spoken_of.size() == 1 && thing.which == Which::definite) return spoken_of;
  return not_understood("\"" + words + "\" may be " + joined_ids(ids) + "; say which one, by its id or its place");
}

}  // namespace

// "the lamp" may be any lamp, whichever kind people mean first by the word.
std::vector<std::string> fitting(const EditText& text, const NamedThing& thing) {
  if (thing.by_meaning) return things_by_meaning(text, thing.kind.name);
  std::vector<std::string> exact, by_end, general, by_word, broader;
  for (const auto& object : all_objects(text)) {
    if (thing.which == Which::everything) {
      exact.push_back(object.id);
      continue;
    }
    if (!thing.kind.category || (thing.number && !object.id.ends_with("-" + std::to_string(*thing.number)))) continue;
    const auto all = words(object.category);
    const auto said = words(thing.kind.name);
    const bool ends_so = said.size() <= all.size() && std::equal(said.rbegin(), said.rend(), all.rbegin());
    const bool has_words = std::all_of(said.begin(), said.end(), [&](const std::string& word) {
      return std::find(all.begin(), all.end(), word) != all.end();
    });
    if (object.category == thing.kind.name || object.category == thing.kind.category->name) exact.push_back(object.id);
    else if (ends_so) by_end.push_back(object.id);
    else if (text.kinds.is_a(object.category, thing.kind.category->name)) general.push_back(object.id);
    else if (has_words) by_word.push_back(object.id);
    else if (said.size() > 1 && all.back() == said.back() &&
             text.kinds.is_a(thing.kind.category->name, object.category))
      broader.push_back(object.id);
  }
  // "the chaise" is the chaise longue before it is any chair.
  const auto begins_so = [&](const std::string& id) {
    return words(text.object(id)->category).front() == thing.kind.name;
  };
  if (exact.empty() && by_end.empty() && std::any_of(by_word.begin(), by_word.end(), begins_so) && !thing.number) {
    std::erase_if(by_word, [&](const std::string& id) { return !begins_so(id); });
    if (general.empty() || thing.kind.category->name != thing.kind.name) return by_word;
  }
  // "any seat" is a sofa too, though no kind of seat in the table.
  if (exact.empty() && by_end.empty() && !general.empty() && !thing.number)
    for (auto& id : things_by_meaning(text, thing.kind.name))
      if (std::find(general.begin(), general.end(), id) == general.end()) general.push_back(std::move(id));
  for (auto* ids : {&exact, &by_end, &general})
    if (!ids->empty()) return std::move(*ids);
  if (!by_word.empty() || !thing.kind.category || thing.number) return by_word;
  // "the desk chair", where there is but a chair.
  return broader.empty() ? things_by_meaning(text, thing.kind.name) : broader;
}

Result<std::vector<std::string>> meant(const EditText& text, const NamedThing& thing,
                                       const std::vector<std::string>* among) {
  if (thing.which == Which::pronoun) return meant_by_pronoun(text, thing);
  auto ids = fitting(text, thing);
  if (among)
    std::erase_if(ids,
                  [&](const std::string& id) { return std::find(among->begin(), among->end(), id) == among->end(); });
  if (thing.other) leave_out_those_spoken_of(text, ids);
  const std::string words = text.words_from(thing.begin, thing.end);
  if (ids.empty()) return not_understood("there is no \"" + words + "\" in the room");
  if (thing.nth && thing.which == Which::definite && *thing.nth > static_cast<int>(ids.size()))
    return not_understood("\"" + words + "\": there are no more than " + joined_ids(ids));
  ids = measured(text, thing, described(text, thing, std::move(ids)));
  if (ids.empty()) return not_understood("nothing in the room is known to be \"" + words + "\"");
  auto few = narrowed(text, thing, std::move(ids));
  if (!few) return few;
  if (thing.which == Which::everything) return few;
  return by_number(text, thing, *std::move(few));
}

}  // namespace roomgen
