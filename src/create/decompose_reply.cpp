#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "description_words.h"
#include "maker_replies.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr std::size_t max_objects = 20;
constexpr double centimetre = 0.01;

const std::vector<std::string> object_lists = {"objects", "items", "furniture"};
const std::vector<std::string> part_lists = {"parts", "components"};
const std::vector<std::string> noun_keys = {"object", "name", "noun", "type"};
const std::vector<std::string> label_keys = {"label", "name", "part", "component"};
const std::vector<std::string> count_keys = {"count", "quantity", "number"};
const std::vector<std::string> color_keys = {"color", "colour"};
const std::vector<std::string> size_keys = {"size cm", "size", "dimensions cm", "dimensions"};
const std::vector<std::string> touch_keys = {"touches", "connects to", "connected to",
                                             "connections"};

// Words by which models say that nothing was said.
bool says_nothing(const std::string& text) {
  const std::string plain = lower(text);
  return plain == "none" || plain == "null" || plain == "n/a" || plain == "unspecified" ||
         plain == "default";
}

std::string text_of(const Json& object, const std::vector<std::string>& keys,
                    std::size_t limit = max_word) {
  const Json* value = member(object, keys);
  if (!value || !value->is_string()) return "";
  std::string text = shortened(std::string(trim(value->get_ref<const std::string&>())), limit);
  return says_nothing(text) ? "" : text;
}

// "Front Legs" is the label "front leg".
std::string label_of(const std::string& text) {
  auto pieces = words(text);
  if (pieces.empty()) return "";
  pieces.back() = singular(pieces.back());
  return shortened(join(pieces, " "), max_word);
}

std::optional<double> number_in(const Json* value) {
  if (!value) return std::nullopt;
  const auto measure = brief::single_measure(*value);
  return measure ? std::optional(measure->value) : std::nullopt;
}

/// Reads one object after the other, up to the bounds.
class ObjectReader {
 public:
  ObjectReader(const std::string& prompt, const std::vector<std::string>& kinds,
               std::vector<std::string>& repairs)
      : prompt_(prompt), kinds_(kinds), repairs_(repairs) {}

  Result<Description> read(const Json& json, const std::string& pointer) {
    Description description;
    description.noun = text_of(json, noun_keys);
    if (description.noun.empty())
      return Error{Error::Kind::invalid_input,
                   pointer + "/object: missing; expected what the object is called"};
    description.prompt = text_of(json, {"words", "prompt"}, max_prompt);
    if (description.prompt.empty()) description.prompt = prompt_;
    read_kind(json, description);
    description.count = count_of(json, description.noun, 1).value_or(1);
    description.style = text_of(json, {"style"});
    description.material = text_of(json, {"material"});
    description.color = text_of(json, color_keys);
    unit_ = 0.0;
    description.size = size_of(json, description.noun);
    const Json* parts = member(json, part_lists);
    if (parts && !parts->is_array())
      return Error{Error::Kind::invalid_input, pointer + "/parts: expected an array"};
    if (parts) read_parts(*parts, description);
    join_parts(json, description);
    return description;
  }

 private:
  void note(const std::string& what) {
    if (std::find(repairs_.begin(), repairs_.end(), what) == repairs_.end())
      repairs_.push_back(what);
  }

  void read_kind(const Json& json, Description& description) {
    const std::string kind = lower(text_of(json, {"kind"}));
    if (kind.empty()) return;
    const bool known = std::find(kinds_.begin(), kinds_.end(), kind) != kinds_.end();
    description.kind = known ? kind : closest_name(kind, kinds_);
    if (description.kind.empty()) return note("the kind \"" + kind + "\" is not known");
    const Json* approximate = member(json, {"approximate"});
    description.approximate = approximate && *approximate == Json(true);
  }

  std::optional<int> count_of(const Json& json, const std::string& of, int least) {
    const Json* given = member(json, count_keys);
    if (!given) return std::nullopt;
    const auto count = brief::count_in(*given);
    if (!count) {
      note("the count of the " + of + " is no number");
      return std::nullopt;
    }
    const int kept = std::clamp(*count, least, max_count);
    if (kept != *count)
      note("instead of " + std::to_string(*count) + " of the " + of + " " + std::to_string(kept) +
           " are taken");
    return kept;
  }

  // A list with null for what is not said, or an object of sides.
  static Vec3 sides_of(const Json& given, bool& in_metres) {
    Vec3 sides = Vec3::Constant(std::nan(""));
    const auto put = [&](int axis, const Json* value) {
      if (!value || value->is_null()) return;
      const auto measure = brief::single_measure(*value);
      if (!measure) return;
      sides[axis] = measure->value;
      in_metres = in_metres || measure->has_unit;
    };
    if (given.is_array()) {
      for (std::size_t k = 0; k < std::min<std::size_t>(3, given.size()); ++k)
        put(static_cast<int>(k), &given[k]);
    } else if (given.is_object()) {
      put(0, member(given, {"width", "w", "x", "diameter"}));
      put(1, member(given, {"depth", "d", "y", "length", "diameter"}));
      put(2, member(given, {"height", "h", "z", "thickness"}));
    } else if (given.is_string()) {
      const auto measures = brief::measures_in(given);
      for (std::size_t k = 0; k < std::min<std::size_t>(3, measures.size()); ++k) {
        sides[static_cast<int>(k)] = measures[k].value;
        in_metres = in_metres || measures[k].has_unit;
      }
    }
    return sides;
  }

  // No piece of furniture is less than 5 cm in all directions, so that such numbers are metres; the
  // parts are written like the whole.
  double unit_of(const Vec3& sides) {
    double greatest = 0.0;
    for (const double side : sides)
      if (!std::isnan(side)) greatest = std::max(greatest, side);
    if (unit_ == 0.0) unit_ = greatest < 5.0 && greatest > 0.0 ? 1.0 : centimetre;
    return unit_;
  }

  std::optional<Vec3> size_of(const Json& json, const std::string& of) {
    const Json* given = member(json, size_keys);
    if (!given) return std::nullopt;
    bool in_metres = false;
    Vec3 size = sides_of(*given, in_metres);
    if (!in_metres) size *= unit_of(size);
    bool bounded = false, any = false;
    for (double& side : size) {
      // A side of 0 is one that was not said.
      if (!(side > 0.0)) side = std::nan("");
      if (std::isnan(side)) continue;
      any = true;
      const double kept = std::clamp(side, least_size, greatest_size);
      bounded = bounded || kept != side;
      side = kept;
    }
    if (bounded) note("the size of the " + of + " was bounded");
    return any ? std::optional(size) : std::nullopt;
  }

  void read_parts(const Json& list, Description& description) {
    if (list.size() > max_parts)
      note("only the first " + std::to_string(max_parts) + " parts were kept");
    for (const auto& json : list) {
      if (description.parts.size() == max_parts) break;
      if (auto part = part_of(json)) description.parts.push_back(*std::move(part));
    }
  }

  std::optional<PartWish> part_of(const Json& json) {
    PartWish part;
    part.label = label_of(json.is_string() ? json.get<std::string>() : text_of(json, label_keys));
    if (part.label.empty()) {
      note("a part without a label was left out");
      return std::nullopt;
    }
    part.count = count_of(json, part.label, 0);
    part.shape = text_of(json, {"shape"});
    part.construction = with_symmetry(text_of(json, {"construction"}), json);
    part.material = text_of(json, {"material"});
    part.color = text_of(json, color_keys);
    const auto lean = number_in(member(json, {"lean", "lean degrees", "tilt"}));
    if (lean && *lean != 0.0) part.lean = std::clamp(*lean, -greatest_lean, greatest_lean);
    read_course(json, part);
    part.size = size_of(json, part.label);
    if (const Json* touches = member(json, touch_keys)) read_touches(*touches, part);
    return part;
  }

  // How copies are arranged belongs to how the thing is built.
  static std::string with_symmetry(std::string construction, const Json& json) {
    const auto said = words(text_of(json, {"symmetry", "arrangement"}));
    const auto says = [&](const char* word) {
      return std::find(said.begin(), said.end(), word) != said.end();
    };
    const char* arrangement = says("mirror") || says("mirrored") || says("bilateral")
                                  ? "in mirrored pairs"
                              : says("ring") || says("radial") ? "in a ring"
                              : says("row")                    ? "in a row"
                                                               : "";
    if (*arrangement == '\0') return construction;
    if (!construction.empty()) construction += ", ";
    return shortened(construction + arrangement, max_word);
  }

  void read_course(const Json& json, PartWish& part) {
    const Json* curve = member(json, {"curvature", "curve"});
    const Json& source = curve && curve->is_object() ? *curve : json;
    std::string course = text_of(source, {"course", "type"});
    if (course.empty() && curve && curve->is_string()) course = curve->get<std::string>();
    const std::string strength = text_of(source, {"strength", "intensity"});
    if (!course.empty()) {
      part.course = course_named(course);
      if (!part.course) note("the course \"" + shortened(course, 40) + "\" is not known");
    }
    part.strength = strength_named(strength).value_or(Strength::moderate);
    part.direction = text_of(source, {"direction"});
  }

  static void read_touches(const Json& list, PartWish& part) {
    const auto add = [&](const Json& other) {
      const std::string label = other.is_string() ? label_of(other.get<std::string>()) : "";
      const bool known =
          std::find(part.touches.begin(), part.touches.end(), label) != part.touches.end();
      if (!label.empty() && !known && part.touches.size() < max_touches)
        part.touches.push_back(label);
    };
    if (list.is_array())
      for (const auto& other : list) add(other);
    else
      add(list);
  }

  // [["leg", "seat"], ...] beside the parts.
  static void join_parts(const Json& json, Description& description) {
    const Json* pairs = member(json, {"connections"});
    if (!pairs || !pairs->is_array()) return;
    for (const auto& pair : *pairs) {
      if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string()) continue;
      const std::string label = label_of(pair[0].get<std::string>());
      for (auto& part : description.parts)
        if (part.label == label) read_touches(pair[1], part);
    }
  }

  const std::string& prompt_;
  const std::vector<std::string>& kinds_;
  std::vector<std::string>& repairs_;
  double unit_ = 0.0;  ///< metres that the numbers of this object count; 0: not known yet
};

// The list of objects, or the answer itself when it is a single one.
Json objects_in(const Json& answer) {
  const Json* list = member(answer, object_lists);
  if (list && list->is_array()) return *list;
  return Json::array({list && list->is_object() ? *list : answer});
}

}  // namespace

Result<Reading<std::vector<Description>>> read_decompose_reply(
    const std::string& text, const std::string& prompt, const std::vector<std::string>& kinds) {
  auto loose =
      find_json(text, {{"objects"}, {"items", "furniture", "parts", "components"}});
  if (!loose) return loose.error();
  Reading<std::vector<Description>> reading{{}, std::move(loose->repairs)};
  ObjectReader reader(prompt, kinds, reading.repairs);
  const Json objects = objects_in(loose->json);
  if (objects.empty())
    return Error{Error::Kind::invalid_input, "/objects: empty; expected one object or more"};
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (k == max_objects) {
      reading.repairs.push_back("only the first " + std::to_string(max_objects) +
                                " objects were kept");
      break;
    }
    const std::string pointer = "/objects/" + std::to_string(k);
    auto description = reader.read(objects[k], pointer);
    if (!description) return description.error();
    if (description->parts.empty() && reading.complaint.empty())
      reading.complaint = pointer + "/parts: empty; list the parts that the object consists of";
    reading.value.push_back(*std::move(description));
  }
  return reading;
}

}  // namespace roomgen::create
