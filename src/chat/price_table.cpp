#include "roomgen/chat/chat_model.h"

#include <cassert>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double max_price = 1e6;
constexpr std::string_view built_in_path = "data/prices.json";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Versions are numbered, dated, or the latest; other endings make another model at another price.
bool is_version_of(std::string_view model, std::string_view name) {
  if (!model.starts_with(name)) return false;
  const auto ending = model.substr(name.size());
  return ending.empty() || ending == "-latest" ||
         (ending.size() > 1 && (ending[0] == '-' || ending[0] == '@') && is_digit(ending[1]));
}

}  // namespace

PriceTable PriceTable::built_in() {
  const auto text = resource(built_in_path);
  auto table = parse(text.value_or(""), std::string(built_in_path));
  assert(table);
  return table ? *std::move(table) : PriceTable();
}

Result<PriceTable> PriceTable::parse(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"format", "version", "date", "source", "unit", "models"});
  const auto models = root["models"];
  if (!models.exists()) root.report("no \"models\"");
  PriceTable table;
  for (const auto& [name, price] : models.members()) {
    price.allow_only({"input", "output"});
    table.entries_.push_back(
        {lower(name), {price["input"].number(0, max_price), price["output"].number(0, max_price)}});
  }
  if (auto error = problems.first()) return *error;
  return table;
}

std::optional<Price> PriceTable::find(std::string_view model) const {
  const std::string wanted = lower(model.substr(model.rfind('/') + 1));
  const Entry* best = nullptr;
  for (const auto& entry : entries_)
    if (is_version_of(wanted, entry.name) && (!best || entry.name.size() > best->name.size()))
      best = &entry;
  return best ? std::optional(best->price) : std::nullopt;
}

}  // namespace roomgen
