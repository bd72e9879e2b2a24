#include <array>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "document_parts.h"
#include "roomgen/base/json.h"
#include "roomgen/scene/requirement.h"

namespace roomgen {

namespace {

constexpr std::array<std::string_view, 10> names = {
    "thing", "count",  "attribute", "relation", "room",
    "style", "person", "activity",  "absence",  "not understood"};
constexpr std::size_t max_heard = 50'000, max_ids = 500;
constexpr int max_bytes = 10'000'000;

Heard::As read_as(const JsonReader& json) {
  const std::string text = json.text(50);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return static_cast<Heard::As>(i);
  json.report("\"" + text + "\" is nothing that words are heard as (docs/requirements.md)");
  return Heard::As::not_understood;
}

}  // namespace

std::string_view name(Heard::As as) {
  return names[static_cast<std::size_t>(as)];
}

Json to_json(const std::vector<Heard>& heard) {
  Json json = Json::array();
  for (const auto& words : heard) {
    Json entry = {{"span", {words.begin, words.end}}, {"text", words.text}, {"as", name(words.as)}};
    entry["requirements"] = words.requirements;
    json.push_back(std::move(entry));
  }
  return json;
}

std::vector<Heard> read_heard(const JsonReader& json) {
  std::vector<Heard> heard;
  for (const auto& element : json.elements_or_none(max_heard)) {
    element.allow_only({"span", "text", "as", "requirements"});
    Heard words;
    const auto span = element["span"].numbers(2, 0, max_bytes);
    words.begin = static_cast<std::size_t>(span[0]);
    words.end = static_cast<std::size_t>(span[1]);
    if (words.end < words.begin) element["span"].report("must be [first byte, one past the last]");
    words.text = element["text"].text_or("", 100000);
    words.as = read_as(element["as"]);
    for (const auto& id : element["requirements"].elements_or_none(max_ids))
      words.requirements.push_back(id.text(200));
    heard.push_back(std::move(words));
  }
  return heard;
}

}  // namespace roomgen
