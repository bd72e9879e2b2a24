#include "roomgen/create/maker.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "library/looks.h"
#include "part_forms.h"
#include "parts.h"
#include "reshape.h"
#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/shape/evaluate.h"
#include "rule_steps.h"
#include "settings.h"
#include "shape/motifs.h"

namespace roomgen::create {

namespace {

const Vec3 usual_size(0.5, 0.5, 0.8);
constexpr double over_corners = 1.4;  // a circle around a square is so much wider

// Surfaces that the recipe paints with this colour parameter.
std::vector<std::string> surfaces_of(const Json& recipe, const std::string& parameter) {
  std::vector<std::string> names;
  const auto materials = recipe.find("materials");
  if (parameter.empty() || materials == recipe.end() || !materials->is_object()) return names;
  for (const auto& [name, surface] : materials->items()) {
    const auto color = surface.find("color");
    if (color != surface.end() && *color == "$" + parameter) names.push_back(name);
  }
  return names;
}

class RuleMaker final : public Maker {
 public:
  Result<Verdict> classify(const std::string& prompt) override {
    if (prompt.size() > longest_phrase) return classify_phrase(prompt, {}, Words());
    const auto objects = decompose(prompt);
    if (!objects) return objects.error();
    return classify_phrase(prompt, *objects, *built_in_words());
  }

  Result<std::vector<Description>> decompose(const std::string& prompt) override {
    if (!built_in_words()) return built_in_words().error();
    if (!built_in_parts()) return built_in_parts().error();
    if (!ShapeKinds::built_in()) return ShapeKinds::built_in().error();
    auto objects = read_phrase(prompt.substr(0, longest_phrase), *built_in_words(), *ShapeKinds::built_in());
    for (auto& object : objects)
      if (const ShapeKind* closer = closer_kind(object, *ShapeKinds::built_in())) object.kind = closer->name;
    return objects;
  }

  bool wants_examples() const override { return false; }

  Result<shape::Program> generate(const MakeRequest& request) override {
    if (!built_in_words()) return built_in_words().error();
    if (!ShapeKinds::built_in()) return ShapeKinds::built_in().error();
    if (request.earlier) {
      auto refined = refine(*request.earlier, request.description.prompt, *built_in_words());
      notes_.insert(notes_.end(), refined.notes.begin(), refined.notes.end());
      return std::move(refined.program);
    }
    const ShapeKind* kind = ShapeKinds::built_in()->find(request.description.kind);
    if (!kind) return from_parts(request.description);
    return from_recipe(request, *kind);
  }

  std::vector<std::string> take_notes() override { return std::exchange(notes_, {}); }

 private:
  Result<shape::Program> from_parts(const Description& description) {
    Vec3 size = usual_size.cwiseProduct(description.scale);
    if (description.size)
      for (int axis = 0; axis < 3; ++axis)
        if (!std::isnan((*description.size)[axis])) size[axis] = (*description.size)[axis];
    notes_.push_back("\"" + description.noun + "\" is no known kind: it was put together from its parts");
    shape::Program program = compose(description, size);
    if (!description.material.empty() || !description.color.empty())
      paint_surfaces(program, {program.materials.front().name}, description.material, description.color, *built_in_words());
    finish(program, description,
           std::vector<Settings::Unmet>(description.parts.size(), nothing_met()));
    return program;
  }

  // What its words say that the cloth shows.
  static void print_cloth(const Description& description, const ShapeKind& kind,
                          const std::vector<std::string>& cloths, shape::Program& program) {
    const auto prints = shape::motifs_on_cloth(description.prompt);
    if (prints.empty() || count_parts(program, "print") > 0 ||
        !KindTable::built_in().is_any_of(kind.name, printed_cloths))
      return;
    for (auto& surface : program.materials)
      if (std::find(cloths.begin(), cloths.end(), surface.name) != cloths.end())
        surface.pattern = prints.front();
  }

  Result<shape::Program> from_recipe(const MakeRequest& request, const ShapeKind& kind) {
    const ShapeKinds& kinds = *ShapeKinds::built_in();
    const Words& words = *built_in_words();
    const Description& description = request.description;
    const Json* found = kinds.recipe(kind.recipe);
    if (!found) return Error{Error::Kind::not_found, "there is no recipe " + kind.recipe};
    const Json& recipe = *found;
    const auto parameters = shape::describe_parameters(recipe, kind.recipe);
    if (!parameters) return parameters.error();
    Settings settings = choose_settings(description, kind, *parameters, words, request.seed);
    notes_.insert(notes_.end(), settings.notes.begin(), settings.notes.end());
    const auto make = [&] {
      return shape::instantiate(recipe, settings.values, request.seed, kinds.recipes(),
                                kind.recipe);
    };
    auto program = make();
    // At the ends of their ranges parameters may not go together: then the usual ones, which do.
    if (!program || !shape::evaluate(*program, shape::for_measuring)) {
      notes_.push_back("a " + kind.name + " of these proportions cannot be made: it has the usual ones");
      settings.values = usual_values(kind, *parameters);
      program = make();
    }
    if (!program) return program;
    if (needs_wide_top(description, settings, *program)) {
      for (const char* side : {"width", "depth"}) std::get<double>(settings.values[side]) /= over_corners;
      program = make();
      if (!program) return program;
    }
    for (const auto& part : description.parts)
      if (auto better = with_count(part, kind, description, *parameters, *program, settings.values, make))
        program = *std::move(better);
    for (std::size_t i = 0; i < description.parts.size(); ++i)
      fit_height(description.parts[i].label, settings.unmet[i].size.z(), *parameters, *program, settings.values, make);
    print_cloth(description, kind, surfaces_of(recipe, kind.main), *program);
    program->name = description.noun;
    program->about = description.prompt;
    program->ways = ways_of(*parameters, settings.values);
    if (description.approximate)
      notes_.push_back("\"" + description.noun + "\" is no known kind: made like a " + kind.name);
    if (!description.material.empty())
      paint_surfaces(*program, surfaces_of(recipe, kind.main), description.material,
                     description.color, words);
    finish(*program, description, settings.unmet);
    return program;
  }

  static std::map<std::string, std::string> ways_of(const std::vector<shape::Parameter>& parameters,
                                                    const shape::Values& values) {
    std::map<std::string, std::string> ways;
    for (const auto& parameter : parameters) {
      const auto set = values.find(parameter.name);
      const auto& value = set == values.end() ? parameter.value : set->second;
      const auto* word = std::get_if<std::string>(&value);
      if (word && !parameter.choices.empty()) ways[parameter.name] = *word;
    }
    return ways;
  }

  // Who says something of the legs means that there are some: no trestle, unless it was asked for.
  static int usual_count(const PartWish& part, const std::vector<shape::Parameter>& parameters,
                         const shape::Values& values) {
    for (const auto& parameter : parameters) {
      if (parameter.name != part.label + "s") continue;
      const auto set = values.find(parameter.name);
      const auto& value = set == values.end() ? parameter.value : set->second;
      if (const double* number = std::get_if<double>(&value)) return static_cast<int>(*number);
    }
    return 0;
  }

  // A way of building the part that allows the number that was asked for, when the seed or the style
  // chose one that does not: six legs are no trestle.
  template <typename Make>
  static std::optional<shape::Program> with_count(const PartWish& part, const ShapeKind& kind,
                                                  const Description& description,
                                                  const std::vector<shape::Parameter>& parameters,
                                                  const shape::Program& program,
                                                  shape::Values& values, Make make) {
    if (part.label.empty()) return std::nullopt;
    const int wanted = part.count.value_or(usual_count(part, parameters, values));
    if (wanted == 0 || count_parts(program, part.label) == wanted) return std::nullopt;
    const auto attempt = [&](const std::string& name, const shape::Value& choice) -> std::optional<shape::Program> {
      const shape::Values before = values;
      values[name] = choice;
      auto other = make();
      if (other && count_parts(*other, part.label) == wanted) return *std::move(other);
      values = before;
      return std::nullopt;
    };
    for (const auto& parameter : parameters)
      if (parameter.name == part.label + "_style" && part.construction.empty())
        for (const auto& choice : parameter.choices)
          if (auto other = attempt(parameter.name, choice)) return other;
    for (const auto& [name, choices] : kind.vary)
      if (!is_said(name, description))
        for (const auto& choice : choices)
          if (auto other = attempt(name, choice)) return other;
    return std::nullopt;
  }

  // Does the description speak of what the parameter is about: "drawers", "leg_style"?
  static bool is_said(const std::string& parameter, const Description& description) {
    return std::any_of(description.parts.begin(), description.parts.end(), [&](const PartWish& part) {
      return !part.label.empty() && parameter.starts_with(part.label.substr(0, part.label.size() - 1));
    });
  }

  // A part that grows with the whole gets its height from it: a throne whose back is two metres tall.
  template <typename Make>
  static void fit_height(const std::string& label, double wanted, const std::vector<shape::Parameter>& parameters,
                         shape::Program& program, shape::Values& values, Make make) {
    const auto height = std::find_if(parameters.begin(), parameters.end(),
                                     [](const auto& parameter) { return parameter.name == "height"; });
    if (std::isnan(wanted) || height == parameters.end()) return;
    for (int round = 0; round < 3; ++round) {
      const double missing = wanted - part_size(program, label).z();
      if (std::abs(missing) < shape::for_measuring.tolerance) return;
      shape::Values changed = values;
      double& value = std::get<double>(changed["height"]);
      value = std::clamp(value + missing, height->min, height->max);
      std::swap(values, changed);
      auto other = make();
      if (!other || std::abs(wanted - part_size(*other, label).z()) > 0.8 * std::abs(missing)) {
        std::swap(values, changed);
        return;
      }
      program = *std::move(other);
    }
  }

  // What no parameter could say, part by part.
  void finish(shape::Program& program, const Description& description,
              const std::vector<Settings::Unmet>& unmet) {
    // What goes makes room for what comes.
    for (const auto& part : description.parts)
      if (!part.label.empty() && part.count == 0) remove(program, part.label);
    std::vector<PartWish> missing;
    for (std::size_t i = 0; i < description.parts.size(); ++i) {
      const PartWish& part = description.parts[i];
      if (part.label.empty() || part.count == 0) continue;
      const bool told = part.count && !unmet[i].count;  // a parameter did it, under whatever label
      if (count_parts(program, part.label) > 0 || told) fit(program, part, unmet[i]);
      else if (is_whole(part)) paint_whole(program, part);
      else missing.push_back(part);
    }
    if (stands_on_stem(missing, description)) remove(program, "leg");
    if (!missing.empty() && attach(program, missing))
      for (const auto& part : missing)
        shape_part(program, part, nothing_met());
    prune_connections(program);
  }

  // Legs take along what they bear.
  static void remove(shape::Program& program, const std::string& label) {
    set_count(program, label, 0);
    if (label == "leg") set_count(program, "stretcher", 0);
  }

  // "a stool with a thick stem": it has no legs besides, if none were asked for.
  static bool stands_on_stem(const std::vector<PartWish>& missing, const Description& description) {
    const auto is_leg = [](const PartWish& part) { return part.label == "leg"; };
    const auto is_stem = [](const PartWish& part) {
      return (part.one || part.count == 1) && !part.place &&
             built_in_parts()->of(part.label, 1).place == Place::column;
    };
    return std::none_of(description.parts.begin(), description.parts.end(), is_leg) &&
           std::any_of(missing.begin(), missing.end(), is_stem);
  }

  // A part that is there.
  void fit(shape::Program& program, const PartWish& part, const Settings::Unmet& unmet) {
    const int there = count_parts(program, part.label);
    const int wanted = part.count.value_or(there);
    if (there > 0 && there != wanted && !set_count(program, part.label, wanted))
      notes_.push_back("there are " + std::to_string(there) + " of the part \"" + part.label +
                       "\" instead of " + std::to_string(wanted));
    shape_part(program, part, unmet);
    if (part.scale != Vec3::Ones() && part.scale.x() == 1.0) scale(program, part.label, part.scale);
  }

  static void shape_part(shape::Program& program, const PartWish& part, const Settings::Unmet& unmet) {
    if (unmet.shape) set_outline(program, part.label, part.shape);
    if (is_round_top(part, unmet) && count_parts(program, "side") > 1)
      scale(program, part.label, {over_corners, over_corners, 1.0});
    if (!unmet.size.array().isNaN().all()) resize(program, part.label, unmet.size);
    if (part.lean && unmet.lean) lean(program, part.label, *part.lean);
    if (part.course && unmet.course) bend(program, part.label, *part.course, part.strength);
    if (!part.material.empty() || !part.color.empty())
      paint(program, part.label, part.material, part.color, *built_in_words());
  }

  static Settings::Unmet nothing_met() {
    Settings::Unmet unmet;
    unmet.lean = unmet.course = unmet.shape = true;
    return unmet;
  }

  static bool is_round_top(const PartWish& part, const Settings::Unmet& unmet) {
    return unmet.shape && part.label == "top" && part.shape != "square" && part.shape != "rectangular";
  }

  // A round top covers the corners of the case under it, which is the smaller for it.
  static bool needs_wide_top(const Description& description, const Settings& settings,
                             const shape::Program& program) {
    for (std::size_t i = 0; i < description.parts.size(); ++i)
      if (is_round_top(description.parts[i], settings.unmet[i])) return count_parts(program, "side") > 1;
    return false;
  }

  // Parts that are but other names for most of the thing: "with a wooden frame".
  static bool is_whole(const PartWish& part) {
    if (part.label == "body" || part.label == "frame") return true;
    return !part.count && part.shape.empty() && !part.place &&
           (part.label == "top" || part.label == "base" || part.label == "back" ||
            part.label == "seat");
  }

  static void paint_whole(shape::Program& program, const PartWish& part) {
    if (!program.materials.empty() && !(part.material.empty() && part.color.empty()))
      paint_surfaces(program, {program.materials.front().name}, part.material, part.color,
                     *built_in_words());
  }

  std::vector<std::string> notes_;
};

}  // namespace

std::unique_ptr<Maker> make_rule_maker() {
  return std::make_unique<RuleMaker>();
}

}  // namespace roomgen::create
