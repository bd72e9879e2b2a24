#include "json_lines.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/file.h"

namespace roomgen {

Status read_json_lines(const std::filesystem::path& path, std::size_t most_bytes,
                       const std::function<Status(const Json& line, const std::string& source)>& take) {
  const auto text = read_file(path, most_bytes);
  if (!text) return text.error();
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text->size(); ++line) {
    const std::size_t end = std::min(text->find('\n', begin), text->size());
    const std::string source = path.string() + ": line " + std::to_string(line + 1);
    const auto json = parse_json(std::string_view(*text).substr(begin, end - begin), source);
    if (!json) return json.error();
    if (auto status = take(*json, source); !status) return status;
    begin = end + 1;
  }
  return {};
}

}  // namespace roomgen
