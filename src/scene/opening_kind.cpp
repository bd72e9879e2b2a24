#include "opening_kind.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "geometry/outline.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double widest = 20.0;  // metres
constexpr double whole_square = 0.9999;

std::string normalised(std::string_view name) {
  auto pieces = words(name);
  if (!pieces.empty()) pieces.back() = singular(pieces.back());
  return join(pieces, " ");
}

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(100)) texts.push_back(element.text(100));
  return texts;
}

std::optional<double> read_length(const JsonReader& json, const std::optional<double>& inherited) {
  return json.exists() ? std::optional(json.number(0.0, widest)) : inherited;
}

void read_type(const JsonReader& json, OpeningKind& kind) {
  if (!json.exists()) return;
  const std::string text = json.text();
  for (const auto type : {OpeningType::door, OpeningType::window, OpeningType::passage}) {
    if (name(type) != text) continue;
    kind.type = type;
    return;
  }
  json.report("\"" + text + "\" is none of door, window, passage");
}

void read_swing(const JsonReader& json, OpeningKind& kind) {
  if (!json.exists()) return;
  const std::string text = json.text();
  for (const auto swing : {DoorSwing::in, DoorSwing::out, DoorSwing::sliding})
    if (name(swing) == text) kind.swing = swing;
  if (!kind.swing || name(*kind.swing) != text)
    json.report("\"" + text + "\" is none of in, out, sliding");
}

void read_outline(const JsonReader& json, OpeningKind& kind) {
  if (!json.exists()) return;
  auto outline = outline_of_cut_out(json.text());
  if (outline)
    kind.outline = *std::move(outline);
  else
    json.report(outline.error().message);
}

// What the entry does not say stays as `kind` has it: inherited.
void read_kind(const JsonReader& json, OpeningKind& kind) {
  json.allow_only({"is", "names", "type", "width", "least_width", "sill", "head", "to_ceiling",
                   "swing", "leaves", "glazed", "outline", "meshes"});
  kind.names = read_texts(json["names"]);
  read_type(json["type"], kind);
  kind.width = read_length(json["width"], kind.width);
  kind.sill = read_length(json["sill"], kind.sill);
  kind.head = read_length(json["head"], kind.head);
  kind.least_width = json["least_width"].number_or(kind.least_width, 0.1, widest);
  kind.to_ceiling = json["to_ceiling"].boolean_or(kind.to_ceiling);
  read_swing(json["swing"], kind);
  kind.leaves = static_cast<int>(json["leaves"].integer_or(kind.leaves, 1, 2));
  kind.glazed = json["glazed"].boolean_or(kind.glazed);
  read_outline(json["outline"], kind);
  if (json["meshes"].exists()) kind.meshes = read_texts(json["meshes"]);
}

}  // namespace

Result<OpeningKinds> OpeningKinds::parse(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "kinds"});
  OpeningKinds table;
  for (const auto& [name, entry] : root["kinds"].members()) {
    OpeningKind kind;
    if (const std::string parent = entry["is"].text_or(""); !parent.empty()) {
      const auto known = table.kinds_.find(parent);
      if (known == table.kinds_.end())
        entry["is"].report("\"" + parent + "\" is no kind before this one");
      else
        kind = known->second;
    }
    kind.name = name;
    read_kind(entry, kind);
    for (const auto& one : kind.names)
      if (!table.names_.emplace(normalised(one), name).second)
        entry["names"].report("\"" + one + "\" is the name of another kind, too");
    table.names_[normalised(name)] = name;
    table.kinds_[name] = std::move(kind);
  }
  if (problems.first()) return *problems.first();
  return table;
}

const Result<OpeningKinds>& OpeningKinds::built_in() {
  static const Result<OpeningKinds> kinds =
      parse(resource("data/openings.json").value_or("{}"), "data/openings.json");
  return kinds;
}

const OpeningKind* OpeningKinds::find(std::string_view name) const {
  const auto known = names_.find(normalised(name));
  return known == names_.end() ? nullptr : &kinds_.find(known->second)->second;
}

const OpeningKind* OpeningKinds::of(const Opening& opening) const {
  const OpeningKind* kind = find(opening.kind);
  return kind && kind->type == opening.type ? kind : find(name(opening.type));
}

Result<std::vector<Vec2>> outline_of_cut_out(std::string_view path) {
  auto points = outline_of_path(path);
  if (!points) return points.error();
  for (auto& p : *points) p = Vec2(p.x(), 1.0 - p.y()).cwiseMax(0.0).cwiseMin(1.0);
  if (signed_area(*points) < 0) std::reverse(points->begin(), points->end());
  if (!is_opening_outline(*points))
    return Error{
        Error::Kind::invalid_input,
        "a hole's outline fills a fair part of the unit square, and every upright line crosses "
        "it once"};
  return signed_area(*points) > whole_square ? std::vector<Vec2>() : *std::move(points);
}

}  // namespace roomgen
