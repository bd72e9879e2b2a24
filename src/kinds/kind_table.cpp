#include "roomgen/kinds/kind_table.h"

#include <algorithm>

#include "roomgen/base/json.h"
#include "roomgen/base/resource.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// What hangs on a wall hangs with its middle at the height of the eyes, if nothing else is known.
constexpr double eye_height = 1.5;
constexpr double least_elevation = 0.1;

std::string normalised(std::string_view name) {
  return join(words(name), " ");
}

std::string in_singular(std::string_view name) {
  auto pieces = words(name);
  if (!pieces.empty()) pieces.back() = singular(pieces.back());
  return join(pieces, " ");
}

Side read_side(const JsonReader& json) {
  const std::string text = json.text();
  if (text == "back") return Side::back;
  if (text == "left") return Side::left;
  if (text == "right") return Side::right;
  if (text != "front") json.report("\"" + text + "\" is none of front, back, left, right");
  return Side::front;
}

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(500)) texts.push_back(element.text());
  return texts;
}

void read_traits(const JsonReader& json, Traits& traits) {
  if (!json.exists()) return;
  traits = {false, false, false};
  for (const auto& element : json.elements(10)) {
    const std::string text = element.text();
    if (text == "front") traits.front = true;
    else if (text == "flat") traits.flat = true;
    else if (text == "round") traits.round = true;
    else element.report("\"" + text + "\" is none of front, flat, round");
  }
}

// What the entry does not say stays as `category` has it: inherited.
void read_category(const JsonReader& json, Kind& category) {
  json.allow_only({"is", "synonyms", "size", "mount", "elevation", "traits", "zones", "gaps",
                   "tucks_under", "covers_window", "lamp", "source"});
  category.synonyms = read_texts(json["synonyms"]);
  if (const auto size = json["size"]; size.exists()) {
    const auto v = size.numbers(3, 0.001, 20.0);
    category.size = {v[0], v[1], v[2]};
  }
  if (const auto mount = json["mount"]; mount.exists()) {
    if (auto parsed = parse_mount(mount.text())) category.mount = *parsed;
    else mount.report("is none of floor, wall, ceiling, surface");
  }
  category.elevation = json["elevation"].number_or(category.elevation, 0, 20);
  category.covers_window = json["covers_window"].boolean_or(category.covers_window);
  read_traits(json["traits"], category.traits);
  if (const auto zones = json["zones"]; zones.exists()) {
    category.zones.clear();
    for (const auto& element : zones.elements(8)) {
      element.allow_only({"side", "depth", "partners"});
      category.zones.push_back({read_side(element["side"]), element["depth"].number(0.01, 5.0),
                                read_texts(element["partners"])});
    }
  }
  if (const auto gaps = json["gaps"]; gaps.exists()) {
    category.gaps.clear();
    for (const auto& [partner, range] : gaps.members()) {
      const auto v = range.numbers(2, 0.0, 20.0);
      category.gaps.push_back({partner, v[0], v[1]});
    }
  }
  if (json["tucks_under"].exists()) category.tucks_under = read_texts(json["tucks_under"]);
  if (const auto lamp = json["lamp"]; lamp.exists()) {
    lamp.allow_only({"candela", "height", "cone"});
    category.lamp = Lamp{lamp["candela"].number(0.01, 10000.0), lamp["height"].number_or(0.8, 0.0, 1.0),
                         lamp["cone"].number_or(0.0, 0.0, 90.0)};
  }
}

}  // namespace

bool is_of(const Kind& category, std::string_view kind) {
  return std::find(category.lineage.begin(), category.lineage.end(), kind) != category.lineage.end();
}

bool is_any_of(const Kind& category, const std::vector<std::string>& kinds) {
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const std::string& kind) { return is_of(category, kind); });
}

Result<KindTable> KindTable::parse(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  KindTable table;
  const auto members = root["categories"].members();

  // Parents first, so that children can copy them.
  std::size_t known = 0;
  do {
    known = table.categories_.size();
    for (const auto& [name, entry] : members) {
      if (table.categories_.count(name)) continue;
      const std::string parent = entry["is"].text_or("");
      if (!parent.empty() && !table.categories_.count(parent)) continue;
      Kind category = parent.empty() ? Kind{} : table.categories_.at(parent);
      category.name = name;
      category.parent = parent;
      category.lineage.push_back(name);
      read_category(entry, category);
      table.categories_[name] = category;
    }
  } while (table.categories_.size() > known);
  for (const auto& [name, entry] : members)
    if (!table.categories_.count(name))
      entry["is"].report("\"" + entry["is"].text_or("") + "\" is no category, or leads in a circle");
  if (problems.first()) return *problems.first();

  for (const auto& [name, category] : table.categories_) table.names_[normalised(name)] = name;
  for (const auto& [name, category] : table.categories_)
    for (const auto& synonym : category.synonyms)
      table.names_.try_emplace(normalised(synonym), name);
  table.resolve_references(root["categories"]);
  if (problems.first()) return *problems.first();
  return table;
}

bool KindTable::is_any_of(std::string_view name, const std::vector<std::string>& kinds) const {
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const std::string& kind) { return is_a(name, kind); });
}

void KindTable::resolve_references(const JsonReader& json) {
  for (auto& [name, category] : categories_) {
    const auto resolve = [&, &key = name](std::string& reference) {
      if (const Kind* found = find(reference)) reference = found->name;
      else json[key].report("\"" + reference + "\" is no category");
    };
    for (auto& zone : category.zones)
      for (auto& partner : zone.partners) resolve(partner);
    for (auto& gap : category.gaps) resolve(gap.partner);
    for (auto& kind : category.tucks_under) resolve(kind);
  }
}

bool KindTable::add_category(const KindRecord& record) {
  const auto parent = names_.find(normalised(record.parent));
  if (!record.size || (!record.parent.empty() && parent == names_.end())) return false;
  Kind category;
  if (parent != names_.end()) category = categories_.find(parent->second)->second;
  category.name = record.name;
  category.parent = parent == names_.end() ? "" : parent->second;
  category.lineage.insert(category.lineage.begin(), record.name);
  category.synonyms.clear();
  category.size = *record.size;
  const Mount mount = record.mount.value_or(category.mount);
  if (mount == Mount::wall && category.elevation <= 0.0)
    category.elevation = std::max(least_elevation, eye_height - 0.5 * category.size.z());
  // What stands on a table needs no floor before it, whatever its bigger kin need.
  if (mount != category.mount && mount != Mount::floor) {
    category.zones.clear();
    category.gaps.clear();
    category.tucks_under.clear();
  }
  category.mount = mount;
  names_[normalised(record.name)] = record.name;
  categories_[record.name] = std::move(category);
  return true;
}

void KindTable::add_name(const std::string& name, const std::string& category) {
  const std::string key = normalised(name);
  if (key.empty()) return;
  const auto one = names_.find(in_singular(name));
  if (one != names_.end() && one->second != category && one->first != key) return;
  const auto [taken, free] = names_.try_emplace(key, category);
  if (!free) {
    Kind& other = categories_.find(taken->second)->second;
    const bool special = is_of(categories_.find(category)->second, other.name);
    if (other.name == category || !special || normalised(other.name) == key) return;
    std::erase_if(other.synonyms, [&](const std::string& s) { return normalised(s) == key; });
    taken->second = category;
  }
  categories_.find(category)->second.synonyms.push_back(name);
}

void KindTable::add(const std::vector<KindRecord>& records) {
  std::vector<const KindRecord*> left;
  for (const auto& record : records)
    if (!names_.count(normalised(record.name))) left.push_back(&record);
  // Parents first, as in a file of categories.
  for (std::size_t before = left.size() + 1; left.size() < before;) {
    before = left.size();
    std::erase_if(left, [&](const KindRecord* record) { return add_category(*record); });
  }
  for (const auto& record : records) {
    auto own = names_.find(normalised(record.name));
    for (std::size_t i = 0; own == names_.end() && i < record.names.size(); ++i)
      own = names_.find(normalised(record.names[i]));
    if (own == names_.end()) continue;
    const std::string category = own->second;
    add_name(record.name, category);
    for (const auto& name : record.names) add_name(name, category);
  }
}

const KindTable& KindTable::built_in() {
  static const KindTable table = [] {
    auto parsed = parse(resource("data/categories.json").value_or("{}"), "data/categories.json");
    // A test parses the files; a build whose data is broken has an empty table.
    if (!parsed) return KindTable{};
    if (const auto shapes = shape_kind_records()) parsed->add(*shapes);
    const auto named = read_kind_records(resource("data/vocabulary.json").value_or("{}"),
                                         "data/vocabulary.json");
    if (named) parsed->add(*named);
    return *std::move(parsed);
  }();
  return table;
}

const Kind* KindTable::find(std::string_view name) const {
  auto pieces = words(name);
  if (pieces.size() > 20) return nullptr;
  // The whole name, then without its first word, and so on: English puts the kind last.
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    const std::vector<std::string> ending(pieces.begin() + static_cast<std::ptrdiff_t>(first),
                                          pieces.end());
    auto in_singular = ending;
    in_singular.back() = singular(in_singular.back());
    for (const auto& spelling : {join(ending, " "), join(in_singular, " ")})
      if (const auto found = names_.find(spelling); found != names_.end())
        return &categories_.find(found->second)->second;
  }
  return nullptr;
}

const Kind& KindTable::get(std::string_view name) const {
  static const Kind unknown;
  const Kind* found = find(name);
  return found ? *found : unknown;
}

bool KindTable::is_a(std::string_view name, std::string_view kind) const {
  const Kind* wanted = find(kind);
  if (!wanted) return normalised(name) == normalised(kind);
  return is_of(get(name), wanted->name);
}

}  // namespace roomgen
