#include "loose_json.h"

#include <algorithm>
#include <optional>

#include "base/json_values.h"
#include "loose_parser.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::string_view thought_begin = "<think", thought_end = "</think";

/// An object in the text.
struct Candidate {
  Json json;
  std::vector<std::string> repairs;
  std::size_t length = 0;
  bool whole = true;
};

std::vector<Candidate> objects_in(std::string_view text) {
  std::vector<Candidate> found;
  for (auto at = text.find('{'); at != std::string_view::npos; at = text.find('{', at)) {
    LooseParser parser(text, at);
    auto json = parser.parse();
    const std::size_t end = std::max(at + 1, parser.position());
    if (json && !json->empty())
      found.push_back({*std::move(json), parser.repairs(), end - at, !parser.truncated()});
    at = end;
  }
  return found;
}

// The text without what the model said to itself; a thought without a beginning starts the answer.
std::string without_thoughts(std::string_view text) {
  std::string spoken;
  std::size_t at = 0, begin = text.find(thought_begin);
  while (true) {
    const auto end = text.find(thought_end, at);
    if (end == std::string_view::npos) return spoken.append(text.substr(at));
    // Looked for once only when there is none: the time stays linear.
    if (begin < at) begin = text.find(thought_begin, at);
    if (begin < end)
      spoken.append(text.substr(at, begin - at));
    else
      spoken.clear();
    at = end + thought_end.size();
  }
}

// Bytes that are no UTF-8 replaced: whoever writes the texts to a file can rely on it.
std::string as_utf8(std::string_view text) {
  const auto quoted = json_line(std::string(text));
  return json_literal(quoted).get<std::string>();
}

// The object itself, or the first one inside it, that has one of the keys.
const Json* with_keys(const Json& json, const std::vector<std::string>& keys) {
  if (json.is_object() && member(json, keys)) return &json;
  if (!json.is_structured()) return nullptr;
  for (const auto& element : json)
    if (const Json* found = with_keys(element, keys)) return found;
  return nullptr;
}

std::optional<LooseJson> choose(std::vector<Candidate> candidates,
                                const std::vector<std::string>& keys) {
  for (const bool whole : {true, false})
    for (auto it = candidates.rbegin(); it != candidates.rend(); ++it) {
      if (it->whole != whole) continue;
      if (const Json* found = with_keys(it->json, keys)) return LooseJson{*found, it->repairs};
    }
  const auto largest =
      std::max_element(candidates.begin(), candidates.end(),
                       [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  if (largest == candidates.end()) return std::nullopt;
  return LooseJson{std::move(largest->json), std::move(largest->repairs)};
}

std::string normalised(std::string_view name) {
  return join(words(name), "");
}

}  // namespace

const Json* member(const Json& object, const std::vector<std::string>& names) {
  if (!object.is_object()) return nullptr;
  for (const auto& name : names) {
    const std::string wanted = normalised(name);
    for (const auto& [key, value] : object.items())
      if (!value.is_null() && normalised(key) == wanted) return &value;
  }
  return nullptr;
}

Result<LooseJson> find_json(std::string_view text, const WantedKeys& wanted) {
  if (text.size() > max_reply_bytes)
    return Error{Error::Kind::limit,
                 "the answer is longer than " + std::to_string(max_reply_bytes) + " bytes"};
  const std::string readable = as_utf8(text);
  const std::string spoken = without_thoughts(readable);
  std::vector<std::string> keys = wanted.names;
  keys.insert(keys.end(), wanted.spellings.begin(), wanted.spellings.end());
  auto found = choose(objects_in(spoken), keys);
  if (!found && spoken.size() < readable.size()) {
    found = choose(objects_in(readable), keys);
    if (found) found->repairs.emplace_back("the answer was taken from the thoughts");
  }
  if (!found)
    return Error{Error::Kind::invalid_input,
                 "the answer holds no JSON object; answer with one object that has the keys \"" +
                     join(wanted.names, "\", \"") + "\""};
  if (readable.size() != text.size() || readable != text)
    found->repairs.emplace_back("bytes that are no UTF-8 were replaced");
  return *std::move(found);
}

std::string text_in(const Json* value) {
  return value && value->is_string() ? std::string(trim(value->get_ref<const std::string&>())) : "";
}

}  // namespace roomgen
