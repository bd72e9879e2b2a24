#include "resumable_lines.h"

#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr const char* lines_name = "results.jsonl";

std::string line_of(const Json& json) { return json_line(json) + "\n"; }

}  // namespace

Result<ResumableLines> ResumableLines::open(const fs::path& folder, const Json& head, bool force) {
  ResumableLines lines;
  lines.path_ = folder / lines_name;
  if (auto status = make_folder(folder); !status) return status.error();
  std::error_code code;
  if (fs::exists(lines.path_, code) && !force) {
    if (auto status = lines.read(head); !status) return status.error();
  } else if (!fs::is_empty(folder, code) && !force) {
    return Error{Error::Kind::io,
                 folder.string() + ": is not empty and no earlier experiment; choose another folder or --force"};
  }
  std::string text = line_of(head);
  for (const auto& line : lines.earlier_) text += line_of(line.json);
  if (auto status = write_file(lines.path_, text); !status) return status.error();
  auto file = AppendedFile::open(lines.path_);
  if (!file) return file.error();
  lines.file_ = *std::move(file);
  return lines;
}

Status ResumableLines::add(const Json& result) { return file_->append(line_of(result)); }

Status ResumableLines::read(const Json& head) {
  const auto text = read_file(path_);
  if (!text) return text.error();
  const auto lines = split(*text, '\n');
  const auto first = parse_json(lines.front(), path_.string());
  if (!first || *first != head)
    return Error{Error::Kind::invalid_input,
                 path_.string() + ": holds another experiment (other sentences, seed or model); "
                                  "choose another folder or --force"};
  for (std::size_t k = 1; k < lines.size(); ++k) {
    if (lines[k].empty()) continue;
    const std::string where = path_.string() + ": line " + std::to_string(k + 1);
    auto json = parse_json(lines[k], where);
    // The last line may be half written: its result is made again.
    if (!json && k + 1 == lines.size()) break;
    if (!json) return json.error();
    earlier_.push_back({where, *std::move(json)});
  }
  return {};
}

}  // namespace roomgen::cli
