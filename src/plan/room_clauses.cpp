#include "room_clauses.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "brief/bound_mentions.h"
#include "brief/prompt_passes.h"
#include "brief/room_kinds.h"
#include "library/style_words.h"
#include "roomgen/base/text.h"
#include "roomgen/geometry/polygon.h"
#include "scene/attribute_names.h"

namespace roomgen::plan {

namespace {

constexpr double side_tolerance = 0.05;  ///< metres, as the clauses are judged
constexpr double area_share = 0.05;      ///< the same
constexpr double least_long = 1.5;  ///< ratio of the sides of a "long" room; docs/requirements.md

class RoomClauses {
 public:
  RoomClauses(const brief::Brief& brief, const PlanRequest& request, const std::string& type)
      : brief_(brief), request_(request), type_(type) {}

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
      of_room(is_kind ? "kind" : "character", brief::bounded_name(called()), 0.0, "a " + called(),
              words);
    size();
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

  // A hair salon is a barber shop by another of its names.
  const std::string& called() const {
    const auto& kinds = brief::built_in_room_kinds();
    if (!kinds) return brief_.type;
    const auto& names = kinds->get(brief_.type).names;
    return std::find(names.begin(), names.end(), type_) == names.end() ? brief_.type : type_;
  }

  void size() {
    if (brief_.size) {
      const auto words = words_heard_as(brief_, Heard::As::room, "size");
      const double longer = brief_.size->maxCoeff(), shorter = brief_.size->minCoeff();
      const auto given = given_size();
      const bool is_long = !given || is_side(given->maxCoeff(), longer);
      const bool is_wide = !given || is_side(given->minCoeff(), shorter);
      // Sides that cannot be are one contradiction, told once.
      if (!is_long || !is_wide) {
        of_room(is_long ? "shorter side" : "longer side", "", is_long ? shorter : longer,
                sides_text(*brief_.size) + overruled_by(*given), words);
      } else {
        of_room("longer side", "", longer, format_number(longer, 2) + " m long", words);
        of_room("shorter side", "", shorter, format_number(shorter, 2) + " m wide", words);
      }
    }
    if (brief_.area) {
      const auto given = given_size();
      const bool is_other =
          given && std::abs(given->prod() - *brief_.area) > area_share * *brief_.area;
      of_room("area", "", *brief_.area,
              format_number(*brief_.area, 2) + " m2" + (is_other ? overruled_by(*given) : ""),
              words_heard_as(brief_, Heard::As::room, "area"));
    }
  }

  // Beside the prompt; how the rooms of a dwelling lie nobody has said.
  std::optional<Vec2> given_size() const {
    if (request_.room)
      return request_.room->id.empty() ? std::optional(bounds(request_.room->polygon).size())
                                       : std::nullopt;
    return request_.size;
  }
  static bool is_side(double given, double said) {
    return std::abs(given - said) <= side_tolerance;
  }
  static std::string sides_text(const Vec2& size) {
    return format_number(size.x(), 2) + " x " + format_number(size.y(), 2) + " m";
  }
  std::string overruled_by(const Vec2& given) const {
    return std::string(", but the ") + (request_.room ? "floor plan" : "size") +
           " that is given, " + sides_text(given) + ", wins";
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
      if (StyleWords::built_in().find(style))
        of_room("style", brief::bounded_name(style), 0.0, style,
                words_heard_as(brief_, Heard::As::style, style));
    for (const auto& colors : brief_.palette)
      of_room("palette", brief::bounded_name(colors), 0.0, colors,
              words_heard_as(brief_, Heard::As::style, colors));
  }

  // What nothing in a room can show, each in its own words.
  void remarks() {
    for (std::size_t i = 0; i < brief_.heard.size(); ++i) {
      const brief::HeardWords& words = brief_.heard[i];
      if (words.word != brief::said_remark) continue;
      const std::string text = text_of(words.tokens);
      of_room(words.as == Heard::As::activity ? "activity" : "character", brief::bounded_name(text),
              0.0, text, {i});
    }
  }
  std::string text_of(const language::Run& tokens) const {
    const auto begin = brief_.tokens[tokens.begin].span.begin, end = brief_.tokens[tokens.end - 1].span.end;
    return request_.prompt.substr(begin, end - begin);
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

  const brief::Brief& brief_;
  const PlanRequest& request_;
  const std::string& type_;  ///< of the room that is planned
  std::vector<SaidClause> clauses_;
};

}  // namespace

std::vector<std::size_t> words_heard_as(const brief::Brief& brief, Heard::As as,
                                        const std::string& word) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < brief.heard.size(); ++i)
    if (brief.heard[i].as == as && brief.heard[i].word == word) result.push_back(i);
  return result;
}

std::vector<SaidClause> clauses_of_room(const brief::Brief& brief, const PlanRequest& request,
                                        const std::string& type) {
  return RoomClauses(brief, request, type).run();
}

}  // namespace roomgen::plan
