#include "labels.h"

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::assets {

namespace {

void read_traits(const std::string& text, const JsonReader& json, Label& label) {
  for (const auto& trait : words(text)) {
    if (trait == "round")
      label.round = true;
    else if (trait == "frontless")
      label.front = false;
    else if (trait == "unsteady")
      label.unsteady = true;
    else if (const auto mount = parse_mount(trait))
      label.mount = mount;
    else
      json.report("\"" + trait + "\" is none of round, frontless, unsteady, floor, wall, ceiling, surface");
  }
}

Label read_label(const JsonReader& json) {
  const auto fields = split(json.text(), '|');
  Label label;
  label.category = fields[0];
  if (fields.size() > 1) label.tags = words(fields[1]);
  if (fields.size() > 2) read_traits(fields[2], json, label);
  // A round thing looks the same from everywhere unless the label says more.
  if (label.round && !label.front) label.front = false;
  return label;
}

}  // namespace

Result<Labels> Labels::parse(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  Labels result;
  for (const auto& [library, entries] : root["labels"].members())
    for (const auto& [id, entry] : entries.members())
      result.labels_[library + "/" + id] = read_label(entry);
  if (problems.first()) return *problems.first();
  return result;
}

const Labels& Labels::built_in() {
  static const Labels labels = [] {
    auto parsed =
        parse(resource("data/furniture-labels.json").value_or("{}"), "data/furniture-labels.json");
    // A test parses the file; a build whose data is broken has no labels.
    return parsed ? *std::move(parsed) : Labels{};
  }();
  return labels;
}

const Label* Labels::find(const std::string& library, const std::string& id) const {
  const auto found = labels_.find(library + "/" + id);
  return found == labels_.end() ? nullptr : &found->second;
}

}  // namespace roomgen::assets
