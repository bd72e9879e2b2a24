#include "journal_entry.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_reader.h"
#include "roomgen/base/file.h"

namespace roomgen {

namespace {

constexpr std::pair<JournalEntry::Kind, std::string_view> kinds_of_entries[] = {
    {JournalEntry::Kind::scene, "scene"},
    {JournalEntry::Kind::edit, "edit"},
    {JournalEntry::Kind::head, "head"},
    {JournalEntry::Kind::snapshot, "snapshot"}};

std::string_view kind_name(JournalEntry::Kind kind) {
  for (const auto& [value, name] : kinds_of_entries)
    if (value == kind) return name;
  return "";
}

JournalEntry::Kind read_kind(const JsonReader& json) {
  const std::string text = json.text(20);
  for (const auto& [value, name] : kinds_of_entries)
    if (name == text) return value;
  json.report("\"" + text + "\" is none of scene, edit, head, snapshot");
  return JournalEntry::Kind::edit;
}

std::size_t read_number(const JsonReader& json) {
  return static_cast<std::size_t>(json.integer_or(0, 0, max_sequence));
}

/// An object of JSON on one line, key by key.
class Members {
 public:
  void add(std::string_view key, const Json& value) { add_written(key, json_line(value)); }
  void add_written(std::string_view key, std::string_view json) {
    text_ += text_.empty() ? "{\"" : ",\"";
    text_.append(key).append("\":").append(json);
  }
  std::string take() { return std::move(text_) + '}'; }

 private:
  std::string text_;
};

}  // namespace

std::string journal_text(const JournalEntry& entry) {
  Members members;
  members.add("sequence", entry.sequence);
  members.add("kind", kind_name(entry.kind));
  members.add("branch", entry.branch);
  const bool is_edit = entry.kind == JournalEntry::Kind::edit, is_state = is_edit || entry.kind == JournalEntry::Kind::scene;
  if (is_state) members.add("parent", entry.parent);
  else members.add("to", entry.to);
  if (entry.kind != JournalEntry::Kind::snapshot) {
    members.add("by", entry.by);
    members.add("asked", entry.asked);
  }
  if (is_edit) {
    if (!entry.operations.empty()) members.add_written("operations", entry.operations);
    members.add("before", entry.before);
  }
  if (is_state) members.add("after", entry.after);
  if (is_edit) members.add_written("patch", entry.patch);
  if (entry.kind == JournalEntry::Kind::scene || entry.kind == JournalEntry::Kind::snapshot) members.add("text", entry.text);
  return members.take();
}

Result<JournalEntry> parse_entry(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"sequence", "kind", "branch", "parent", "to", "by", "asked", "operations", "before", "after",
                   "patch", "text"});
  JournalEntry entry;
  entry.kind = read_kind(root["kind"]);
  entry.sequence = read_number(root["sequence"]);
  entry.parent = read_number(root["parent"]);
  entry.to = read_number(root["to"]);
  entry.branch = root["branch"].text(200);
  entry.by = root["by"].text_or("", 200);
  entry.asked = root["asked"].text_or("", max_document_bytes);
  entry.before = root["before"].text_or("", 64);
  entry.after = root["after"].text_or("", 64);
  entry.text = root["text"].text_or("", max_document_bytes);
  if (const auto operations = root["operations"]; operations.exists()) entry.operations = json_line(*operations.raw());
  if (const auto patch = root["patch"]; patch.exists()) entry.patch = json_line(*patch.raw());
  if (entry.kind == JournalEntry::Kind::edit && !root["patch"].is_object())
    root["patch"].report("an edit says what changed");
  // So that whoever goes back from a state comes to an end.
  if (entry.parent > 0 && entry.parent >= entry.sequence) root["parent"].report("is no earlier entry");
  if (entry.to > 0 && entry.to >= entry.sequence) root["to"].report("is no earlier entry");
  if (problems.first()) return *problems.first();
  return entry;
}

}  // namespace roomgen
