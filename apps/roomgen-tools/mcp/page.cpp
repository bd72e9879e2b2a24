#include "page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"

namespace roomgen::mcp {

namespace {

std::size_t bytes_of(const Json& value) { return json_line(value).size(); }

/// An element of a report's lists.
struct Entry {
  const std::string* list = nullptr;
  const Json* json = nullptr;
};

std::vector<Entry> entries_of(const Report& report) {
  std::vector<Entry> entries;
  for (const auto& list : report.lists)
    for (const auto& each : report.data.at(list)) entries.push_back({&list, &each});
  return entries;
}

// Where a page that begins at `skip` ends.
std::size_t end_of_page(const Report& report, const std::vector<Entry>& entries, std::size_t skip) {
  std::size_t end = skip, bytes = 0;
  for (; end < entries.size(); ++end) {
    bytes += bytes_of(*entries[end].json) + report.lines[end].size();
    if (bytes > page_bytes && end > skip) break;
  }
  return end;
}

// Of a list the elements that a share holds; returns how many went.
std::size_t cut_list(Json& list, std::size_t share) {
  std::size_t kept = 0;
  for (std::size_t bytes = 0; kept < list.size(); ++kept)
    if (bytes += bytes_of(list[kept]) + 1; bytes > share) break;
  const std::size_t gone = list.size() - kept;
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(kept), list.end());
  return gone;
}

void cut_lists(Json& data) {
  if (!data.is_object() || bytes_of(data) <= answer_bytes) return;
  const auto is_list = [](const Json& member) { return member.is_array(); };
  const auto lists = static_cast<std::size_t>(std::count_if(data.begin(), data.end(), is_list));
  Json cut = Json::object();
  for (const auto& [key, member] : data.items())
    if (member.is_array())
      if (const std::size_t gone = cut_list(member, answer_bytes / lists)) cut[key] = gone;
  if (!cut.empty()) data["cut"] = cut;
}

void cut_text(std::string& text) {
  if (text.size() <= answer_bytes) return;
  std::string kept = shortened(text, answer_bytes);
  if (const auto end = kept.rfind('\n'); end != std::string::npos) kept.resize(end);
  const auto rest = text.begin() + static_cast<std::ptrdiff_t>(kept.size());
  const auto lines = std::count(rest, text.end(), '\n');
  text = kept + "\n(cut here; " + std::to_string(lines) + " more lines)";
}

}  // namespace

Result<ToolAnswer> page_of(const Report& report, std::size_t skip) {
  const auto entries = entries_of(report);
  if (skip > 0 && skip >= entries.size())
    return Error{Error::Kind::invalid_input,
                 "/skip: there are only " + std::to_string(entries.size()) + " entries"};
  const std::size_t end = end_of_page(report, entries, skip);
  Json data = report.data;
  for (const auto& list : report.lists) data[list] = Json::array();
  std::vector<std::string> lines = report.head;
  for (std::size_t i = skip; i < end; ++i) {
    data[*entries[i].list].push_back(*entries[i].json);
    lines.push_back(report.lines[i]);
  }
  if (end < entries.size()) {
    data["next"] = end;
    lines.push_back("and " + std::to_string(entries.size() - end) +
                    " more: the same call with skip " + std::to_string(end) + " goes on");
  }
  return text_answer(join(lines, "\n"), std::move(data));
}

void keep_within_bounds(ToolAnswer& answer) {
  cut_lists(answer.data);
  for (auto& part : answer.content)
    if (part["type"] == "text") cut_text(part["text"].get_ref<std::string&>());
}

}  // namespace roomgen::mcp
