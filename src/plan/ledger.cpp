#include "ledger.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "coverage.h"
#include "floor_plan.h"
#include "blocks.h"
#include "brief/picture_text.h"
#include "brief/said_wish.h"
#include "room_clauses.h"
#include "roomgen/base/text.h"
#include "scene/attribute_names.h"
#include "scene/room_part.h"

namespace roomgen::plan {

namespace {

// Constraints have the sides of the thing itself, people who look at it those of its front.
std::string_view as_told(RelationKind kind) {
  if (kind == RelationKind::left_of) return name(RelationKind::right_of);
  return name(kind == RelationKind::right_of ? RelationKind::left_of : kind);
}

class Ledger {
 public:
  Ledger(const PlanRequest& request, const brief::Brief& brief, const std::vector<Draft>& drafts,
         const Plan& plan)
      : request_(request), brief_(brief), room_(plan.room), ids_by_words_(brief.heard.size()) {
    for (const auto& planned : planned_objects(plan)) {
      const std::size_t mention = drafts[planned.item].mention;
      if (mention != brief::Demand::none) ids_[mention].push_back(planned.id);
    }
  }

  LedgerOfPrompt run() {
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i) {
      const brief::Mention& mention = brief_.mentions[i];
      count(i, mention);
      for (const auto& look : mention.looks) attribute(i, mention, look);
      for (const auto& part : mention.parts) attribute(i, mention, part);
      for (const auto& length : mention.lengths) this->length(i, mention, length);
      mount(i, mention);
      formation(i, mention);
      for (const auto& demand : mention.demands) relation(i, mention, demand);
    }
    for (const auto& share : brief_.shared_out) each(share);
    for (const auto& denial : brief_.denials) denied(denial);
    for (const auto& limit : brief_.limits) only(limit);
    for (const auto& category : brief_.excluded) absence(category, "");
    for (const auto& [category, looks] : brief_.excluded_looks) absence(category, looks);
    material("floor", brief_.materials.floor);
    material("walls", brief_.materials.walls);
    material("ceiling", brief_.materials.ceiling);
    material("accent wall", finish_named(brief_.materials, accent_name));
    for (auto& [requirement, words] : clauses_of_room(brief_, request_, room_.type))
      add(std::move(requirement), words);
    return {std::move(requirements_), heard_words(request_.prompt, brief_, ids_by_words_)};
  }

 private:
  // The number of a requirement, which words are checked by it; what no words say is none.
  void add(Requirement requirement, std::vector<std::size_t> said_by) {
    std::erase(said_by, brief::HeardWords::none);
    if (said_by.empty()) return;
    requirement.picture = picture_of_all(said_by);
    const auto same = std::find_if(
        requirements_.begin(), requirements_.end(), [&](const Requirement& known) {
          requirement.id = known.id;
          return known == requirement;
        });
    if (same == requirements_.end()) {
      requirement.id = "r" + std::to_string(requirements_.size() + 1);
      requirements_.push_back(requirement);
    }
    for (const std::size_t heard : said_by) ids_by_words_[heard].push_back(requirement.id);
  }

  // Of what words of the wish say besides, they are the source.
  int picture_of_all(const std::vector<std::size_t>& said_by) const {
    int picture = 0;
    for (const std::size_t heard : said_by) {
      const auto& token = brief_.tokens[brief_.heard[heard].tokens.begin];
      picture = brief::picture_of(request_.prompt, token.span.begin);
      if (picture == 0) break;
    }
    return picture;
  }

  // What of a mention's words was taken for that, and of attributes for this one.
  std::vector<std::size_t> words_of(const brief::Mention& mention, Heard::As as,
                                    const std::string& word = "") const {
    std::vector<std::size_t> result;
    for (const std::size_t heard : mention.heard)
      if (brief_.heard[heard].as == as && (word.empty() || brief_.heard[heard].word == word))
        result.push_back(heard);
    return result;
  }
  Requirement about(std::size_t index, const brief::Mention& mention, Requirement::Kind kind) {
    Requirement requirement;
    requirement.kind = kind;
    requirement.category = mention.category;
    requirement.source = mention.source;
    if (const auto found = ids_.find(index); found != ids_.end()) requirement.subjects = found->second;
    return requirement;
  }

  // What is counted, without its looks: those are clauses of their own, and may fail where the number holds.
  static std::string counted(const brief::Mention& mention) {
    std::string rest = " " + mention.description + " ";
    for (const auto& look : mention.looks) {
      const bool is_sort = std::find(mention.naming.begin(), mention.naming.end(), look) != mention.naming.end();
      const std::size_t at = is_sort ? std::string::npos : rest.find(" " + look + " ");
      if (at != std::string::npos) rest.erase(at, look.size() + 1);
    }
    // "black and white chairs"
    while (rest.starts_with(" and ")) rest.erase(0, 4);
    const std::string words(trim(rest));
    return words.empty() ? mention.category : words;
  }

  // In the wish's own words where a model read it; its kind is only what such a thing is taken for.
  std::string called(const brief::Mention& mention) const {
    const auto* read = brief::reading_of(request_);
    if (!read || !read->is_by_model || mention.noun.empty()) return mention.category;
    return join(mention.naming, " ") + (mention.naming.empty() ? "" : " ") + mention.noun;
  }

  void count(std::size_t index, const brief::Mention& mention) {
    Requirement requirement = about(index, mention, Requirement::Kind::count);
    const bool is_range = mention.most > mention.least;
    requirement.count = is_range ? mention.least : mention.quantity;
    requirement.most = is_range ? mention.most : 0;
    requirement.at_least = !mention.counted || mention.at_least;
    requirement.at_most = mention.at_most;
    requirement.attribute = join(mention.naming, " ");
    requirement.clause = (is_range ? std::to_string(mention.least) + " to " + std::to_string(mention.most)
                          : mention.quantity == 1 ? "a" : std::to_string(mention.quantity)) +
                         " " + counted(mention);
    if (mention.source == Requirement::Source::person) requirement.clause += ", for people";
    std::vector<std::size_t> words;
    for (const auto as : {Heard::As::thing, Heard::As::count, Heard::As::person})
      for (const std::size_t heard : words_of(mention, as)) words.push_back(heard);
    add(std::move(requirement), words);
  }

  void attribute(std::size_t index, const brief::Mention& mention, const std::string& look) {
    Requirement requirement = about(index, mention, Requirement::Kind::attribute);
    requirement.attribute = look;
    requirement.clause = look + " " + called(mention);
    add(std::move(requirement), words_of(mention, Heard::As::attribute, look));
  }

  void length(std::size_t index, const brief::Mention& mention, const brief::SaidLength& length) {
    Requirement requirement = about(index, mention, Requirement::Kind::attribute);
    requirement.attribute = length.side;
    requirement.amount = length.metres;
    using Limit = language::Measure::Limit;
    requirement.at_least = length.limit == Limit::least;
    requirement.at_most = length.limit == Limit::most;
    requirement.clause = called(mention) + ", " + length.side +
                         (requirement.at_least  ? " at least"
                          : requirement.at_most ? " at most"
                                                : "") +
                         " " + format_number(length.metres, 2) + " m";
    add(std::move(requirement), words_of(mention, Heard::As::attribute, brief::said_length));
  }

  void mount(std::size_t index, const brief::Mention& mention) {
    if (mention.mount_heard == brief::HeardWords::none) return;
    Requirement requirement = about(index, mention, Requirement::Kind::attribute);
    requirement.attribute = std::string(mount_attribute).append(name(mention.mount));
    requirement.clause = called(mention) + " on the " + std::string(name(mention.mount));
    add(std::move(requirement), {mention.mount_heard});
  }

  // "in two rows of four"
  void formation(std::size_t index, const brief::Mention& mention) {
    if (!mention.formation) return;
    Requirement requirement = about(index, mention, Requirement::Kind::attribute);
    const brief::Formation& formation = *mention.formation;
    using Shape = brief::Formation::Shape;
    static const std::map<Shape, std::string_view> names = {
        {Shape::rows, in_rows}, {Shape::circle, in_circle}, {Shape::arc, in_arc}, {Shape::islands, in_islands}};
    const bool are_islands = formation.shape == Shape::islands;
    requirement.attribute = names.at(formation.shape);
    requirement.count = are_islands ? formation.columns : formation.rows;
    const std::string number = std::to_string(requirement.count);
    requirement.clause = called(mention) + " " + requirement.attribute;
    if (are_islands) requirement.clause += " of " + number;
    if (formation.shape == Shape::rows && requirement.count > 0)
      requirement.clause = called(mention) + " in " + (requirement.count == 1 ? "a row" : number + " rows");
    add(std::move(requirement), {mention.formation_heard});
  }

  void relation(std::size_t index, const brief::Mention& mention, const brief::Demand& demand) {
    if (demand.is_means) return;
    if (demand.said_of != brief::Demand::none) {
      brief::Demand said = demand;
      said.mention = std::exchange(said.said_of, brief::Demand::none);
      return relation(index, mention, said);
    }
    // Of those that share the long sides half are behind the target.
    if (demand.flank && demand.kind == RelationKind::in_front_of) return;
    if (demand.kind == RelationKind::between) return between(index, mention, demand);
    relation_of_kind(index, mention, demand, demand.said.value_or(demand.kind));
    // What is on each side of a thing is not behind it, however close.
    if (demand.flank && demand.kind == RelationKind::next_to)
      relation_of_kind(index, mention, demand, RelationKind::side_of);
  }

  void relation_of_kind(std::size_t index, const brief::Mention& mention,
                        const brief::Demand& demand, RelationKind kind) {
    Requirement requirement = about(index, mention, Requirement::Kind::relation);
    requirement.relation = kind;
    const bool is_told = mention.source == Requirement::Source::prompt;
    requirement.clause = called(mention) + " " + std::string(is_told ? as_told(kind) : name(kind));
    if (kind == RelationKind::gap) set_gap(requirement, mention, demand.gap);
    if (demand.mention != brief::Demand::none) {
      requirement.targets = with_parts(demand.mention);
      // "the second bench"
      if (const auto nth = static_cast<std::size_t>(demand.nth); demand.nth >= 0 && nth < requirement.targets.size())
        requirement.targets = {requirement.targets[nth]};
      requirement.clause += " " + called(brief_.mentions[demand.mention]);
      // Rows face what is before their middle.
      if (mention.formation && !mention.formation->is_round() && is_looking_at(demand.kind))
        requirement.subjects = middle_of_rows(requirement.subjects, *mention.formation);
    } else if (demand.part == brief::each_wall) {
      requirement.targets = wall_names(room_);
      requirement.clause += " each wall";
    } else if (!demand.part.empty()) {
      requirement.targets = {part_of(room_, demand.part)};
      requirement.clause += " " + demand.part;
    }
    add(std::move(requirement), {demand.heard});
  }
  // "chair 0.5 m from"
  void set_gap(Requirement& requirement, const brief::Mention& mention, const Gap& gap) const {
    requirement.at_least = std::isinf(gap.most);
    requirement.at_most = gap.least < gap.most && !requirement.at_least;
    requirement.amount = requirement.at_least ? gap.least : gap.most;
    requirement.clause = called(mention) + " " + to_text(gap) + " from";
  }

  // Of several of which some are told of apart, all are meant.
  std::vector<std::string> with_parts(std::size_t mention) {
    std::vector<std::string> ids = ids_[mention];
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i)
      if (brief_.mentions[i].part_of == mention) ids.insert(ids.end(), ids_[i].begin(), ids_[i].end());
    return ids;
  }

  static std::vector<std::string> middle_of_rows(const std::vector<std::string>& ids,
                                                 const brief::Formation& formation) {
    const std::size_t columns = columns_of(formation, ids.size());
    std::vector<std::string> middle;
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (i % columns == columns / 2) middle.push_back(ids[i]);
    return middle.empty() ? ids : middle;
  }

  // One clause of all that it is said of.
  void between(std::size_t index, const brief::Mention& mention, const brief::Demand& first) {
    std::vector<std::string> names;
    std::vector<std::size_t> words;
    Requirement requirement = about(index, mention, Requirement::Kind::relation);
    requirement.relation = RelationKind::between;
    for (const auto& demand : mention.demands) {
      if (demand.kind != RelationKind::between) continue;
      if (names.empty() && &demand != &first) return;  // said with the first
      const bool is_thing = demand.mention != brief::Demand::none;
      names.push_back(is_thing ? called(brief_.mentions[demand.mention]) : demand.part);
      const auto targets = is_thing ? ids_[demand.mention] : ends_at(demand.part, mention);
      requirement.targets.insert(requirement.targets.end(), targets.begin(), targets.end());
      words.push_back(demand.heard);
    }
    requirement.clause = called(mention) + " between " + join(names, " and ");
    add(std::move(requirement), words);
  }

  // "Between the windows" is between any two of those that there are.
  std::vector<std::string> ends_at(const std::string& part, const brief::Mention& mention) const {
    const auto is_second = [](const brief::Demand& demand) {
      return demand.kind == RelationKind::between && demand.part == "window-1";
    };
    if (part.starts_with("window-") &&
        std::any_of(mention.demands.begin(), mention.demands.end(), is_second))
      return parts_called("window");
    return {part_of(room_, part)};
  }

  // --- For each, not there, nothing else ---------------------------------------------------------

  // "a lamp on each desk": with what is said of where the lamps are.
  void each(const brief::SharedOut& share) {
    const brief::Mention& mention = brief_.mentions[share.thing];
    Requirement requirement = about(share.thing, mention, Requirement::Kind::each);
    requirement.subjects = with_parts(share.thing);
    requirement.count = share.count;
    requirement.relation = relation_of(mention, share);
    requirement.targets =
        share.owner != brief::no_mention ? with_parts(share.owner) : parts_called(share.place);
    const std::string owner =
        share.owner != brief::no_mention ? called(brief_.mentions[share.owner]) : share.place;
    requirement.clause = (share.count == 1 ? "a" : std::to_string(share.count)) + " " + called(mention) + " " +
                         std::string(as_told(requirement.relation)) + " each " + owner;
    std::vector<std::size_t> words = words_of(mention, Heard::As::thing);
    words.push_back(share.heard);
    words.push_back(share.word);
    add(std::move(requirement), words);
  }
  static RelationKind relation_of(const brief::Mention& mention, const brief::SharedOut& share) {
    if (share.place == "corner") return RelationKind::corner;
    for (const auto& demand : mention.demands)
      if (share.owner != brief::no_mention && demand.mention == share.owner && !demand.is_means &&
          demand.said_of == brief::Demand::none)
        return demand.said.value_or(demand.kind);
    return RelationKind::near;
  }
  std::vector<std::string> parts_called(const std::string& place) const {
    if (place == "corner") return {place};
    std::vector<std::string> ids;
    for (const auto& opening : room_.openings)
      if (opening.is_entrance() == (place == "door")) ids.push_back(opening.id);
    return ids;
  }

  void denied(const brief::Denial& denial) {
    const brief::Mention& mention = brief_.mentions[denial.thing];
    Requirement requirement = about(denial.thing, mention, Requirement::Kind::relation);
    requirement.subjects = with_parts(denial.thing);
    requirement.relation = denial.kind;
    requirement.denied = true;
    const bool is_thing = denial.target != brief::no_mention;
    requirement.targets = is_thing ? with_parts(denial.target) : std::vector<std::string>{part_of(room_, denial.part)};
    requirement.clause = called(mention) + " not " + std::string(name(denial.kind)) + " " +
                         (is_thing ? called(brief_.mentions[denial.target]) : denial.part);
    add(std::move(requirement), {denial.heard});
  }

  void only(const brief::Limit& limit) {
    Requirement requirement;
    requirement.kind = Requirement::Kind::only;
    requirement.category = limit.category;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i) {
      if (!is_within(i, limit)) continue;
      for (const auto& id : ids_[i]) requirement.subjects.push_back(id);
      if (brief_.mentions[i].part_of == brief::Demand::none)
        names.push_back(called(brief_.mentions[i]));
    }
    if (limit.on != brief::no_mention) requirement.targets = with_parts(limit.on);
    if (limit.mount) requirement.attribute = std::string(mount_attribute).append(name(*limit.mount));
    const bool is_list = !limit.allowed.empty();
    requirement.clause = !limit.category.empty() ? "no other " + limit.category
                         : limit.is_nothing      ? "nothing"
                         : is_list               ? "nothing but " + join(names, ", ")
                                                 : "nothing else";
    if (limit.on != brief::no_mention)
      requirement.clause += " on " + called(brief_.mentions[limit.on]);
    if (limit.mount) requirement.clause += " on the " + std::string(name(*limit.mount));
    add(std::move(requirement), {limit.heard});
  }
  // What is there: of a room all that the prompt asks for, of a list those that it names.
  bool is_within(std::size_t index, const brief::Limit& limit) const {
    if (limit.is_nothing) return false;
    if (limit.is_of_room() || !limit.category.empty()) return true;
    const std::size_t whole = brief_.mentions[index].part_of;
    return std::any_of(limit.allowed.begin(), limit.allowed.end(),
                       [&](std::size_t one) { return one == index || one == whole; });
  }

  void material(const std::string& part, const std::string& said) {
    if (said.empty()) return;
    Requirement requirement;
    requirement.kind = Requirement::Kind::attribute;
    requirement.clause = said;
    requirement.category = part;
    requirement.attribute = said;
    add(std::move(requirement), words_heard_as(brief_, Heard::As::attribute, said));
  }

  void absence(const std::string& category, const std::string& looks) {
    const std::string what = looks.empty() ? category : category.empty() ? looks : looks + " " + category;
    Requirement requirement;
    requirement.kind = Requirement::Kind::absence;
    requirement.category = category;
    requirement.attribute = looks;
    requirement.clause = "no " + what;
    add(std::move(requirement), words_heard_as(brief_, Heard::As::absence, what));
  }

  const PlanRequest& request_;
  const brief::Brief& brief_;
  const Room& room_;
  std::map<std::size_t, std::vector<std::string>> ids_;  ///< by mention
  std::vector<Requirement> requirements_;
  RequirementIds ids_by_words_;
};

}  // namespace

LedgerOfPrompt ledger_of(const PlanRequest& request, const brief::Brief& brief,
                         const std::vector<Draft>& drafts, const Plan& plan) {
  return Ledger(request, brief, drafts, plan).run();
}

}  // namespace roomgen::plan
