#include "journal.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "journal_line.h"
#include "roomgen/base/json.h"

namespace roomgen {

namespace {

constexpr int journal_version = 1;

std::string header_line() {
  const Json header = {{"format", "roomgen-journal"}, {"version", journal_version}};
  return journal_line(header.dump());
}

// Whether the bytes may be what is left of a journal whose very beginning a crash cut off: nothing, or the
// beginning of a header up to the end or to a gap that was never filled.
bool may_be_unbegun(std::string_view bytes) {
  const std::string header = header_line();
  const auto other = std::mismatch(bytes.begin(), bytes.end(), header.begin(), header.end());
  return other.first == bytes.end() || other.second == header.end() || *other.first == '\0';
}

Status check_header(std::string_view body, const std::string& name) {
  const auto header = parse_json(body, name + ": line 1");
  if (!header) return header.error();
  if (!header->is_object() || header->value("format", Json()) != "roomgen-journal")
    return Error{Error::Kind::invalid_input, name + ": line 1: is no journal of roomgen"};
  const Json version = header->value("version", Json());
  if (version == journal_version) return {};
  return Error{Error::Kind::invalid_input,
               name + ": line 1: was written by a newer roomgen (version " + version.dump() +
                   " of the journal; this one reads version " + std::to_string(journal_version) +
                   "): edit it with that one, or move the journal away, and its history begins anew"};
}

void tell_damage(const JournalLine& line, const std::string& name, const std::string& why, JournalReading& reading) {
  reading.notices.push_back(name + ": line " + std::to_string(line.number) + " (byte " +
                            std::to_string(line.begin) + ") is damaged" + (why.empty() ? "" : ": " + why) +
                            "; what it said is lost, the rest is used");
}

bool says_version(const JournalLine& line) { return line.body.starts_with(R"({"format")"); }

}  // namespace

Result<JournalReading> read_journal(std::string_view bytes, const std::string& name) {
  JournalReading reading;
  const JournalLines found = split_journal(bytes);
  if (found.lines.empty()) {
    if (may_be_unbegun(bytes)) return reading;
    return Error{Error::Kind::invalid_input,
                 name + ": is no journal of roomgen, or wholly damaged; move it away, and a new one begins"};
  }
  for (const auto& line : found.lines) {
    if (line.body.empty()) {
      tell_damage(line, name, "", reading);
    } else if (says_version(line)) {
      if (auto status = check_header(line.body, name); !status) return status.error();
    } else {
      auto entry = parse_entry(line.body, name + ": line " + std::to_string(line.number));
      const std::size_t last = reading.entries.empty() ? 0 : reading.entries.back().sequence;
      if (entry && entry->sequence <= last)
        entry = Error{Error::Kind::invalid_input, "its number " + std::to_string(entry->sequence) + " comes too late"};
      if (entry) reading.entries.push_back(*std::move(entry));
      else tell_damage(line, name, entry.error().message, reading);
    }
  }
  if (reading.entries.empty()) return reading;
  reading.whole_bytes = found.whole_bytes;
  if (found.whole_bytes < bytes.size())
    reading.notices.push_back(name + ": the last line was not written to its end: " +
                              std::to_string(bytes.size() - found.whole_bytes) + " bytes are left out");
  return reading;
}

std::string journal_lines(std::span<const JournalEntry> entries, bool begins) {
  std::string text = begins ? header_line() : std::string();
  for (const auto& entry : entries) text += journal_line(journal_text(entry));
  return text;
}

}  // namespace roomgen
