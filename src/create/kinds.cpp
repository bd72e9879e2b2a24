#include "kinds.h"

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr std::size_t most_name_words = 4;
constexpr int most_nested_recipes = 8;
constexpr double least_likeness = 0.15;  // below it nothing is shared that says what a thing is
constexpr double last_word_weight = 3.0;  // "reading lamp" is a lamp before it is about reading

shape::Value read_value(const JsonReader& json) {
  if (json.is_string()) return json.text();
  return json.number(-1e6, 1e6);
}

shape::Values read_values(const JsonReader& json) {
  shape::Values values;
  if (json.exists())
    for (const auto& [name, value] : json.members()) values[name] = read_value(value);
  return values;
}

Vec3 read_size(const JsonReader& json) {
  const auto sides = json.numbers(3, 0.001, 20.0);
  return sides.size() == 3 ? Vec3(sides[0], sides[1], sides[2]) : Vec3::Ones();
}

// "grow": {"doors": [3, 0.4, 0, 0]}: the usual number, then metres for each one more.
std::map<std::string, ShapeKind::Growth> read_growth(const JsonReader& json) {
  std::map<std::string, ShapeKind::Growth> growth;
  if (!json.exists()) return growth;
  for (const auto& [name, entry] : json.members())
    if (const auto numbers = entry.numbers(4, 0, 100); numbers.size() == 4)
      growth[name] = {numbers[0], {numbers[1], numbers[2], numbers[3]}};
  return growth;
}

ShapeKind read_kind(const Kind& known, const JsonReader& json) {
  json.allow_only({"recipe", "set", "vary", "styles", "size", "least", "most", "grow", "mount", "main"});
  ShapeKind kind;
  kind.name = known.name;
  kind.recipe = json["recipe"].text();
  kind.set = read_values(json["set"]);
  if (json["vary"].exists())
    for (const auto& [parameter, choices] : json["vary"].members())
      for (const auto& choice : choices.elements())
        kind.vary[parameter].push_back(read_value(choice));
  if (json["styles"].exists())
    for (const auto& [style, values] : json["styles"].members())
      kind.styles[style] = read_values(values);
  kind.size = json["size"].exists() ? read_size(json["size"]) : known.size;
  kind.least = json["least"].exists() ? read_size(json["least"]) : Vec3(0.6 * kind.size);
  kind.most = json["most"].exists() ? read_size(json["most"]) : Vec3(1.6 * kind.size);
  kind.growth = read_growth(json["grow"]);
  const auto mount = parse_mount(json["mount"].text_or(std::string(roomgen::name(known.mount))));
  if (!mount) json["mount"].report("is none of floor, wall, ceiling, surface");
  kind.mount = mount.value_or(Mount::floor);
  kind.main = json["main"].text_or("");
  return kind;
}

void collect_labels(const Json& components, std::set<std::string>& labels,
                    std::vector<std::string>& used) {
  for (const auto& component : components) {
    if (!component.is_object()) continue;
    if (const auto label = component.find("label"); label != component.end() && label->is_string())
      labels.insert(label->get<std::string>());
    if (const auto use = component.find("use"); use != component.end() && use->is_string())
      used.push_back(use->get<std::string>());
    if (const auto group = component.find("group"); group != component.end())
      if (const auto inner = group->find("components"); inner != group->end())
        collect_labels(*inner, labels, used);
  }
}

// How much of the wanted words a name has, in [0, 1].
double likeness(const std::vector<std::string>& wanted, const std::vector<std::string>& name) {
  double shared = 0.0, all = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double weight = i + 1 == wanted.size() ? last_word_weight : 1.0;
    all += weight;
    const auto found = std::find(name.begin(), name.end(), wanted[i]);
    if (found == name.end()) continue;
    // The same thing in both: "lamp" of "floor lamp", not "table" of "table lamp".
    const bool both_last = i + 1 == wanted.size() && found + 1 == name.end();
    shared += both_last || i + 1 < wanted.size() ? weight : 0.3 * weight;
  }
  if (all == 0.0) return 0.0;
  const double extra = static_cast<double>(name.size());
  return shared / all - 0.02 * extra;
}

double likeness(const std::vector<std::string>& wanted, const ShapeKind& kind) {
  double best = likeness(wanted, words(kind.name));
  const auto try_singular = [&](const std::string& name) {
    auto pieces = words(name);
    if (!pieces.empty()) pieces.back() = singular(pieces.back());
    best = std::max(best, likeness(wanted, pieces));
  };
  try_singular(kind.name);
  for (const auto& name : kind.names) try_singular(name);
  return best;
}

}  // namespace

// Parses what is asked for: a process that makes one object needs few of them.
class ShapeKinds::Recipes {
 public:
  explicit Recipes(const std::map<std::string, std::string_view>& texts) {
    for (const auto& [name, text] : texts) recipes_[name].text = text;
  }
  bool has(std::string_view name) const { return recipes_.find(name) != recipes_.end(); }
  const Json* find(std::string_view name) {
    const auto found = recipes_.find(name);
    if (found == recipes_.end()) return nullptr;
    Recipe& recipe = found->second;
    std::call_once(recipe.once, [&] {
      if (auto json = parse_json(recipe.text, std::string(name))) recipe.json = *std::move(json);
    });
    return recipe.json ? &*recipe.json : nullptr;
  }

 private:
  struct Recipe {
    std::string_view text;
    std::once_flag once;
    std::optional<Json> json;
  };
  std::map<std::string, Recipe, std::less<>> recipes_;
};

Result<ShapeKinds> ShapeKinds::read(const KindTable& table,
                                    const std::vector<std::pair<std::string, Json>>& kind_files,
                                    const std::map<std::string, std::string_view>& recipes) {
  ShapeKinds result;
  result.table_ = &table;
  result.recipes_ = std::make_shared<Recipes>(recipes);
  for (const auto& [source, json] : kind_files) {
    JsonReader::Problems problems{source};
    JsonReader root(json, problems);
    root.allow_only({"format", "version", "about", "kinds"});
    for (const auto& [name, entry] : root["kinds"].members()) {
      const auto known = table.all().find(name);
      if (known == table.all().end()) {
        entry.report("\"" + name + "\" is no kind");
        continue;
      }
      ShapeKind kind = read_kind(known->second, entry);
      if (!result.recipes_->has(kind.recipe))
        entry["recipe"].report("there is no recipe " + kind.recipe);
      result.kinds_.emplace(name, std::move(kind));
    }
    if (const auto& problem = problems.first()) return *problem;
  }
  for (const auto& [name, kind] : table.all()) {
    const auto made = result.kinds_.find(kind.built_as);
    if (made == result.kinds_.end()) continue;
    auto& names = made->second.names;
    if (name != made->first) names.push_back(name);
    names.insert(names.end(), kind.names.begin(), kind.names.end());
  }
  return result;
}

const Result<ShapeKinds>& ShapeKinds::built_in() {
  static const Result<ShapeKinds> kinds = []() -> Result<ShapeKinds> {
    std::vector<std::pair<std::string, Json>> files;
    std::map<std::string, std::string_view> recipes;
    constexpr std::string_view folder = "data/shapes/", kinds_folder = "data/shapes/kinds/";
    for (const auto path : resources(folder)) {
      if (path.starts_with(kinds_folder)) {
        auto json = parse_json(*resource(path), std::string(path));
        if (!json) return json.error();
        files.emplace_back(path, *std::move(json));
      } else {
        auto name = path.substr(folder.size());
        name.remove_suffix(std::string_view(".json").size());
        recipes.emplace(name, *resource(path));
      }
    }
    return read(KindTable::built_in(), files, recipes);
  }();
  return kinds;
}

const ShapeKind* ShapeKinds::find(std::string_view name) const {
  const Kind* kind = table_->called(name);
  const auto found = kind ? kinds_.find(kind->built_as) : kinds_.end();
  return found == kinds_.end() ? nullptr : &found->second;
}

std::size_t ShapeKinds::match(const std::vector<std::string>& text, std::size_t from,
                              const ShapeKind** kind) const {
  std::size_t most = 0;  // no name goes over a comma
  while (most < most_name_words && from + most < text.size() && !words(text[from + most]).empty()) ++most;
  for (std::size_t n = most; n > 0; --n) {
    const std::vector<std::string> pieces(text.begin() + static_cast<std::ptrdiff_t>(from),
                                          text.begin() + static_cast<std::ptrdiff_t>(from + n));
    if (const ShapeKind* found = find(join(pieces, " "))) {
      if (kind) *kind = found;
      return n;
    }
  }
  return 0;
}

std::vector<const ShapeKind*> ShapeKinds::nearest(std::string_view text, std::size_t count) const {
  auto wanted = words(text);
  for (auto& word : wanted) word = singular(word);
  std::vector<std::pair<double, const ShapeKind*>> order;
  for (const auto& [name, kind] : kinds_)
    if (const double score = likeness(wanted, kind); score > least_likeness) order.emplace_back(score, &kind);
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second->name < b.second->name;
  });
  std::vector<const ShapeKind*> result;
  for (const auto& [score, kind] : order)
    if (result.size() < count) result.push_back(kind);
  return result;
}

const ShapeKind* ShapeKinds::nearest(std::string_view text) const {
  const auto found = nearest(text, 1);
  return found.empty() ? nullptr : found.front();
}

const Json* ShapeKinds::recipe(std::string_view name) const {
  return recipes_->find(name);
}

shape::RecipeSource ShapeKinds::recipes() const {
  return [this](const std::string& name) -> Result<Json> {
    if (const Json* found = recipe(name)) return *found;
    return Error{Error::Kind::not_found, "there is no recipe " + name};
  };
}

std::set<std::string> ShapeKinds::labels(std::string_view name) const {
  std::set<std::string> labels;
  std::vector<std::string> open = {std::string(name)};
  std::set<std::string> seen;
  for (int depth = 0; depth < most_nested_recipes && !open.empty(); ++depth) {
    std::vector<std::string> used;
    for (const auto& one : open) {
      const Json* json = seen.insert(one).second ? recipe(one) : nullptr;
      if (!json) continue;
      if (const auto components = json->find("components"); components != json->end())
        collect_labels(*components, labels, used);
    }
    open = std::move(used);
  }
  return labels;
}

}  // namespace roomgen::create
