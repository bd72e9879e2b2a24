#include "roomgen/chat/chat_model.h"

#include <set>

#include "base/resource.h"
#include "base/sha256.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::string_view folder_of_resources = "prompts/";
constexpr std::string_view ending = ".md";

// Calls `plain` with the text between slots and `slot` with the name of each.
template <typename Plain, typename Slot>
void split_at_slots(std::string_view text, Plain plain, Slot slot) {
  while (!text.empty()) {
    const auto open = text.find("{{");
    const auto close = open == std::string_view::npos ? open : text.find("}}", open);
    if (close == std::string_view::npos) return plain(text);
    plain(text.substr(0, open));
    slot(trim(text.substr(open + 2, close - open - 2)));
    text.remove_prefix(close + 2);
  }
}

std::set<std::string, std::less<>> slots_of(std::string_view text) {
  std::set<std::string, std::less<>> names;
  split_at_slots(
      text, [](std::string_view) {}, [&](std::string_view name) { names.emplace(name); });
  return names;
}

Error invalid(const std::string& message) {
  return {Error::Kind::invalid_input, message};
}

}  // namespace

Prompts Prompts::built_in() {
  Prompts prompts;
  for (const auto path : resources(folder_of_resources)) {
    auto name = path.substr(folder_of_resources.size());
    name.remove_suffix(ending.size());
    prompts.texts_.emplace(name, *resource(path));
  }
  return prompts;
}

Result<Prompts> Prompts::from_folder(const std::filesystem::path& folder) {
  Prompts prompts = built_in();
  bool any = false;
  for (auto& [name, text] : prompts.texts_) {
    const auto path = folder / (name + std::string(ending));
    std::error_code code;
    if (!std::filesystem::exists(path, code)) continue;
    auto other = read_file(path);
    if (!other) return other.error();
    const auto known = slots_of(text);
    for (const auto& slot : slots_of(*other))
      if (!known.count(slot))
        return invalid(path.string() + ": nothing fills {{" + slot + "}}; the slots are " +
                       join({known.begin(), known.end()}, ", "));
    text = *std::move(other);
    any = true;
  }
  if (!any)
    return Error{Error::Kind::not_found,
                 folder.string() + ": holds no prompt; the names are those of prompts/*.md"};
  return prompts;
}

Result<std::string> Prompts::render(std::string_view name, const Slots& slots) const {
  const auto found = texts_.find(name);
  if (found == texts_.end()) return invalid("no prompt is called " + std::string(name));
  std::string text, missing;
  split_at_slots(
      found->second, [&](std::string_view plain) { text += plain; },
      [&](std::string_view slot) {
        const auto value = slots.find(slot);
        if (value == slots.end())
          missing = slot;
        else
          text += value->second;
      });
  if (!missing.empty())
    return invalid("prompt " + std::string(name) + ": nothing fills {{" + missing + "}}");
  return text;
}

std::string Prompts::version() const {
  std::string all;
  for (const auto& [name, text] : texts_) all += name + '\n' + text + '\n';
  return sha256_hex(all);
}

}  // namespace roomgen
