#include "settings.h"

#include <algorithm>

#include "base/random.h"
#include "library/looks.h"
#include "prints.h"
#include "relative_size.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "shape/color.h"
#include "shape/motifs.h"
#include "sizing.h"

namespace roomgen::create {

namespace {

// "shelf" is counted by `shelves`, an armrest by `arms`.
std::vector<std::string> counters(std::string label) {
  std::replace(label.begin(), label.end(), ' ', '_');
  std::vector<std::string> names = {label + "s", label + "es", label};
  if (label.ends_with("f")) names.insert(names.begin(), label.substr(0, label.size() - 1) + "ves");
  if (label == "foot") names.insert(names.begin(), {"feet", "legs"});
  if (label == "armrest") names.insert(names.begin(), "arms");
  if (label == "pole") names.push_back("posts");
  if (label == "shelf") names.insert(names.end(), {"levels", "tiers", "boards", "rows"});
  if (label == "step" || label == "rung") names.insert(names.end(), {"steps", "rungs"});
  if (label == "bulb") names.insert(names.end(), {"shades", "lights", "arms"});
  if (label == "shade") names.insert(names.end(), {"bulbs", "arms"});
  if (label == "pillow" || label == "cushion") names.insert(names.end(), {"cushions", "pillows"});
  if (label == "slat" || label == "spindle") names.insert(names.end(), {"slats", "spindles"});
  if (label == "leaf") names.push_back("leaves");
  if (label == "tray") names.push_back("shelves");
  if (label == "arm" || label == "candle") names.push_back("bulbs");
  if (label == "peg") names.push_back("hooks");
  if (label == "basin" || label == "sink") names.insert(names.end(), {"sinks", "basins"});
  return names;
}

constexpr double widest_on_a_pole = 0.7;  // a sofa's base is no pedestal

double curve_of(const PartWish& part) {
  if (*part.course == Course::straight) return 0.0;
  return part.strength == Strength::gentle ? 0.35 : part.strength == Strength::moderate ? 0.65 : 1.0;
}

class Chooser {
 public:
  Chooser(const Description& description, const ShapeKind& kind,
          const std::vector<shape::Parameter>& parameters, const Words& words, std::uint64_t seed)
      : description_(description),
        kind_(kind),
        parameters_(parameters),
        words_(words),
        random_(Random(seed).fork("settings")) {}

  Settings run() {
    result_.values = kind_.set;
    vary();
    if (const auto style = kind_.styles.find(description_.style); style != kind_.styles.end())
      for (const auto& [name, value] : style->second) result_.values[name] = value;
    color_whole();
    print();
    for (const auto& part : description_.parts) result_.unmet.push_back(say(part));
    seat_people();
    set_size();
    result_.values = shape::clamped(parameters_, result_.values);
    return std::move(result_);
  }

 private:
  const shape::Parameter* find(const std::string& name) const {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const auto& parameter) { return parameter.name == name; });
    return found == parameters_.end() ? nullptr : &*found;
  }

  void vary() {
    for (const auto& [name, choices] : kind_.vary) {
      Random random = random_.fork(name);
      if (!choices.empty()) result_.values[name] = random.pick(choices);
    }
  }

  void color_whole() {
    const shape::Parameter* main = find(kind_.main);
    if (!main) return;
    // A model's description may hold any words.
    const auto material = words_.materials.find(description_.material);
    if (material != words_.materials.end()) result_.values[main->name] = material->second.color;
    if (shape::parse_color(description_.color)) result_.values[main->name] = description_.color;
  }

  // What a picture shows, and what it or a sign says.
  void print() {
    const Print print = print_on_it();
    const auto set = [&](const char* name, const std::string& text) {
      const shape::Parameter* parameter = find(name);
      if (parameter && parameter->text && !text.empty()) result_.values[name] = text;
    };
    const bool has_words = !print.words.empty() && find("words");
    const auto own = kind_.set.find("theme");
    if (own == kind_.set.end() || own->second != shape::Value(std::string("mirror")))
      set("theme", print.motif.empty() && has_words ? "plain" : print.motif);
    set("palette", print.palette);
    const bool is_sign = kind_.set.count("words") > 0;
    const std::string words =
        print.words.empty() && is_sign ? shape::text_in(description_.prompt) : print.words;
    const bool is_large = is_sign || print.motif.empty();
    set("words", is_large ? in_lines(words) : words);
    if (!words.empty()) (void)set_word("light_style", "neon word");
  }

  Print print_on_it() {
    Print print = print_in(description_.prompt);
    if (!KindTable::built_in().is_any_of(kind_.name, printed_cloths)) return print;
    const auto prints = shape::motifs_on_cloth(description_.prompt);
    print.motif = prints.empty() ? "" : prints.front();
    if (!print.motif.empty() && find("theme")) (void)set_word("pattern", "none");
    return print;
  }

  bool set_word(const std::string& name, const std::string& word) {
    const shape::Parameter* parameter = find(name);
    if (!parameter) return false;
    const auto& choices = parameter->choices;
    if (std::find(choices.begin(), choices.end(), word) == choices.end()) return false;
    result_.values[name] = word;
    return true;
  }

  bool set_number(const std::string& name, double value) {
    const shape::Parameter* parameter = find(name);
    if (!parameter || !parameter->choices.empty() || parameter->color) return false;
    if (value < parameter->min || value > parameter->max) return false;
    result_.values[name] = value;
    return true;
  }

  bool set_count(const std::string& label, int count) {
    for (const auto& name : counters(label)) {
      if (set_number(name, count)) return true;
      // One number for a yes or no: "with a canopy".
      if (count > 1 || !find(name)) continue;
      if (set_number(name, count)) return true;
    }
    return false;
  }

  // A part without a name is the whole: whatever shows most of its shape, or has any.
  std::vector<std::string> labels_of(const PartWish& part) const {
    if (!part.label.empty()) return {part.label};
    std::vector<std::string> labels = {"top", "seat", "back", "shade", "body", "base", "pot", "mirror", "frame", "leg", "shelf"};
    for (const auto& parameter : parameters_)
      if (parameter.name.ends_with("_shape"))
        labels.push_back(parameter.name.substr(0, parameter.name.size() - std::string_view("_shape").size()));
    for (const auto& parameter : parameters_)
      if (parameter.name.ends_with("_style"))
        labels.push_back(parameter.name.substr(0, parameter.name.size() - std::string_view("_style").size()));
    return labels;
  }

  // A part may need a way of building: spindles a back of spindles, eight arms a chandelier of arms, one leg
  // in the middle a pedestal. What was asked for by name stays.
  void build_for(const PartWish& part) {
    if (part.label.empty() || part.count.value_or(1) == 0) return;
    const bool pedestal = (part.label == "leg" && part.count == 1) ||
                          (part.label == "base" && (find("base_shape") || kind_.size.x() < widest_on_a_pole));
    if (pedestal) (void)set_word("leg_style", "pedestal");
    // Two mirrored doors of four are no four.
    if (part.label == "mirror" && find("mirrors")) (void)set_word("door_style", "panel");
    for (const auto& parameter : parameters_) {
      if (!parameter.name.ends_with("_style") || asked_.count(parameter.name)) continue;
      for (const auto& name : counters(part.label))
        if (set_word(parameter.name, name)) return;
    }
  }

  bool build(const std::string& label, const std::string& construction) {
    if (!set_word(label + "_style", construction)) return false;
    asked_.insert(label + "_style");
    return true;
  }

  Settings::Unmet say(const PartWish& part) {
    Settings::Unmet unmet;
    const auto labels = labels_of(part);
    build_for(part);
    const auto any = [&](auto set) { return std::any_of(labels.begin(), labels.end(), set); };
    if (part.count) unmet.count = !set_count(part.label, *part.count);
    else if (!part.label.empty()) make_present(part.label);
    if (!part.shape.empty()) {
      unmet.shape = !any([&](const auto& label) { return set_shape(label, part.shape); }) &&
                    !set_word("shape", part.shape);
    }
    if (!part.construction.empty())
      (void)(any([&](const auto& label) { return build(label, part.construction); }) ||
             // Arms that are rolled are round.
             (part.construction == "rolled" && any([&](const auto& label) { return build(label, "round"); })));
    if (part.lean)
      unmet.lean = !any([&](const auto& label) {
        if (!set_number(label + "_lean", *part.lean)) return false;
        // Hairpins and lions' feet do not lean; what is straight does.
        if (!asked_.count(label + "_style")) (void)(set_word(label + "_style", "tapered") || set_word(label + "_style", "round"));
        return true;
      });
    if (part.course)
      unmet.course = !any([&](const auto& label) {
        return set_number(label + "_curve", curve_of(part)) || set_word(label + "_shape", "curved") ||
               set_word(label + "_style", "curved");
      });
    if (part.size && !part.label.empty()) unmet.size = say_size(part);
    const double thicker = part.scale.x();
    if (thicker != 1.0)
      for (const auto& label : labels)
        if (const auto* parameter = find(label + "_thickness"))
          if (const double* usual = std::get_if<double>(&parameter->value))
            result_.values[parameter->name] =
                std::clamp(*usual * thicker, parameter->min, parameter->max);
    return unmet;
  }

  // What no parameter says of the part's width, depth and height is left in `unmet`.
  Vec3 say_size(const PartWish& part) {
    Vec3 unmet = *part.size;
    const bool upright = part.size->z() > 0.1 || stands(part.label);
    for (int axis = 0; axis < 3; ++axis) {
      const double side = unmet[axis];
      if (std::isnan(side)) continue;
      const bool thick = upright ? axis < 2 : axis == 2;
      if (set_number(part.label + "_" + axes[axis], side) || (thick && set_number(part.label + "_thickness", side)))
        unmet[axis] = std::nan("");
    }
    return unmet;
  }

  static bool stands(const std::string& label) {
    return label == "leg" || label == "pole" || label == "post" || label == "foot";
  }

  bool set_shape(const std::string& label, const std::string& shape) {
    const std::string name = label + "_shape";
    if (set_word(name, shape)) return true;
    // Recipes that know no square ones mean the same by rectangular, and so on.
    if (shape == "square" && set_word(name, "rectangular")) return true;
    if (shape == "rectangular") return set_word(name, "square");
    if (shape == "oval" || shape == "globe") return set_word(name, "round");
    if (label == "leg" && shape == "square") return set_word("leg_style", "straight") || set_word("leg_style", "block");
    if (label == "leg" && shape == "round") return set_word("leg_style", "round");
    if (shape == "round") return set_word(name, "oval") || set_word(name, "domed") || set_word(name, "cylindrical");
    return false;
  }

  // A part that was named without a number is there.
  void make_present(const std::string& label) {
    for (const auto& name : counters(label)) {
      const auto* parameter = find(name);
      if (!parameter || !parameter->choices.empty() || parameter->color || parameter->max < 1) continue;
      const auto set = result_.values.find(name);
      const shape::Value& value = set == result_.values.end() ? parameter->value : set->second;
      if (const double* number = std::get_if<double>(&value); number && *number < 1.0)
        result_.values[name] = std::max(1.0, parameter->min);
      break;
    }
    if (const auto* style = find(label + "_style")) {
      const auto set = result_.values.find(style->name);
      const shape::Value& value = set == result_.values.end() ? style->value : set->second;
      if (value == shape::Value(std::string("none")))
        for (const auto& choice : style->choices)
          if (choice != "none") {
            result_.values[style->name] = choice;
            return;
          }
    }
  }

  // A sofa for four has four seats.
  void seat_people() {
    const auto people = read_relative_size(description_.prompt).people;
    const bool told = std::any_of(description_.parts.begin(), description_.parts.end(),
                                  [](const auto& part) { return part.label == "cushion" && part.count; });
    if (people && !told && kind_.growth.count("cushions")) (void)set_number("cushions", *people);
  }

  void set_size() {
    Sizing sizing = choose_size(description_, kind_, parameters_, result_.values, random_.fork("size"));
    result_.size = sizing.size;
    result_.notes.insert(result_.notes.end(), sizing.notes.begin(), sizing.notes.end());
    for (int axis = 0; axis < 3; ++axis) result_.values[axes[axis]] = result_.size[axis];
  }

  const Description& description_;
  const ShapeKind& kind_;
  const std::vector<shape::Parameter>& parameters_;
  const Words& words_;
  Random random_;
  WordSet asked_;  ///< parameters that the description names
  Settings result_;
};

}  // namespace

shape::Values usual_values(const ShapeKind& kind, const std::vector<shape::Parameter>& parameters) {
  shape::Values values = kind.set;
  for (int axis = 0; axis < 3; ++axis) values[axes[axis]] = kind.size[axis];
  return shape::clamped(parameters, values);
}

Settings choose_settings(const Description& description, const ShapeKind& kind,
                         const std::vector<shape::Parameter>& parameters, const Words& words,
                         std::uint64_t seed) {
  return Chooser(description, kind, parameters, words, seed).run();
}

}  // namespace roomgen::create
