#include "meant_input.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "input_schema.h"
#include "json_rpc.h"
#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace {

constexpr double largest_whole = 9007199254740992.0;  // up to here a double is exact

bool is_left_out(const Json& value) {
  return value.is_null() || (value.is_array() && value.empty()) ||
         (value.is_string() && value.get_ref<const std::string&>().empty());
}

bool has_elements_of(const Json& list, const std::string& type) {
  return std::all_of(list.begin(), list.end(),
                     [&](const Json& each) { return is_of_type(each, type); });
}

// A text of what the schema wants, also of a list without its brackets if it can mean nothing else.
Json read_text(const Json& schema, const Json& given) {
  const std::string type = schema.value("type", "");
  if (type.empty() || type == "string") return given;
  const std::string& text = given.get_ref<const std::string&>();
  const auto plain = parse_from_client(type == "boolean" ? lower(text) : text, "text");
  if (plain && (plain->is_null() || is_of_type(*plain, type))) return *plain;
  if (type != "array") return given;
  const auto list = parse_from_client("[" + text + "]", "text");
  const std::string elements = schema.value("items", Json::object()).value("type", "");
  return list && has_elements_of(*list, elements) ? *list : given;
}

Json members_as_meant(const Json& schema, const Json& object) {
  const Json known = schema.value("properties", Json::object());
  Json result = Json::object();
  for (const auto& [key, member] : object.items()) {
    const auto its = known.find(key);
    Json meant = its == known.end() ? member : as_meant(*its, member);
    if (its == known.end() || !is_left_out(meant)) result[key] = std::move(meant);
  }
  return result;
}

Json elements_as_meant(const Json& schema, const Json& list) {
  const auto items = schema.find("items");
  if (items == schema.end()) return list;
  Json result = Json::array();
  for (const auto& each : list) result.push_back(as_meant(*items, each));
  return result;
}

}  // namespace

Json as_meant(const Json& schema, const Json& value) {
  const Json read = value.is_string() ? read_text(schema, value) : value;
  const std::string type = schema.value("type", "");
  if (type == "object" && read.is_object()) return members_as_meant(schema, read);
  if (type == "array" && read.is_array()) return elements_as_meant(schema, read);
  if (type == "integer" && read.is_number_float() && is_of_type(read, type) &&
      std::abs(read.get<double>()) <= largest_whole)
    return static_cast<std::int64_t>(read.get<double>());
  return read;
}

}  // namespace roomgen::mcp
