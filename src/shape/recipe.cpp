#include "roomgen/shape/program.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/random.h"
#include "component_reader.h"
#include "document.h"
#include "parameters.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::shape {

namespace {

using namespace detail;

using Connections = std::vector<std::pair<std::string, std::string>>;

// Where and how a document is built: its own part of the program.
struct Site {
  std::vector<std::string> chain;  ///< recipes in use, outermost first
  std::string prefix;              ///< of names of materials and connections: "ring."
  std::uint64_t seed = 0;
  /// How the user wants the materials called, by the document's names; "" for all others, if at
  /// all.
  std::map<std::string, std::string> materials;
};

struct Built {
  std::string name, about;
  std::vector<Component> components;
  Connections connections;
};

std::uint64_t seed_of(std::uint64_t seed, const std::string& name) {
  Random random = Random(seed).fork(name);
  const std::uint64_t high = random.next() & 0x1fffff;
  return (high << 32) | random.next();
}

bool same_surface(const Surface& a, const Surface& b) {
  return a.color == b.color && a.roughness == b.roughness && a.metalness == b.metalness &&
         a.opacity == b.opacity && a.pattern == b.pattern && a.second == b.second &&
         a.scale == b.scale && a.glow == b.glow;
}

class Builder {
 public:
  explicit Builder(const RecipeSource& lookup) : lookup_(lookup) {}

  Built build(const Json& json, const Values& values, const Site& site,
              JsonReader::Problems& problems) {
    Built built;
    const JsonReader root(json, problems);
    check_head(root, Numbers(nullptr, reading_, problems));
    if (problems.first()) return built;
    root.allow_only({"format", "version", "name", "about", "parameters", "let", "materials",
                     "components", "connections"});
    built.name = root["name"].text_or("", 200);
    built.about = root["about"].text_or("", 2000);
    const auto parameters = read_parameters(root["parameters"]);
    check_values(root, parameters, values);
    if (problems.first()) return built;

    Scope scope = make_scope(parameters, values, site.seed);
    const Numbers numbers(&scope, reading_, problems);
    add_lets(root["let"], numbers);
    const auto own = read_surfaces(root["materials"], numbers);
    if (problems.first()) return built;
    Connections inner;
    const auto use = [&](const JsonReader& component, const Numbers& outer) {
      return used(component, outer, site, inner);
    };
    ComponentReader reader(numbers, add_materials(root, own, site), use);
    reader_ = &reader;
    built.components = reader.read(root["components"]);
    if (problems.first()) return built;
    built.connections = read_connections(root, built.components, numbers);
    for (auto& [first, second] : inner) built.connections.emplace_back(first, second);
    return built;
  }

  std::vector<Surface> surfaces;

 private:
  static void check_values(const JsonReader& root, const std::vector<Parameter>& parameters,
                           const Values& values) {
    std::vector<std::string> names;
    for (const auto& parameter : parameters) {
      names.push_back(parameter.name);
      const auto given = values.find(parameter.name);
      if (given == values.end()) continue;
      if (const auto wrong = objection(parameter, given->second); !wrong.empty())
        root.report("parameter \"" + parameter.name + "\": " + wrong);
    }
    for (const auto& [name, ignored] : values) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      const std::string close = closest_name(name, names);
      return root.report("no parameter \"" + name + "\"" +
                  (!close.empty()  ? "; did you mean \"" + close + "\"?"
                   : names.empty() ? "; there are none"
                                   : "; there are " + join(names, ", ")));
    }
  }

  // The program's names of the document's materials, added where they are not the user's.
  std::map<std::string, std::string> add_materials(const JsonReader& root,
                                                   const std::vector<Surface>& own,
                                                   const Site& site) {
    for (const auto& [name, ignored] : site.materials)
      if (!name.empty() &&
          std::none_of(own.begin(), own.end(),
                       [&wanted = name](const Surface& s) { return s.name == wanted; }))
        root.report("no material \"" + name + "\" to be replaced");
    std::map<std::string, std::string> names;
    for (const auto& surface : own) {
      auto wanted = site.materials.find(surface.name);
      if (wanted == site.materials.end()) wanted = site.materials.find("");
      names[surface.name] = wanted != site.materials.end() ? wanted->second : added(surface, site);
    }
    return names;
  }

  std::string added(Surface surface, const Site& site) {
    const std::string name = site.prefix + surface.name;
    for (int k = 1;; ++k) {
      surface.name = k == 1 ? name : name + "-" + std::to_string(k);
      const auto known = std::find_if(surfaces.begin(), surfaces.end(),
                                      [&](const Surface& s) { return s.name == surface.name; });
      if (known == surfaces.end()) break;
      if (same_surface(*known, surface)) return surface.name;
    }
    surfaces.push_back(surface);
    return surface.name;
  }

  Group used(const JsonReader& component, const Numbers& numbers, const Site& site,
             Connections& connections) {
    const auto use = component["use"];
    const std::string name = use.text(64);
    const Json* recipe = find(use, name, site);
    if (!recipe) return {};
    JsonReader::Problems problems("recipe \"" + name + "\"");
    const auto parameters = read_parameters(JsonReader(*recipe, problems)["parameters"]);
    if (problems.first()) {
      use.report(problems.first()->message);
      return {};
    }
    const Values values = arguments(component["with"], parameters, numbers);
    if (numbers.failed()) return {};

    const std::string part = component["name"].text(64);
    Site inside{site.chain, site.prefix + part + ".", seed_of(site.seed, part), {}};
    inside.chain.push_back(name);
    ComponentReader* const outer = reader_;
    inside.materials = replacements(component, *outer);
    if (numbers.failed()) return {};
    Built built = build(*recipe, values, inside, problems);
    reader_ = outer;
    if (problems.first()) {
      use.report(problems.first()->message);
      return {};
    }
    for (const auto& [first, second] : built.connections) {
      const bool of_room = second == "floor" || second == "wall";
      std::pair<std::string, std::string> inner(part + "." + first,
                                                of_room ? second : part + "." + second);
      if (std::find(connections.begin(), connections.end(), inner) == connections.end())
        connections.push_back(std::move(inner));
    }
    return {std::move(built.components)};
  }

  const Json* find(const JsonReader& use, const std::string& name, const Site& site) {
    const auto fail = [&](const std::string& what) {
      use.report(what);
      return nullptr;
    };
    if (std::find(site.chain.begin(), site.chain.end(), name) != site.chain.end())
      return fail("recipes use each other in a circle: " + join(site.chain, " > ") + " > " + name);
    if (site.chain.size() >= static_cast<std::size_t>(max_use_depth))
      return fail("recipes use each other more than " + std::to_string(max_use_depth) +
                  " deep: " + join(site.chain, " > ") + " > " + name);
    if (const auto known = recipes_.find(name); known != recipes_.end()) return &known->second;
    if (!lookup_) return fail("there are no other recipes to use here");
    auto found = lookup_(name);
    if (!found) return fail(found.error().message);
    if (!found->is_object())
      return fail("recipe \"" + name + "\": expected a shape program, an object");
    return &recipes_.emplace(name, *std::move(found)).first->second;
  }

  // The values in `with`; words that the used recipe knows may be said without quotes.
  static Values arguments(const JsonReader& with, const std::vector<Parameter>& parameters,
                          const Numbers& numbers) {
    Values values;
    for (const auto& [name, json] : with.members()) {
      const auto parameter =
          std::find_if(parameters.begin(), parameters.end(),
                       [&, &wanted = name](const Parameter& p) { return p.name == wanted; });
      if (parameter == parameters.end()) {
        std::vector<std::string> names;
        for (const auto& p : parameters) names.push_back(p.name);
        json.report("the recipe has no parameter \"" + name + "\"; it has " +
                    (names.empty() ? "none" : join(names, ", ")));
        return values;
      }
      Value value = argument(json, *parameter, numbers);
      if (const auto wrong = objection(*parameter, value); !wrong.empty() && !numbers.failed())
        json.report(wrong);
      values[name] = std::move(value);
    }
    return values;
  }

  static Value argument(const JsonReader& json, const Parameter& parameter,
                        const Numbers& numbers) {
    if (!wants_word(parameter)) {
      Value value = numbers.value(json);
      if (auto* number = std::get_if<double>(&value)) *number = roomgen::rounded(*number, 6);
      return value;
    }
    const std::string text = json.text(Expression::max_length);
    const bool plain = text.empty() || text[0] == '$' || objection(parameter, text).empty();
    return plain ? Value(numbers.word(json, "")) : numbers.value(json);
  }

  static std::map<std::string, std::string> replacements(const JsonReader& component,
                                                         const ComponentReader& reader) {
    std::map<std::string, std::string> names;
    for (const auto& [name, wanted] : component["materials"].members())
      names[name] = reader.material(wanted);
    if (component["material"].exists()) names[""] = reader.material(component["material"]);
    return names;
  }

  const RecipeSource& lookup_;
  Reading reading_;
  std::map<std::string, Json> recipes_;
  ComponentReader* reader_ = nullptr;  ///< of the document that is being built
};

}  // namespace

Result<Json> parse_recipe(std::string_view text, const std::string& source) {
  if (text.size() > max_program_bytes)
    return Error{Error::Kind::limit, source + ": a shape program of more than 1 MB"};
  return parse_json(text, source);
}

Result<Json> read_recipe(const std::filesystem::path& path) {
  const auto text = read_file(path, max_program_bytes);
  if (!text) return text.error();
  return parse_recipe(*text, path.string());
}

RecipeSource recipes_in(const std::filesystem::path& folder) {
  return [folder](const std::string& name) -> Result<Json> {
    const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '-' || c == '_';
    });
    if (!plain)
      return Error{Error::Kind::invalid_input,
                   "\"" + name + "\" is no name of a recipe; it has letters, digits, - and _ only"};
    return read_recipe(folder / (name + ".json"));
  };
}

Result<Program> instantiate(const Json& recipe, const Values& parameters, std::uint64_t seed,
                            const RecipeSource& lookup, const std::string& source) {
  JsonReader::Problems problems(source);
  Builder builder(lookup);
  Site site;
  site.seed = seed;
  Built built = builder.build(recipe, parameters, site, problems);
  if (problems.first()) return *problems.first();
  return Program{std::move(built.name), std::move(built.about), std::move(builder.surfaces),
                 std::move(built.components), std::move(built.connections)};
}

}  // namespace roomgen::shape
