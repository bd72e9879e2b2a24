#include "settings.h"

#include <algorithm>
#include <cmath>

#include "roomgen/base/random.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/color.h"

namespace roomgen::create {

namespace {

constexpr double size_variation = 0.05;  // of the usual size, either way
constexpr double least_side = 0.01, greatest_side = 5.0;
constexpr const char* axes[] = {"width", "depth", "height"};

// "shelf" is counted by `shelves`, an armrest by `arms`.
std::vector<std::string> counters(const std::string& label) {
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
  return names;
}

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
    for (const auto& part : description_.parts) result_.unmet.push_back(say(part));
    choose_size();
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

  // A part without a name is the whole: whatever shows most of its shape.
  std::vector<std::string> labels_of(const PartWish& part) const {
    if (!part.label.empty()) return {part.label};
    return {"top", "seat", "back", "shade", "body", "base", "pot", "mirror", "frame", "leg", "shelf"};
  }

  Settings::Unmet say(const PartWish& part) {
    Settings::Unmet unmet;
    const auto labels = labels_of(part);
    const auto any = [&](auto set) { return std::any_of(labels.begin(), labels.end(), set); };
    if (part.count) unmet.count = !set_count(part.label, *part.count);
    else if (!part.label.empty()) make_present(part.label);
    if (!part.shape.empty()) {
      unmet.shape = !any([&](const auto& label) { return set_shape(label, part.shape); }) &&
                    !set_word("shape", part.shape);
    }
    if (!part.construction.empty())
      (void)any([&](const auto& label) { return set_word(label + "_style", part.construction); });
    if (part.lean)
      unmet.lean = !any([&](const auto& label) { return set_number(label + "_lean", *part.lean); });
    if (part.course)
      unmet.course = !any([&](const auto& label) {
        return set_number(label + "_curve", curve_of(part)) || set_word(label + "_shape", "curved") ||
               set_word(label + "_style", "curved");
      });
    const double thicker = part.scale.x();
    if (thicker != 1.0)
      for (const auto& label : labels)
        if (const auto* parameter = find(label + "_thickness"))
          if (const double* usual = std::get_if<double>(&parameter->value))
            result_.values[parameter->name] =
                std::clamp(*usual * thicker, parameter->min, parameter->max);
    return unmet;
  }

  bool set_shape(const std::string& label, const std::string& shape) {
    const std::string name = label + "_shape";
    if (set_word(name, shape)) return true;
    // Recipes that know no square ones mean the same by rectangular, and so on.
    if (shape == "square") return set_word(name, "rectangular");
    if (shape == "rectangular") return set_word(name, "square");
    if (shape == "oval") return set_word(name, "round");
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

  void choose_size() {
    Random random = random_.fork("size");
    for (int axis = 0; axis < 3; ++axis) {
      double side = kind_.size[axis] * random.uniform(1 - size_variation, 1 + size_variation);
      side = std::clamp(side * description_.scale[axis], kind_.least[axis], kind_.most[axis]);
      if (description_.size && !std::isnan((*description_.size)[axis]))
        side = std::clamp((*description_.size)[axis], least_side, greatest_side);
      side = std::round(side * 1000) / 1000;
      if (const auto* parameter = find(axes[axis])) {
        const double kept = std::clamp(side, parameter->min, parameter->max);
        if (std::abs(kept - side) > 1e-9)
          result_.notes.push_back(std::string(axes[axis]) + " " + format_number(side) + " m was brought to " +
                                  format_number(kept) + " m, as far as a " + kind_.name + " goes");
        side = kept;
      }
      result_.size[axis] = side;
    }
    square_up();
    for (int axis = 0; axis < 3; ++axis) result_.values[axes[axis]] = result_.size[axis];
  }

  // What is round or square is as deep as it is wide.
  void square_up() {
    if (description_.size && !std::isnan((*description_.size)[0] + (*description_.size)[1])) return;
    for (const auto& part : description_.parts) {
      const bool outer = part.label.empty() || part.label == "top" || part.label == "seat";
      if (!outer || (part.shape != "round" && part.shape != "square")) continue;
      if (kind_.size.x() > 2.2 * kind_.size.y()) continue;
      const double side = description_.size && !std::isnan((*description_.size)[0])
                              ? result_.size.x()
                              : std::sqrt(result_.size.x() * result_.size.y());
      result_.size.x() = result_.size.y() = std::round(side * 1000) / 1000;
    }
  }

  const Description& description_;
  const ShapeKind& kind_;
  const std::vector<shape::Parameter>& parameters_;
  const Words& words_;
  Random random_;
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
