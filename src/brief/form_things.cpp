// The clauses of brief.json that are about things: what they are, how many, and how they stand.
#include <algorithm>
#include <cmath>
#include <limits>

#include "brief_form.h"
#include "discourse.h"
#include "kinds/noun_kind.h"
#include "mention_shape.h"
#include "placement_phrase.h"
#include "prompt_passes.h"
#include "reply_measure.h"
#include "roomgen/base/text.h"
#include "scene/relation_named.h"
#include "scene/room_part.h"

namespace roomgen::brief {

namespace {

using MeasureLimit = language::Measure::Limit;
using TokenRuns = std::vector<language::Run>;

constexpr std::size_t most_things = 120, most_of_a_thing = 24;
constexpr double most_counted = 10'000.0;

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

/// What a relation is to.
struct FormTarget {
  std::size_t mention = Demand::none;
  int nth = -1;
  std::optional<PlacePhrase> place;
  std::string part;  ///< how plans name the place, where one name does
};

class FormThings {
 public:
  FormThings(Form& form, const Vocabulary& words)
      : form_(form),
        brief_(form.brief),
        lexicon_{words, form.table, form.kinds.get(form.brief.type)},
        talk_(lexicon_, brief_) {}

  void read() {
    const auto things = form_.root["things"].elements(10'000);
    // Of equal words those of a relation count before those of a thing.
    for (const auto& thing : things)
      for (const auto& relation :
           thing["relations"].elements(form_.is_rules ? 10 * most_of_a_thing : 0))
        form_.hear_as_one(relation, Heard::As::relation, 0);
    for (const auto& thing : things) {
      if (brief_.mentions.size() >= most_things) {
        form_.repair("only the first " + std::to_string(most_things) + " of " +
                     std::to_string(things.size()) + " things were read");
        break;
      }
      if (form_.is_rules)
        read_as_known(thing);
      else
        read_thing(thing);
    }
    for (const auto& [mention, node] : read_) {
      if (form_.is_rules)
        read_place_as_known(mention, node);
      else
        read_place(mention, node);
    }
    for (const auto& absence : form_.root["absences"].elements(most_of_a_thing))
      read_absence(absence);
    for (const auto& limit : form_.root["limits"].elements(most_of_a_thing)) read_limit(limit);
    if (form_.is_rules) read_rest_as_known(form_.root["rules"]);
  }

 private:
  // --- What is there
  // ------------------------------------------------------------------------------

  void read_thing(const FormNode& node) {
    const std::string name = lower(node["name"].text());
    if (name.empty()) return form_.problem(node["name"], "is missing");
    TokenRuns said = form_.next_words(node["words"]);
    if (said.empty()) said = form_.quotes.find_from(name, 0);
    if (said.empty())
      return form_.problem(node["words"],
                           "nothing in the wish says that there is a \"" + name + "\"");
    const ThingPhrase phrase = phrase_of(node, name, said.front().begin);
    const auto whole = find_id(node["some_of"].text());
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
    if (!form_.is_rules && named.kind.basis == NounBasis::spelling) named = {};
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
    ids_.emplace(id.empty() ? "t" + std::to_string(read_.size() + 1) : id, index);
    read_.push_back({index, node});
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

  static bool is_id(const std::string& text) {
    return text.size() > 1 && text[0] == 't' && text.find_first_not_of("0123456789", 1) == text.npos;
  }
  std::optional<std::size_t> find_id(const std::string& id) const {
    const auto known = ids_.find(id);
    return known == ids_.end() ? std::nullopt : std::optional(known->second);
  }

  // --- How things stand
  // ---------------------------------------------------------------------------

  void read_place(std::size_t index, const FormNode& node) {
    Mention& mention = brief_.mentions[index];
    const std::uint32_t near = near_of(mention);
    if (node["formation"]["words"])
      mention.formation_heard = form_.hear_as_one(node["formation"], Heard::As::relation, near);
    const FormNode mount = node["mount"];
    const std::string where =
        lower((mount && mount.json->is_object() ? mount["on"] : mount).text());
    if (const Mount told = mount_named(where, Mount::surface); told != Mount::surface) {
      hang(mention, told, form_.table);
      if (mention.mount == told)
        mention.mount_heard = form_.hear_as_one(mount, Heard::As::relation, near);
    }
    for (const auto& relation : node["relations"].elements(most_of_a_thing))
      read_relation(index, relation, near);
  }
  std::uint32_t near_of(const Mention& mention) const {
    return mention.heard.empty() ? 0 : brief_.heard[mention.heard.front()].tokens.begin;
  }

  void read_relation(std::size_t index, const FormNode& node, std::uint32_t near) {
    const std::string said = join(split_blanks(lower(node["relation"].text())), " ");
    auto placement = placement_named(said);
    if (!placement)
      return form_.problem(node["relation"],
                           "\"" + said + "\" is no relation; use one of those that were told");
    const auto target = target_of(node["to"], *placement);
    if (!target && !is_id(node["to"].text()) && form_.remark(node, near)) return;
    if (!target)
      return form_.problem(node["to"], "\"" + node["to"].text() +
                                           "\" is neither the id of a thing nor a part of the room");
    const std::size_t heard = form_.hear_as_one(node, Heard::As::relation, near);
    if (node["denied"].flag()) return deny(index, *placement, *target, heard);
    talk_.told_by(heard);
    const std::size_t before = number_of_clauses();
    say(index, node, *placement, *target);
    if (const int each = whole_number(node["each"]); each > 0) share(index, each, *target, heard);
    const bool is_of_another =
        target->mention != index && is_named(*target) && !node["m"].number().value_or(0.0);
    if (number_of_clauses() == before && is_of_another)
      talk_.add(index, {placement->relations.front(), target->mention, target->part, false});
    if (number_of_clauses() == before && heard != HeardWords::none)
      form_.entry(brief_.heard[heard].tokens, Heard::As::room, said_remark);
    talk_.told_by(HeardWords::none);
  }
  static std::vector<std::string> split_blanks(const std::string& text) {
    auto pieces = split(text, ' ');
    std::erase(pieces, "");
    return pieces;
  }
  std::size_t number_of_clauses() const {
    std::size_t number = brief_.shared_out.size();
    for (const auto& mention : brief_.mentions)
      number += mention.demands.size() + (mention.mount_heard != HeardWords::none) +
                (mention.formation_heard != HeardWords::none);
    return number;
  }

  std::optional<Placement> placement_named(const std::string& said) const {
    const auto phrase = lexicon_.words.placements.find(said);
    if (phrase != lexicon_.words.placements.end() && !phrase->second.relations.empty())
      return phrase->second;
    const auto kind = relation_named(said);
    if (!kind) return std::nullopt;
    return Placement{{*kind}};
  }

  // A thing by its id or name, else a part of the room.
  std::optional<FormTarget> target_of(const FormNode& node, const Placement& placement) {
    std::string text = lower(node.text());
    FormTarget target;
    if (const auto hash = text.rfind(" #"); hash != std::string::npos) {
      target.nth = std::clamp(std::atoi(text.c_str() + hash + 2) - 1, 0, 100);
      text.resize(hash);
    }
    const auto is_called = [&](const Mention& mention) {
      return mention.noun == text || mention.category == text;
    };
    const auto named = std::find_if(brief_.mentions.begin(), brief_.mentions.end(), is_called);
    if (const auto known = find_id(node.text()))
      target.mention = *known;
    else if (const auto other = find_id(text))
      target.mention = *other;
    else if (named != brief_.mentions.end())
      target.mention = static_cast<std::size_t>(named - brief_.mentions.begin());
    if (target.mention != Demand::none) return target;
    return place_called(text, placement, target) ? std::optional(target) : std::nullopt;
  }

  bool place_called(const std::string& text, const Placement& placement, FormTarget& target) const {
    target.place =
        text.empty() ? place_without_name(placement.relations.front()) : place_named(text);
    if (target.place) target.part = part_of(*target.place);
    return target.place.has_value();
  }
  // "in the corner", "against a wall": the relation says it all.
  static std::optional<PlacePhrase> place_without_name(RelationKind kind) {
    if (kind == RelationKind::corner) return PlacePhrase{Place::corner};
    if (kind == RelationKind::middle) return PlacePhrase{Place::middle};
    return kind == RelationKind::edge ? std::optional(PlacePhrase{Place::wall}) : std::nullopt;
  }
  std::optional<PlacePhrase> place_named(const std::string& text) const {
    const auto pieces = words(text);
    const std::string region = join(pieces, "-");
    const auto regions = region_names();
    if (std::find(regions.begin(), regions.end(), region) != regions.end())
      return PlacePhrase{.place = Place::region, .region = region};
    static const std::vector<std::string> walls = {"wall-0", "wall-1", "wall-2", "wall-3"};
    if (const auto wall = std::find(walls.begin(), walls.end(), region); wall != walls.end())
      return PlacePhrase{.place = Place::wall, .wall = static_cast<int>(wall - walls.begin())};
    const auto tokens = tokenize(join(pieces, " "));
    return brief::read_place(tokens, 0, lexicon_.words);
  }
  static std::string part_of(const PlacePhrase& place) {
    if (place.place == Place::window) return "window-0";
    if (place.place == Place::door) return "door-0";
    if (place.place == Place::wall) return wall_named(place).empty() ? "wall" : wall_named(place);
    return place.place == Place::region ? place.region : "";
  }

  void say(std::size_t index, const FormNode& node, const Placement& placement,
           const FormTarget& target) {
    if (const auto metres = node["m"].number(); metres && *metres > 0.0 && *metres < 1000.0)
      return keep_apart(index, *metres, bound_in_form(node["bound"]), target);
    if (target.place) return talk_.locate({index}, as_of_place(placement), *target.place);
    if (target.mention == index) return say_of_each_other(index, placement);
    if (placement.hanging) talk_.hang_from_ceiling({index});
    const std::size_t subject = placement.inverse ? target.mention : index,
                      other = placement.inverse ? index : target.mention;
    for (const RelationKind kind :
         placement.seated ? at_table(subject, other, placement) : placement.relations)
      talk_.add(subject,
                {kind, other, "", placement.flank, false, placement.inverse ? -1 : target.nth});
  }
  // "edge" of a wall is as "against" it, "corner" of a corner as "in" it.
  static Placement as_of_place(Placement told) {
    RelationKind& first = told.relations.front();
    if (first == RelationKind::edge) first = RelationKind::near;
    if (first == RelationKind::hang_from || first == RelationKind::corner) first = RelationKind::on;
    return told;
  }
  // "a chair at the desk": one sits at it, what stands on things is on it.
  std::vector<RelationKind> at_table(std::size_t subject, std::size_t other,
                                     const Placement& placement) const {
    const Mention& one = brief_.mentions[subject];
    if (!form_.table.is_any_of(brief_.mentions[other].category, {"table", "desk"}))
      return placement.relations;
    if (form_.table.is_any_of(one.category, {"chair", "stool", "bench"}))
      return {RelationKind::around};
    return one.mount == Mount::surface ? std::vector{RelationKind::on} : placement.relations;
  }
  // "two desks back to back": half of them are so to the others.
  void say_of_each_other(std::size_t index, const Placement& placement) {
    const bool turns =
        std::any_of(placement.relations.begin(), placement.relations.end(), is_looking_at) ||
        placement.relations.front() == RelationKind::behind;
    if (brief_.mentions[index].formation) return;
    if (!turns || brief_.mentions[index].quantity < 2) {
      brief_.mentions[index].formation = Formation{};
      brief_.mentions[index].formation_heard = talk_.told();
      return;
    }
    const std::size_t half = talk_.part(index, brief_.mentions[index].quantity / 2);
    for (const RelationKind kind : placement.relations) talk_.add(half, {kind, index, "", false});
  }

  void keep_apart(std::size_t index, double metres, MeasureLimit bound, const FormTarget& target) {
    if (!is_named(target)) return;
    Demand demand{RelationKind::gap, target.mention, target.part, false};
    demand.gap = {bound == MeasureLimit::most ? 0.0 : metres,
                  bound == MeasureLimit::least ? std::numeric_limits<double>::infinity() : metres};
    if (target.place && target.place->place == Place::window)
      brief_.windows = std::max(1, brief_.windows.value_or(1));
    if (target.mention != index) talk_.add(index, demand);
  }
  static bool is_named(const FormTarget& target) {
    return target.mention != Demand::none || !target.part.empty();
  }

  void deny(std::size_t index, const Placement& placement, const FormTarget& target,
            std::size_t heard) {
    if (!is_named(target) || target.mention == index || heard == HeardWords::none) return;
    brief_.denials.push_back(
        {index, placement.relations.front(), target.mention, target.part, heard});
    keep_away(brief_.denials.back(), talk_);
  }

  void share(std::size_t index, int each, const FormTarget& target, std::size_t heard) {
    SharedOut shared{.thing = index, .count = each, .heard = heard};
    int owners = 0;
    if (target.mention != Demand::none) {
      shared.owner = target.mention;
      owners = brief_.mentions[target.mention].quantity;
    } else if (target.place) {
      const Place place = target.place->place;
      shared.place = place == Place::corner   ? "corner"
                     : place == Place::window ? "window"
                     : place == Place::door   ? "door"
                                              : "";
      owners = place == Place::corner   ? 4
               : place == Place::window ? std::max(2, brief_.windows.value_or(0))
                                        : 1;
      if (shared.place.empty()) return;
    }
    Mention& mention = brief_.mentions[index];
    if (mention.quantity <= each && owners > 0) mention.quantity = each * owners;
    brief_.shared_out.push_back(std::move(shared));
  }

  // --- What is not there
  // --------------------------------------------------------------------------

  void read_absence(const FormNode& node) {
    const std::string name = lower(node["name"].text()), looks = lower(node["looks"].text());
    if (name.empty() && looks.empty()) return form_.problem(node["name"], "is missing");
    std::string category = name;
    if (const FormName named = name_in_form(name, form_.table);
        !form_.is_rules && named.kind.length > 0 && !named.kind.is_stand_in())
      category = named.kind.category->name;
    const std::string what = looks.empty()      ? category
                             : category.empty() ? looks
                                                : looks + " " + category;
    const auto heard = form_.hear(node["words"], Heard::As::absence, what, 0);
    if (heard.empty() && !form_.is_rules)
      return form_.problem(node["words"], "nothing in the wish says so");
    if (looks.empty())
      brief_.excluded.push_back(category);
    else
      brief_.excluded_looks.push_back({category, looks});
  }

  void read_limit(const FormNode& node) {
    Limit limit;
    for (const auto& one : node["but"].elements(most_of_a_thing))
      if (const auto thing = find_id(one.text()))
        limit.allowed.push_back(*thing);
      else
        form_.problem(one, "\"" + one.text() + "\" is the id of no thing");
    limit.category = lower(node["name"].text());
    if (const FormName named = name_in_form(limit.category, form_.table);
        !form_.is_rules && named.kind.length > 0)
      limit.category = talk_.category_name(named.kind);
    if (const auto on = find_id(node["on"].text())) limit.on = *on;
    const std::string mount = lower(node["mount"].text());
    if (mount == name(Mount::wall) || mount == name(Mount::ceiling))
      limit.mount = mount_named(mount, Mount::wall);
    limit.is_nothing = node["nothing"].flag();
    limit.heard = form_.hear_as_one(node, Heard::As::absence, 0);
    if (!form_.is_rules && limit.heard == HeardWords::none)
      return form_.problem(node["words"], "nothing in the wish says so");
    if (!form_.is_rules && limit.is_of_room()) brief_.bare = true;
    brief_.limits.push_back(std::move(limit));
  }

  // --- As rules know it
  // ---------------------------------------------------------------------------

  void read_as_known(const FormNode& node) {
    const FormNode rules = node["rules"];
    Mention mention;
    mention.noun = node["name"].text();
    mention.category = rules["kind"].text();
    mention.known = rules["known"].flag();
    mention.description = rules["description"].text();
    for (const auto& word : rules["naming"].elements(most_of_a_thing))
      mention.naming.push_back(word.text());
    for (const auto& look : node["looks"].elements(most_of_a_thing))
      mention.looks.push_back(look["look"].text());
    mention.quantity = whole_number(rules["quantity"]);
    mention.counted = rules["counted"].flag();
    const MeasureLimit bound = bound_in_form(node["bound"]);
    mention.at_least = bound == MeasureLimit::least, mention.at_most = bound == MeasureLimit::most;
    mention.most = whole_number(node["most"]);
    mention.least = mention.most > 0 ? whole_number(node["count"]) : 0;
    mention.joined_to = whole_number(rules["joined_to"]);
    mention.list = static_cast<std::int32_t>(rules["list"].number().value_or(language::none));
    mention.varied = rules["varied"].flag();
    mention.seats = whole_number(rules["seats"]);
    mention.sized = rules["sized"].flag();
    const auto size = rules["size"].numbers(3);
    if (size.size() == 3) mention.size = Vec3(size[0], size[1], size[2]);
    mention.mount = mount_named(node["mount"]["on"].text(), Mount::floor);
    mention.owner = node["owner"].text();
    if (const auto whole = find_id(node["some_of"].text())) mention.part_of = *whole;
    if (rules["source"].text() == name(Requirement::Source::person))
      mention.source = Requirement::Source::person;
    for (const auto& length : node["sizes"].elements(most_of_a_thing))
      mention.lengths.push_back({length["side"].text(), length["m"].number().value_or(0.0),
                                 bound_in_form(length["bound"])});
    if (const auto shape = node["formation"]["shape"].text(); !shape.empty())
      mention.formation = formation_of(node["formation"], shape);
    brief_.mentions.push_back(std::move(mention));
    const std::size_t index = brief_.mentions.size() - 1;
    Mention& made = brief_.mentions.back();
    add(form_.hear(node["words"], Heard::As::thing, "", 0), made);
    keep(node, index, {});
    made.sentence = static_cast<int>(rules["sentence"].number().value_or(0.0));
    hear_looks(node, made, 0);
    add(form_.hear(rules["people_words"], Heard::As::person, "", 0), made);
  }

  void read_place_as_known(std::size_t index, const FormNode& node) {
    Mention& mention = brief_.mentions[index];
    mention.mount_heard = form_.hear_as_one(node["mount"], Heard::As::relation, 0);
    mention.formation_heard = form_.hear_as_one(node["formation"], Heard::As::relation, 0);
    for (const auto& relation : node["relations"].elements(10 * most_of_a_thing)) {
      Demand demand;
      target_as_known(relation, demand.kind, demand.mention, demand.part);
      if (demand.kind == RelationKind::gap)
        demand.gap = {relation["least"].number().value_or(0.0),
                      bound_in_form(relation["bound"]) == MeasureLimit::least
                          ? std::numeric_limits<double>::infinity()
                          : relation["m"].number().value_or(0.0)};
      const FormNode rules = relation["rules"];
      demand.flank = rules["flank"].flag(), demand.shared = rules["shared"].flag();
      demand.nth = static_cast<int>(rules["nth"].number().value_or(-1.0));
      demand.listed = rules["listed"].flag(), demand.is_means = rules["means"].flag();
      demand.heard = form_.hear_as_one(relation, Heard::As::relation, 0);
      mention.demands.push_back(std::move(demand));
    }
  }
  void target_as_known(const FormNode& node, RelationKind& kind, std::size_t& mention,
                       std::string& part) const {
    kind = relation_named(node["relation"].text()).value_or(RelationKind::near);
    const std::string to = node["to"].text();
    if (const auto thing = find_id(to))
      mention = *thing;
    else
      part = to;
  }

  void read_rest_as_known(const FormNode& rules) {
    brief_.bare = rules["bare"].flag();
    brief_.told_from_door = rules["told_from_door"].flag();
    for (const auto& note : rules["notes"].elements(1000)) brief_.notes.push_back(note.text());
    for (const auto& node : rules["each"].elements(10 * most_of_a_thing)) {
      const auto thing = find_id(node["thing"].text());
      if (!thing) continue;
      SharedOut shared{.thing = *thing, .count = whole_number(node["count"])};
      if (const auto owner = find_id(node["of"].text()))
        shared.owner = *owner;
      else
        shared.place = node["of"].text();
      shared.heard = form_.hear_as_one(node, Heard::As::relation, 0);
      if (const auto each = form_.hear(node["each_words"], Heard::As::count, "", 0); !each.empty())
        shared.word = each.front();
      brief_.shared_out.push_back(std::move(shared));
    }
    for (const auto& node : rules["denials"].elements(10 * most_of_a_thing)) {
      const auto thing = find_id(node["thing"].text());
      if (!thing) continue;
      Denial denial;
      denial.thing = *thing;
      target_as_known(node, denial.kind, denial.target, denial.part);
      denial.heard = form_.hear_as_one(node, Heard::As::relation, 0);
      brief_.denials.push_back(std::move(denial));
    }
  }

  Form& form_;
  Brief& brief_;
  const Lexicon lexicon_;
  Discourse talk_;
  std::map<std::string, std::size_t> ids_;
  std::vector<std::pair<std::size_t, FormNode>> read_;  ///< mentions with what is said of them
};

}  // namespace

void read_form_things(Form& form, const Vocabulary& words) {
  FormThings(form, words).read();
}

}  // namespace roomgen::brief
