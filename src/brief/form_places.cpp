// The clauses of brief.json about how things stand.
#include <algorithm>
#include <cstdlib>
#include <limits>

#include "form_things.h"
#include "mention_shape.h"
#include "placement_phrase.h"
#include "prompt_passes.h"
#include "roomgen/base/text.h"
#include "scene/relation_named.h"
#include "scene/room_part.h"

namespace roomgen::brief {

namespace {

using MeasureLimit = language::Measure::Limit;

/// What a relation is to.
struct FormTarget {
  std::size_t mention = Demand::none;
  int nth = -1;
  std::optional<PlacePhrase> place;
  std::string part;  ///< how plans name the place, where one name does
};

class PlaceReader {
 public:
  explicit PlaceReader(FormThings& things)
      : form_(things.form),
        brief_(form_.brief),
        lexicon_(things.lexicon),
        things_(things),
        talk_(things.talk) {}

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
    // "Between the bed and the window" is no place between two windows.
    auto& demands = brief_.mentions[index].demands;
    const auto is_between = [](const Demand& one) { return one.kind == RelationKind::between; };
    const auto is_window = [&](const Demand& one) {
      return is_between(one) && one.part.starts_with("window-");
    };
    if (std::count_if(demands.begin(), demands.end(), is_between) > 2 &&
        !std::all_of(demands.begin(), demands.end(),
                     [&](const Demand& one) { return !is_between(one) || is_window(one); }))
      std::erase_if(demands,
                    [&](const Demand& one) { return is_window(one) && one.part != "window-0"; });
  }

 private:
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
      return form_.problem(
          node["to"],
          "\"" + node["to"].text() + "\" is neither the id of a thing nor a part of the room");
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
    if (const auto known = things_.find_id(node.text()))
      target.mention = *known;
    else if (const auto other = things_.find_id(text))
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
    const bool in_corner = placement.relations.front() == RelationKind::corner;
    if (target.place && in_corner && target.place->place == Place::wall) {  // of the back wall
      talk_.locate({index}, as_of_place(placement), PlacePhrase{Place::corner});
      return talk_.locate({index}, Placement{.relations = {RelationKind::near}}, *target.place);
    }
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
  static bool is_id(const std::string& text) {
    return text.size() > 1 && text[0] == 't' &&
           text.find_first_not_of("0123456789", 1) == text.npos;
  }

  Form& form_;
  Brief& brief_;
  const Lexicon& lexicon_;
  FormThings& things_;
  Discourse& talk_;
};

}  // namespace

void read_form_places(FormThings& things) {
  PlaceReader reader(things);
  for (const auto& [mention, node] : things.read) reader.read_place(mention, node);
}

}  // namespace roomgen::brief
