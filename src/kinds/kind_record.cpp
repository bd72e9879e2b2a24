#include "roomgen/kinds/kind_record.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "roomgen/base/json.h"
#include "roomgen/base/resource.h"

namespace roomgen {

namespace {

constexpr int kind_depth = 3;  // of what is said of a kind: {"kinds": {"chair": {"names": ...

// Most of these files says how things are made: it is not kept.
bool matters(int depth, Json::parse_event_t event, const Json& parsed) {
  if (event != Json::parse_event_t::key) return true;
  static constexpr std::array<std::string_view, 4> told = {"is", "names", "size", "mount"};
  const auto& key = parsed.get_ref<const std::string&>();
  if (depth == 1) return key == "kinds";
  return depth != kind_depth || std::find(told.begin(), told.end(), key) != told.end();
}

KindRecord read_record(const std::string& name, const JsonReader& json) {
  KindRecord record;
  record.name = name;
  record.parent = json["is"].text_or("");
  for (const auto& other : json["names"].elements_or_none(500)) record.names.push_back(other.text());
  if (json["size"].exists())
    if (const auto sides = json["size"].numbers(3, 0.001, 20.0); sides.size() == 3)
      record.size = Vec3(sides[0], sides[1], sides[2]);
  if (json["mount"].exists()) {
    record.mount = parse_mount(json["mount"].text());
    if (!record.mount) json["mount"].report("is none of floor, wall, ceiling, surface");
  }
  return record;
}

}  // namespace

Result<std::vector<KindRecord>> read_kind_records(std::string_view text, const std::string& source) {
  const Json json = Json::parse(text, matters, false);
  if (json.is_discarded())
    return Error{Error::Kind::invalid_input, source + ": this is no JSON"};
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  std::vector<KindRecord> records;
  for (const auto& [name, entry] : root["kinds"].members())
    records.push_back(read_record(name, entry));
  if (problems.first()) return *problems.first();
  return records;
}

Result<std::vector<KindRecord>> shape_kind_records() {
  std::vector<KindRecord> all;
  for (const auto path : resources("data/shapes/kinds/")) {
    auto records = read_kind_records(*resource(path), std::string(path));
    if (!records) return records.error();
    std::move(records->begin(), records->end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace roomgen
