#include "input_schema.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace {

Status fault(const std::string& pointer, const std::string& what) {
  return Error{Error::Kind::invalid_input, (pointer.empty() ? "the arguments" : pointer) + ": " + what};
}

bool is_whole(const Json& value) {
  return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
}

std::string list_in_words(const std::string& elements) {
  if (elements == "number") return "a list of numbers, as in [1.5, 2]";
  if (elements == "string") return "a list of texts, as in [\"a\", \"b\"]";
  return elements == "object" ? "a list of objects, as in [{...}, {...}]" : "a list";
}

std::string in_words(const Json& schema) {
  const std::string type = schema.value("type", "");
  if (type == "object") return "an object";
  if (type == "array")
    return list_in_words(schema.value("items", Json::object()).value("type", ""));
  if (type == "string") return "a text";
  if (type == "boolean") return "true or false";
  return type == "integer" ? "a whole number" : "a number";
}

Status check(const Json& schema, const Json& value, const std::string& pointer);

Status check_enum(const Json& known, const Json& value, const std::string& pointer) {
  std::vector<std::string> names;
  for (const auto& each : known) {
    if (each == value) return {};
    names.push_back(each.dump());
  }
  return fault(pointer, "expected one of " + join(names, ", "));
}

// Of a number its value, else the length: bytes of a text, elements of a list.
Status check_bounds(const Json& schema, double amount, const char* least, const char* most, const std::string& of,
                    const std::string& pointer) {
  const auto low = schema.find(least), high = schema.find(most);
  if (low != schema.end() && !(amount >= low->get<double>()))
    return fault(pointer, of + " is below " + format_number(low->get<double>()));
  if (high != schema.end() && !(amount <= high->get<double>()))
    return fault(pointer, of + " is above " + format_number(high->get<double>()));
  return {};
}

Status check_members(const Json& schema, const Json& value, const std::string& pointer) {
  const Json known = schema.value("properties", Json::object());
  for (const auto& [key, member] : value.items()) {
    const auto its = known.find(key);
    if (its != known.end()) {
      if (auto status = check(*its, member, pointer + "/" + key); !status) return status;
    } else if (schema.value("additionalProperties", true) == false) {
      std::vector<std::string> names;
      for (const auto& each : known.items()) names.push_back(each.key());
      const std::string close = closest_name(key, names);
      const std::string help = close.empty() ? "; known are " + join(names, ", ") : "; did you mean \"" + close + "\"?";
      return fault(pointer, "unknown \"" + shortened(key, 100) + "\"" + help);
    }
  }
  for (const auto& key : schema.value("required", Json::array()))
    if (!value.contains(key.get<std::string>()))
      return fault(pointer, "\"" + key.get<std::string>() + "\" is missing or empty");
  return {};
}

Status check_elements(const Json& schema, const Json& value, const std::string& pointer) {
  const auto items = schema.find("items");
  for (std::size_t i = 0; items != schema.end() && i < value.size(); ++i)
    if (auto status = check(*items, value[i], pointer + "/" + std::to_string(i)); !status) return status;
  return {};
}

Status check(const Json& schema, const Json& value, const std::string& pointer) {
  const std::string type = schema.value("type", "");
  if (!type.empty() && !is_of_type(value, type))
    return fault(pointer, "expected " + in_words(schema));
  if (const auto known = schema.find("enum"); known != schema.end()) return check_enum(*known, value, pointer);
  if (value.is_number()) return check_bounds(schema, value.get<double>(), "minimum", "maximum", "the number", pointer);
  if (value.is_string()) {
    const auto length = static_cast<double>(value.get_ref<const std::string&>().size());
    return check_bounds(schema, length, "minLength", "maxLength", "the text's length", pointer);
  }
  if (value.is_object()) return check_members(schema, value, pointer);
  if (!value.is_array()) return {};
  const auto length = static_cast<double>(value.size());
  if (auto status = check_bounds(schema, length, "minItems", "maxItems", "the list's length", pointer); !status)
    return status;
  return check_elements(schema, value, pointer);
}

}  // namespace

bool is_of_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return is_whole(value);
  return type == "number" && value.is_number();
}

Status check_input(const Json& schema, const Json& value) { return check(schema, value, ""); }

}  // namespace roomgen::mcp
