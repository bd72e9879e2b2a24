#include "room_clauses.h"

#include <algorithm>

#include "brief/bound_mentions.h"
#include "brief/prompt_remarks.h"
#include "library/style_words.h"
#include "roomgen/base/text.h"
#include "scene/seats_attribute.h"

namespace roomgen::design {

namespace {

constexpr double least_long = 1.5;  ///< ratio of the sides of a "long" room; docs/requirements.md

class RoomClauses {
 public:
  RoomClauses(const Brief& brief, const std::string& prompt) : brief_(brief), prompt_(prompt) {}

  std::vector<SaidClause> run() {
    room();
    return std::move(clauses_);
  }

 private:
  void of_room(const char* what, const std::string& category, double amount, std::string clause,
               const std::vector<std::size_t>& words, bool at_least = false) {
    Requirement requirement;
    requirement.kind = Requirement::Kind::room;
    requirement.attribute = what;
    requirement.category = category;
    requirement.amount = amount;
    requirement.at_least = at_least;
    requirement.clause = std::move(clause);
    clauses_.push_back({std::move(requirement), words});
  }

  void room() {
    // A room of a kind that nobody knows may be anything.
    const bool is_kind = brief_.type_known && !brief_.type_inferred;
    if (const auto words = words_heard_as(brief_, Heard::As::room, "kind"); !words.empty())
      of_room(is_kind ? "kind" : "character", bounded_name(brief_.type), 0.0, "a " + brief_.type, words);
    if (brief_.size) {
      const auto words = words_heard_as(brief_, Heard::As::room, "size");
      const double longer = brief_.size->maxCoeff(), shorter = brief_.size->minCoeff();
      of_room("longer side", "", longer, format_number(longer, 2) + " m long", words);
      of_room("shorter side", "", shorter, format_number(shorter, 2) + " m wide", words);
    }
    if (brief_.area)
      of_room("area", "", *brief_.area, format_number(*brief_.area, 2) + " m2",
              words_heard_as(brief_, Heard::As::room, "area"));
    if (brief_.height)
      of_room("height", "", *brief_.height, format_number(*brief_.height, 2) + " m high",
              words_heard_as(brief_, Heard::As::room, "height"));
    if (!brief_.shape.outline.empty())
      of_room("shape", brief_.shape.outline, 0.0, brief_.shape.outline + "-shaped room",
              words_heard_as(brief_, Heard::As::room, "shape"));
    if (brief_.shape.proportion) {
      const double ratio = std::min(brief_.shape.proportion->low, least_long);
      of_room("proportion", "", ratio, "a long room", words_heard_as(brief_, Heard::As::room, "proportion"), true);
    }
    openings();
    seats();
    styles();
    remarks();
  }

  // "for eight people"
  void seats() {
    if (brief_.seated < 2) return;
    std::vector<std::size_t> words;
    for (std::size_t i = 0; i < brief_.heard.size(); ++i)
      if (brief_.heard[i].as == Heard::As::person) words.push_back(i);
    of_room(seats_for_people.data(), "", brief_.seated, "seats for " + std::to_string(brief_.seated) + " people", words, true);
  }

  // How the room looks as a whole; moods that no style is defined by only colour what is chosen.
  void styles() {
    for (const auto& style : brief_.styles)
      if (StyleWords::built_in().find(style)) of_room("style", bounded_name(style), 0.0, style, words_heard_as(brief_, Heard::As::style, style));
    for (const auto& colors : brief_.palette) of_room("palette", bounded_name(colors), 0.0, colors, words_heard_as(brief_, Heard::As::style, colors));
  }

  // What nothing in a room can show, each in its own words.
  void remarks() {
    for (std::size_t i = 0; i < brief_.heard.size(); ++i) {
      const HeardWords& words = brief_.heard[i];
      if (words.word != said_remark) continue;
      const std::string text = text_of(words.tokens);
      of_room(words.as == Heard::As::activity ? "activity" : "character", bounded_name(text), 0.0, text, {i});
    }
  }
  std::string text_of(const language::Run& tokens) const {
    const auto begin = brief_.tokens[tokens.begin].span.begin, end = brief_.tokens[tokens.end - 1].span.end;
    return prompt_.substr(begin, end - begin);
  }

  void openings() {
    for (const auto& wish : brief_.openings) {
      const std::string clause = std::to_string(wish.count) + " " + wish.kind;
      of_room("openings", wish.kind, wish.count, clause, words_heard_as(brief_, Heard::As::thing, wish.kind),
              !wish.counted);
    }
    const auto words = words_heard_as(brief_, Heard::As::thing, "window");
    if (brief_.windows && *brief_.windows > 0)
      of_room("openings", "window", *brief_.windows, std::to_string(*brief_.windows) + " windows",
              words, true);
    else if (brief_.windows && !words_heard_as(brief_, Heard::As::absence, "window").empty())
      of_room("openings", "window", 0.0, "no windows", words_heard_as(brief_, Heard::As::absence, "window"));
  }

  const Brief& brief_;
  const std::string& prompt_;
  std::vector<SaidClause> clauses_;
};

}  // namespace

std::vector<std::size_t> words_heard_as(const Brief& brief, Heard::As as, const std::string& word) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < brief.heard.size(); ++i)
    if (brief.heard[i].as == as && brief.heard[i].word == word) result.push_back(i);
  return result;
}

std::vector<SaidClause> clauses_of_room(const Brief& brief, const std::string& prompt) { return RoomClauses(brief, prompt).run(); }

}  // namespace roomgen::design
