#include "brief_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prompt_passes.h"
#include "quotes.h"

namespace roomgen::brief {

namespace {

using MeasureLimit = language::Measure::Limit;

const char* name_of(MeasureLimit limit) {
  return limit == MeasureLimit::least  ? "at least"
         : limit == MeasureLimit::most ? "at most"
                                       : "exact";
}

const char* name_of(Formation::Shape shape) {
  using Shape = Formation::Shape;
  return shape == Shape::rows     ? "rows"
         : shape == Shape::circle ? "circle"
         : shape == Shape::arc    ? "arc"
                                  : "islands";
}

Json numbers(const Vec3& size) {
  return {rounded(size.x(), 9), rounded(size.y(), 9), rounded(size.z(), 9)};
}

/// Writes a brief; what was heard and stands in no clause is written last.
class BriefWriter {
 public:
  BriefWriter(const Brief& brief, std::string_view prompt)
      : brief_(brief), quotes_(prompt, brief.tokens), written_(brief.heard.size(), false) {}

  Json write(std::string_view prompt) {
    Json json = {{"format", "roomgen-brief"}, {"version", 1}, {"wish", prompt}};
    json["room"] = room();
    json["openings"] = openings();
    json["finishes"] = finishes();
    json["styles"] = styled("style", brief_.styles);
    json["palette"] = styled("look", brief_.palette);
    json["people"] = {
        {"count", brief_.people}, {"seats", brief_.seated}, {"words", said(Heard::As::person, "")}};
    json["things"] = Json::array();
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i) json["things"].push_back(thing(i));
    json["absences"] = absences();
    json["limits"] = limits();
    json["rules"] = known_to_rules();
    json["remarks"] = said(Heard::As::room, said_remark);
    json["talk"] = talk();
    json["rooms"] = Json::array();
    return json;
  }

 private:
  std::string id(std::size_t mention) const { return "t" + std::to_string(mention + 1); }

  std::string words(std::size_t heard) {
    written_[heard] = true;
    return quotes_.quote(brief_.heard[heard].tokens);
  }
  // What was taken for that, of a mention's words or of all.
  Json said(Heard::As as, const std::string& word) {
    Json quotes = Json::array();
    for (std::size_t i = 0; i < brief_.heard.size(); ++i)
      if (brief_.heard[i].as == as && brief_.heard[i].word == word) quotes.push_back(words(i));
    return quotes;
  }
  Json said(const Mention& mention, Heard::As as, const std::string& word = "") {
    Json quotes = Json::array();
    for (const std::size_t i : mention.heard)
      if (brief_.heard[i].as == as && brief_.heard[i].word == word) quotes.push_back(words(i));
    return quotes;
  }
  void say(std::size_t heard, Heard::As usual, Json& clause) {
    clause["words"] = Json::array();
    if (heard == HeardWords::none) return;
    clause["words"].push_back(words(heard));
    const HeardWords& own = brief_.heard[heard];
    if (own.as != usual) clause["as"] = name(own.as);
    if (!own.word.empty()) clause["about"] = own.word;
  }

  Json room() {
    Json room = {{"type", brief_.type}, {"words", said(Heard::As::room, "kind")}};
    room["rules"] = {{"known", brief_.type_known}, {"inferred", brief_.type_inferred}};
    Json& clauses = room["clauses"] = Json::array();
    const auto add = [&](const char* is, Json numbers, const std::string& name,
                         const std::string& word) {
      clauses.push_back({{"is", is},
                         {"numbers", std::move(numbers)},
                         {"name", name},
                         {"words", said(Heard::As::room, word)}});
    };
    if (brief_.size) add("size", {brief_.size->x(), brief_.size->y()}, "", "size");
    if (brief_.area) add("area", Json::array({*brief_.area}), "", "area");
    if (brief_.height) add("height", Json::array({*brief_.height}), "", "height");
    if (!brief_.shape.outline.empty()) add("shape", Json::array(), brief_.shape.outline, "shape");
    for (const auto& feature : brief_.shape.features)
      add("feature", Json::array(), feature, feature);
    if (brief_.shape.proportion)
      add("proportion", {brief_.shape.proportion->low, brief_.shape.proportion->high}, "",
          "proportion");
    return room;
  }

  Json openings() {
    Json list = Json::array();
    for (const auto& wish : brief_.openings) {
      Json json = {{"kind", wish.kind},
                   {"count", wish.count},
                   {"large", false},
                   {"walls", Json::array()},
                   {"width", wish.width.value_or(0.0)},
                   {"height", wish.height.value_or(0.0)},
                   {"remarks", Json::array()},
                   {"words", said(Heard::As::thing, wish.kind)}};
      Json& rules = json["rules"] = {{"type", name(wish.type)},
                                     {"counted", wish.counted},
                                     {"wide", wish.wide},
                                     {"high", wish.high}};
      rules["sides"] = wish.sides;
      rules["walls"] = wish.walls;
      if (wish.opposite) rules["opposite"] = name(*wish.opposite);
      if (wish.beside) rules["beside"] = name(*wish.beside);
      list.push_back(std::move(json));
    }
    const bool has_special = std::any_of(
        brief_.openings.begin(), brief_.openings.end(),
        [](const OpeningWish& wish) { return wish.type == OpeningType::window; });
    if (!brief_.windows || (*brief_.windows == 0 && has_special)) return list;
    const Json words = said(*brief_.windows == 0 ? Heard::As::absence : Heard::As::thing, "window");
    list.push_back({{"kind", "window"},
                    {"count", *brief_.windows},
                    {"large", brief_.wide_windows},
                    {"walls", Json::array()},
                    {"width", 0.0},
                    {"height", 0.0},
                    {"remarks", Json::array()},
                    {"words", words},
                    {"rules", {{"plain", true}}}});
    return list;
  }

  Json finishes() {
    Json list = Json::array();
    const auto add = [&](std::string_view part, const std::string& looks) {
      if (!looks.empty())
        list.push_back(
            {{"part", part}, {"looks", looks}, {"words", said(Heard::As::attribute, looks)}});
    };
    add("floor", brief_.materials.floor);
    add("walls", brief_.materials.walls);
    add("ceiling", brief_.materials.ceiling);
    for (const auto& cover : brief_.materials.covers)
      add(cover.wall == accent_name ? "accent wall" : cover.wall, cover.finish);
    return list;
  }

  Json styled(const char* key, const std::vector<std::string>& names) {
    Json list = Json::array();
    for (const auto& name : names)
      list.push_back({{key, name}, {"words", said(Heard::As::style, name)}});
    return list;
  }

  Json thing(std::size_t index) {
    const Mention& mention = brief_.mentions[index];
    Json json = {{"id", id(index)},
                 {"name", mention.noun},
                 {"count", mention.least > 0 ? mention.least : mention.quantity},
                 {"most", mention.most},
                 {"bound", name_of(mention.at_least  ? MeasureLimit::least
                                   : mention.at_most ? MeasureLimit::most
                                                     : MeasureLimit::exact)}};
    json["words"] = said(mention, Heard::As::thing);
    json["count_words"] = said(mention, Heard::As::count);
    json["looks"] = looks(mention, "look", mention.looks);
    json["parts"] = looks(mention, "part", mention.parts);
    json["sizes"] = sizes(mention);
    json["owner"] = mention.owner;
    json["some_of"] = mention.part_of == Demand::none ? "" : id(mention.part_of);
    Json mount = {{"on", name(mention.mount)}};
    say(mention.mount_heard, Heard::As::relation, mount);
    json["mount"] = std::move(mount);
    json["formation"] = nullptr;
    if (mention.formation) {
      const Formation& formation = *mention.formation;
      Json stands = {{"shape", name_of(formation.shape)},
                     {"rows", formation.rows},
                     {"columns", formation.columns}};
      say(mention.formation_heard, Heard::As::relation, stands);
      json["formation"] = std::move(stands);
    }
    json["relations"] = Json::array();
    for (const auto& demand : mention.demands) json["relations"].push_back(relation(demand));
    json["rules"] = known_of(mention);
    return json;
  }

  Json looks(const Mention& mention, const char* key, const std::vector<std::string>& said_of_it) {
    Json list = Json::array();
    for (const auto& look : said_of_it)
      list.push_back({{key, look}, {"words", said(mention, Heard::As::attribute, look)}});
    return list;
  }

  Json sizes(const Mention& mention) {
    Json list = Json::array();
    for (const auto& length : mention.lengths)
      list.push_back({{"side", length.side},
                      {"m", rounded(length.metres, 9)},
                      {"bound", name_of(length.limit)},
                      {"words", said(mention, Heard::As::attribute, said_length)}});
    return list;
  }

  Json known_of(const Mention& mention) {
    return {{"kind", mention.category},
            {"known", mention.known},
            {"description", mention.description},
            {"naming", mention.naming},
            {"quantity", mention.quantity},
            {"counted", mention.counted},
            {"joined_to", mention.joined_to},
            {"list", mention.list},
            {"varied", mention.varied},
            {"seats", mention.seats},
            {"sized", mention.sized},
            {"size", numbers(mention.size)},
            {"sentence", mention.sentence},
            {"source", name(mention.source)},
            {"people_words", said(mention, Heard::As::person)}};
  }

  Json place(RelationKind kind, std::size_t mention, const std::string& part) const {
    return {{"relation", name(kind)},
            {"to", mention == Demand::none ? part : id(mention)},
            {"m", 0.0},
            {"bound", "exact"},
            {"denied", false},
            {"each", 0}};
  }

  Json relation(const Demand& demand) {
    Json json = place(demand.kind, demand.mention, demand.part);
    if (demand.kind == RelationKind::gap) {
      const bool is_least = std::isinf(demand.gap.most);
      json["m"] = is_least ? demand.gap.least : demand.gap.most;
      json["bound"] = name_of(is_least                             ? MeasureLimit::least
                              : demand.gap.least < demand.gap.most ? MeasureLimit::most
                                                                   : MeasureLimit::exact);
      json["least"] = demand.gap.least;
    }
    say(demand.heard, Heard::As::relation, json);
    json["rules"] = {{"flank", demand.flank},
                     {"shared", demand.shared},
                     {"nth", demand.nth},
                     {"listed", demand.listed},
                     {"means", demand.is_means}};
    return json;
  }

  Json absences() {
    Json list = Json::array();
    const auto add = [&](const std::string& category, const std::string& looks) {
      const std::string what = looks.empty()      ? category
                               : category.empty() ? looks
                                                  : looks + " " + category;
      list.push_back(
          {{"name", category}, {"looks", looks}, {"words", said(Heard::As::absence, what)}});
    };
    for (const auto& category : brief_.excluded) add(category, "");
    for (const auto& [category, looks] : brief_.excluded_looks) add(category, looks);
    return list;
  }

  Json limits() {
    Json list = Json::array();
    for (const auto& limit : brief_.limits) {
      Json json = {{"nothing", limit.is_nothing},
                   {"name", limit.category},
                   {"but", Json::array()},
                   {"on", limit.on == no_mention ? "" : id(limit.on)},
                   {"mount", limit.mount ? name(*limit.mount) : ""}};
      for (const std::size_t one : limit.allowed) json["but"].push_back(id(one));
      say(limit.heard, Heard::As::absence, json);
      list.push_back(std::move(json));
    }
    return list;
  }

  Json known_to_rules() {
    Json rules = {{"bare", brief_.bare},
                  {"told_from_door", brief_.told_from_door},
                  {"notes", brief_.notes},
                  {"each", Json::array()},
                  {"denials", Json::array()}};
    for (const auto& share : brief_.shared_out) {
      Json json = {{"thing", id(share.thing)},
                   {"of", share.owner == no_mention ? share.place : id(share.owner)},
                   {"count", share.count}};
      say(share.heard, Heard::As::relation, json);
      json["each_words"] =
          share.word == no_mention ? Json::array() : Json::array({words(share.word)});
      rules["each"].push_back(std::move(json));
    }
    for (const auto& denial : brief_.denials) {
      Json json = place(denial.kind, denial.target, denial.part);
      json["thing"] = id(denial.thing);
      say(denial.heard, Heard::As::relation, json);
      rules["denials"].push_back(std::move(json));
    }
    return rules;
  }

  // What counts as understood without a clause.
  Json talk() {
    Json list = Json::array();
    for (std::size_t i = 0; i < brief_.heard.size(); ++i) {
      const HeardWords& heard = brief_.heard[i];
      if (written_[i] || heard.as < Heard::As::room || heard.as == Heard::As::absence) continue;
      Json entry = {
          {"as", name(heard.as)}, {"about", heard.word}, {"words", Json::array({words(i)})}};
      if (std::find(list.begin(), list.end(), entry) == list.end())
        list.push_back(std::move(entry));
    }
    return list;
  }

  const Brief& brief_;
  const Quotes quotes_;
  std::vector<bool> written_;  ///< of Brief::heard
};

}  // namespace

Json to_json(const Brief& brief, std::string_view prompt) {
  return BriefWriter(brief, prompt).write(prompt);
}

}  // namespace roomgen::brief
