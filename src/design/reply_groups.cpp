#include "reply_groups.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "composition/composition.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

using composition::Composition;

constexpr std::size_t max_groups = 60;
constexpr int deepest_part = 4;
constexpr const char* unit = "unit";  ///< the part that a composition is within a group of its own

/// How an answer says where a thing of a group is, and how data/compositions has it.
struct WhereWords {
  std::string_view words;
  const char* key;
  const char* side;
  int sides;  ///< that share the things
};
constexpr WhereWords where_words[] = {{"around", "around", "", 1},
                                      {"all around", "around", "", 1},
                                      {"left of", "beside", "left", 1},
                                      {"right of", "beside", "right", 1},
                                      {"in front of", "beside", "front", 1},
                                      {"before", "beside", "front", 1},
                                      {"behind", "beside", "back", 1},
                                      {"beside", "beside", "sides", 2},
                                      {"next to", "beside", "sides", 2},
                                      {"on both sides of", "beside", "sides", 2},
                                      {"on each side of", "beside", "sides", 2},
                                      {"at the sides of", "beside", "sides", 2},
                                      {"at the ends of", "beside", "ends", 2},
                                      {"on all sides of", "beside", "all", 4},
                                      {"on top of", "on", "", 1},
                                      {"on", "on", "", 1},
                                      {"inside", "on", "", 1},
                                      {"in", "on", "", 1},
                                      {"above", "above", "", 1},
                                      {"over", "over", "", 1},
                                      {"under", "under", "", 1},
                                      {"beneath", "under", "", 1},
                                      {"with", "of", "", 1},
                                      {"at", "of", "", 1}};

/// "around the table": the words for where, and the part.
struct Said {
  const WhereWords* where = nullptr;
  std::string part, before;
};

std::optional<Said> said_in(const std::string& text) {
  auto pieces = words(text);
  std::erase_if(pieces, [](const std::string& word) { return word == "the" || word == "a"; });
  Said said;
  std::size_t length = 0;
  for (const auto& known : where_words) {
    auto own = words(known.words);
    std::erase(own, "the");
    if (own.size() < pieces.size() && own.size() > length && std::equal(own.begin(), own.end(), pieces.begin()))
      said.where = &known, length = own.size();
  }
  if (!said.where && pieces.size() > 2 && pieces[0] == "to" && (pieces[1] == "left" || pieces[1] == "right"))
    return said_in(join({pieces.begin() + 1, pieces.end()}, " "));
  if (!said.where) return std::nullopt;
  const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(length);
  const auto split = std::find(begin, pieces.end(), "before");
  said.part = join({begin, split}, " ");
  if (split != pieces.end()) said.before = join({split + 1, pieces.end()}, " ");
  return said;
}

/// A thing of a composition: its path ("unit/table") and kind.
struct Leaf {
  std::string path, kind;
};

void add_leaves(const Composition& composition, const std::string& prefix, int depth, std::vector<Leaf>& leaves) {
  const auto& known = composition::built_in_compositions();
  for (const auto& part : composition.parts) {
    if (!part.kind.empty()) {
      leaves.push_back({prefix + part.name, part.kind});
      continue;
    }
    const auto inner = known->find(part.composition);
    if (inner != known->end() && depth < deepest_part)
      add_leaves(inner->second, prefix + part.name + "/", depth + 1, leaves);
  }
}

std::string last_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

const Composition* composition_named(const std::string& name) {
  const auto& known = composition::built_in_compositions();
  if (!known || name.empty()) return nullptr;
  const auto found = known->find(name);
  return found == known->end() ? nullptr : &found->second;
}

std::optional<double> number_of(const Json& json, const std::vector<std::string>& names) {
  const Json* value = member(json, names);
  if (!value) return std::nullopt;
  const auto measure = brief::single_measure(*value);
  return measure ? std::optional(measure->value) : std::nullopt;
}

/// Reads one group, whose things are drafts already.
class GroupReader {
 public:
  GroupReader(const Json& json, std::string id, const KindTable& kinds, std::vector<plan::Draft*> drafts,
              std::vector<std::string>& repairs)
      : json_(json), kinds_(kinds), drafts_(std::move(drafts)), repairs_(repairs) {
    group_.id = std::move(id);
  }

  /// Further parts of the composition that look as one that the answer names.
  std::vector<plan::Draft> take_more() { return std::move(more_); }

  std::optional<PlanGroup> read() {
    const std::string said = lower(text_in(member(json_, {"composition", "template", "pattern"})));
    composition_ = composition_named(said);
    if (!said.empty() && !composition_) {
      std::vector<std::string> names;
      if (const auto& known = composition::built_in_compositions())
        for (const auto& [name, one] : *known) names.push_back(name);
      const std::string close = closest_name(said, names);
      note("composition", "\"" + said + "\" is none that is known" +
                              (close.empty() ? "" : "; did you mean \"" + close + "\"?"));
    }
    if (composition_) add_leaves(*composition_, "", 0, leaves_);
    read_settings();
    const Json* repeat = member(json_, {"repeat"});
    const bool has_more = std::any_of(drafts_.begin(), drafts_.end(), [&](const plan::Draft* draft) {
      return !wheres_of(*draft).empty() && !leaf_of(*draft);
    });
    is_wrapped_ = composition_ && (has_more || repeat);
    if (composition_ && !is_wrapped_) group_.composition = composition_->name;
    else if (!read_parts(repeat)) return std::nullopt;
    if (composition_) name_leaves(), name_without();
    group_.asked = true;
    const ReplyStands stands = read_reply_stands(json_);
    group_.location = stands.location, group_.facing = stands.facing;
    if (stands.at_wall) group_.relations.push_back({RelationKind::edge, ""});
    return std::move(group_);
  }

 private:
  void note(const std::string& where, const std::string& what) {
    repairs_.push_back("group \"" + group_.id + "\", " + where + ": " + what);
  }

  // The answer's own words for a thing, by its draft.
  const Json* thing_of(const plan::Draft& draft) const {
    const Json* things = member(json_, {"things", "members", "objects", "parts"});
    if (!things || !things->is_array()) return nullptr;
    for (const auto& thing : *things)
      if (thing.is_object() && part_name(thing) == draft.item.part) return &thing;
    return nullptr;
  }

  static std::string part_name(const Json& thing) {
    return reply_part_name(thing);
  }

  std::string wheres_of(const plan::Draft& draft) const {
    const Json* thing = thing_of(draft);
    return thing ? text_in(member(*thing, {"where"})) : "";
  }

  // What of the composition a thing is: by name, else by kind.
  const Leaf* leaf_of(const plan::Draft& draft) const {
    const std::string& name = draft.item.part;
    const auto find = [&](auto fits) {
      const auto found = std::find_if(leaves_.begin(), leaves_.end(), fits);
      return found == leaves_.end() ? nullptr : &*found;
    };
    if (const Leaf* leaf = find([&](const Leaf& one) { return one.path == name || unit_path(one) == name; })) return leaf;
    if (const Leaf* leaf = find([&](const Leaf& one) { return last_name(one.path) == name; })) return leaf;
    if (const Leaf* leaf = find([&](const Leaf& one) { return one.kind == draft.item.category; })) return leaf;
    return find([&](const Leaf& one) {
      return kinds_.is_a(draft.item.category, one.kind) || kinds_.is_a(one.kind, draft.item.category);
    });
  }

  static std::string unit_path(const Leaf& leaf) { return std::string(unit) + "/" + leaf.path; }

  // [{"name": "seats", "value": 6}], {"seats": 6} or "seats 6".
  void read_settings() {
    const Json* with = member(json_, {"with", "parameters", "params"});
    if (with && with->is_object())
      for (const auto& [name, value] : with->items()) set(name, value);
    if (with && with->is_array())
      for (const auto& one : *with)
        if (const Json* value = one.is_object() ? member(one, {"value"}) : nullptr) set(text_in(member(one, {"name"})), *value);
    if (const Json* without = member(json_, {"without"}); without && without->is_array())
      for (const auto& one : *without)
        if (one.is_string()) group_.without.insert(lower(one.get<std::string>()));
  }

  void set(const std::string& name, const Json& value) {
    if (!composition_) return;
    const auto& known = composition_->parameters;
    const auto found = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
    if (found == known.end()) return note("with", "\"" + composition_->name + "\" has no \"" + name + "\"");
    const auto number = brief::single_measure(value);
    if (!found->choices.empty() && value.is_string()) group_.parameters[name] = value.get<std::string>();
    else if (number) group_.parameters[name] = std::clamp(number->value, found->least, found->most);
    else return note("with", "\"" + name + "\" is no number");
    if (number && std::get<double>(group_.parameters[name]) != number->value)
      note("with", "\"" + name + "\" goes from " + format_number(found->least, 2) + " to " +
                       format_number(found->most, 2));
    group_.fixed.insert(name);
  }

  void name_leaves() {
    for (auto* draft : drafts_) {
      const Leaf* leaf = leaf_of(*draft);
      if (!leaf && std::find(own_.begin(), own_.end(), draft->item.part) != own_.end()) continue;
      if (!leaf) {
        note("things", "\"" + draft->item.part + "\" is no part of \"" + composition_->name +
                           "\" and does not say where; it stands for itself");
        draft->item.group.clear(), draft->item.part.clear();
        continue;
      }
      draft->item.part = part_of(*leaf);
      draft->item.quantity = 0;  // as the composition has them
    }
    for (const auto* draft : drafts_) look_alike(*draft);
  }

  // A part by its own name, or all of a kind.
  void name_without() {
    std::set<std::string> named;
    for (const auto& said : group_.without) {
      const std::size_t before = named.size();
      for (const auto& leaf : leaves_)
        if (leaf.path == said || last_name(leaf.path) == said || leaf.kind == said) named.insert(part_of(leaf));
      if (named.size() == before) note("without", "\"" + said + "\" is no part of \"" + composition_->name + "\"");
    }
    group_.without = std::move(named);
  }

  std::string part_of(const Leaf& leaf) const { return is_wrapped_ ? unit_path(leaf) : leaf.path; }

  // Two parts for the chairs at two sides are of one kind: what is said of one holds for the other.
  void look_alike(const plan::Draft& draft) {
    const auto own = std::find_if(leaves_.begin(), leaves_.end(),
                                  [&](const Leaf& leaf) { return part_of(leaf) == draft.item.part; });
    if (own == leaves_.end() || draft.item.group.empty()) return;
    for (const auto& leaf : leaves_) {
      const auto has_part = [&](const auto& other) { return other.item.part == part_of(leaf); };
      const bool is_named = std::any_of(drafts_.begin(), drafts_.end(), [&](const auto* other) { return has_part(*other); }) ||
                            std::any_of(more_.begin(), more_.end(), has_part);
      if (leaf.kind != own->kind || is_named) continue;
      more_.push_back(draft);
      more_.back().item.part = part_of(leaf);
    }
  }

  // A definition of its own: the composition as its first part, if there is one.
  bool read_parts(const Json* repeat) {
    Json parts = Json::array();
    if (composition_) {
      Json first = {{"part", unit}, {"group", composition_->name}};
      for (const auto& [name, value] : group_.parameters)
        if (const double* number = std::get_if<double>(&value)) first["with"][name] = *number;
      parts.push_back(std::move(first));
      group_.parameters.clear(), group_.fixed.clear();
    }
    for (auto* draft : drafts_)
      if (!leaf_of(*draft)) add_part(*draft, parts);
    if (parts.empty()) return note("things", "there are none"), false;
    if (repeat) parts.front()["repeat"] = repeat_of(*repeat);
    const Json definition = {{"parts", parts}};
    if (const auto made = composition::read_composition(definition, group_.id, group_.id); !made)
      return note("things", made.error().message), false;
    group_.definition = json_line(definition);
    return true;
  }

  Json repeat_of(const Json& said) const {
    const auto count = [&](const std::vector<std::string>& names) {
      return std::clamp(std::round(number_of(said, names).value_or(1.0)), 1.0, 50.0);
    };
    Json repeat = {{"rows", count({"rows"})}, {"columns", count({"columns", "number"})}};
    const auto pitch = [&](const char* key, const std::vector<std::string>& names, const std::string& side, double alone) {
      const auto told = number_of(said, names);
      repeat[key] = told ? Json(*told) : composition_ ? Json(unit + side + " + 0.9") : Json(alone + 0.9);
    };
    const Vec3 size = composition_ ? Vec3(Vec3::Zero()) : drafts_.front()->item.size.value_or(kinds_.get(drafts_.front()->item.category).size);
    pitch("across", {"across m", "across"}, "_w", size.x());
    pitch("along", {"along m", "along"}, "_d", size.y());
    return repeat;
  }

  void add_part(plan::Draft& draft, Json& parts) {
    PlanItem& item = draft.item;
    Json part = {{"part", item.part}, {"kind", item.category}};
    own_.push_back(item.part);
    const int count = std::max(1, item.quantity);
    item.quantity = 0;
    if (parts.empty()) {  // the anchor
      parts.push_back(std::move(part));
      return;
    }
    const auto said = said_in(wheres_of(draft));
    const std::string of = said ? target(said->part, parts) : "";
    if (of.empty()) {
      note("things", "\"" + item.part + "\" does not say where it is, as in \"around " +
                         parts.front()["part"].get<std::string>() + "\"; it stands for itself");
      own_.pop_back();
      item.group.clear(), item.part.clear();
      item.quantity = count;
      return;
    }
    put(*thing_of(draft), *said, of, count, part);
    if (!said->before.empty()) part["before"] = target(said->before, parts);
    if (item.spare > 0) part["spare"] = item.spare;
    if (const auto mount = parse_mount(text_in(member(*thing_of(draft), {"place"}))))
      part["mount"] = name(*mount);
    parts.push_back(std::move(part));
  }

  void put(const Json& thing, const Said& said, const std::string& of, int count, Json& part) const {
    std::string key = said.where->key;
    if (key == "of" && !*said.where->side && is_within(thing, part["kind"], of)) key = "on";
    part[key] = of;
    if (*said.where->side) part["side"] = said.where->side;
    const bool in_a_row = key == "beside" || key == "around";
    if (in_a_row) part["count"] = std::max(1, count / said.where->sides);
    if (const auto gap = number_of(thing, {"gap m", "gap"}); gap && (in_a_row || key == "above"))
      part["gap"] = *gap;
    else if (key == "around") part["gap"] = -0.1;
    if (const std::string align = text_in(member(thing, {"align"}));
        in_a_row && (align == "back" || align == "front"))
      part["align"] = align;
    if (const Json* at = member(thing, {"at m", "at"}); at && !in_a_row && at->is_array() && at->size() == 2) part["at"] = *at;
    // Several share the thing below evenly.
    if (!in_a_row && count > 1 && said.before.empty())
      part["repeat"] = {{"columns", count}, {"across", std::max(width_of(part["part"]) + 0.06, 0.8 * width_of(of) / count)}};
    const Json* turned = member(thing, {"facing"});
    const auto degrees_said = turned ? brief::single_measure(*turned) : std::nullopt;
    if (degrees_said) part["yaw"] = degrees_said->value;
    const std::string facing = lower(text_in(member(thing, {"facing"})));
    const bool is_known = facing == "same" || facing == "opposite" || facing == "to" || facing == "away";
    const bool sits_before = in_a_row && key == "beside" && kinds_.is_a(part["kind"].get<std::string>(), "seat");
    if (is_known) part["facing"] = facing;
    else if (sits_before && !degrees_said) part["facing"] = "to";
  }

  // At a place within a table's own outline is on it, unless it is a rug or a seat.
  bool is_within(const Json& thing, const std::string& kind, const std::string& of) const {
    const Json* at = member(thing, {"at m", "at"});
    const bool is_place = at && !member(thing, {"place"}) && at->is_array() && at->size() == 2 &&
                          (*at)[0].is_number() && (*at)[1].is_number();
    if (!is_place || kinds_.get(kind).traits.flat || kinds_.is_a(kind, "seat")) return false;
    const Vec3 outline = size_of(of);
    return std::abs((*at)[0].get<double>()) < 0.5 * outline.x() &&
           std::abs((*at)[1].get<double>()) < 0.5 * outline.y();
  }

  // As far as the answer or the kind tells; 0 of a composition.
  Vec3 size_of(const std::string& part) const {
    for (const auto* draft : drafts_)
      if (draft->item.part == part)
        return draft->item.size.value_or(kinds_.get(draft->item.category).size);
    return Vec3::Zero();
  }
  double width_of(const std::string& part) const { return size_of(part).x(); }

  // Which part is meant: by its name, the kind of thing, or one of the composition.
  std::string target(const std::string& said, const Json& parts) const {
    for (const auto& part : parts)
      if (words(part["part"].get<std::string>()) == words(said)) return part["part"];
    for (const auto& leaf : leaves_)
      if (words(last_name(leaf.path)) == words(said) || words(leaf.kind) == words(said)) return unit_path(leaf);
    for (const auto& part : parts)
      if (part.contains("kind") && !words(said).empty() &&
          words(said).back() == words(part["kind"].get<std::string>()).back())
        return part["part"];
    return "";
  }

  const Json& json_;
  const KindTable& kinds_;
  std::vector<plan::Draft*> drafts_;
  std::vector<std::string>& repairs_;
  PlanGroup group_;
  const Composition* composition_ = nullptr;
  bool is_wrapped_ = false;
  std::vector<Leaf> leaves_;
  std::vector<std::string> own_;  ///< parts of its own
  std::vector<plan::Draft> more_;
};

}  // namespace

std::vector<PlanGroup> read_reply_groups(const Json& json, const ItemLexicon& lexicon,
                                         std::vector<plan::Draft>& drafts,
                                         std::vector<std::string>& repairs) {
  std::vector<PlanGroup> groups;
  if (!json.is_array()) return groups;
  std::vector<plan::Draft> more;
  for (std::size_t g = 0; g < json.size() && g < max_groups; ++g) {
    if (!json[g].is_object()) continue;
    const std::string id = reply_group_id(json[g], g);
    std::vector<plan::Draft*> own;
    for (auto& draft : drafts)
      if (draft.item.group == id) own.push_back(&draft);
    GroupReader reader(json[g], id, lexicon.table, own, repairs);
    if (auto group = reader.read()) {
      groups.push_back(*std::move(group));
      for (auto& draft : reader.take_more()) more.push_back(std::move(draft));
      continue;
    }
    for (auto* draft : own) {
      draft->item.group.clear(), draft->item.part.clear();
      draft->item.quantity = std::max(1, draft->item.quantity);
    }
  }
  for (auto& draft : more) {
    draft.mention = drafts.size();
    drafts.push_back(std::move(draft));
  }
  if (json.size() > max_groups)
    repairs.push_back("only the first " + std::to_string(max_groups) + " groups were kept");
  return groups;
}

}  // namespace roomgen::design
