#include "roomgen/kinds/kind_table.h"

#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>
#include <set>

#include "base/json_reader.h"
#include "base/resource.h"
#include "kind_json.h"
#include "language/lexicon.h"
#include "noun_kind.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t most_words = 24;      // of a text that may be a name
constexpr std::size_t most_find_words = 20;  // of one whose endings are tried
constexpr int most_ancestors = 16;

std::vector<std::string> as_written(std::vector<std::string> pieces) {
  return pieces;
}

std::vector<std::string> last_in_singular(std::vector<std::string> pieces) {
  pieces.back() = singular(pieces.back());
  return pieces;
}

std::vector<std::string> in_singular(std::vector<std::string> pieces) {
  for (auto& piece : pieces) piece = singular(piece);
  return pieces;
}

}  // namespace

bool is_of(const Kind& kind, std::string_view name) {
  return std::find(kind.lineage.begin(), kind.lineage.end(), name) != kind.lineage.end();
}

bool is_any_of(const Kind& kind, const std::vector<std::string>& kinds) {
  return std::any_of(kinds.begin(), kinds.end(), [&](const std::string& one) { return is_of(kind, one); });
}

// Reads the entries of all files, parents first, so that children can copy them.
class KindTable::Reader {
 public:
  explicit Reader(KindTable& table) : table_(table) {}

  std::optional<Error> run(std::span<const KindFile> files) {
    for (const auto& file : files)
      if (auto error = open(file)) return error;
    while (add_known() > 0) {}
    for (const auto& entry : entries_)
      if (!table_.kinds_.count(entry.name))
        entry.json["is"].report("\"" + entry.json["is"].text_or("") + "\" is no kind, or leads in a circle");
    if (auto error = first_problem()) return error;
    table_.index_names();
    for (auto& entry : entries_) resolve(entry);
    return first_problem();
  }

 private:
  struct Entry {
    std::string name;
    JsonReader json;
  };

  std::optional<Error> open(const KindFile& file) {
    auto json = parse_json(file.text, file.source);
    if (!json) return json.error();
    documents_.push_back(*std::move(json));
    problems_.emplace_back(file.source);
    const JsonReader root(documents_.back(), problems_.back());
    root.allow_only({"format", "version", "about", "kinds"});
    for (const auto& [name, entry] : root["kinds"].members()) {
      if (!seen_.insert(name).second) entry.report("another file has this kind too");
      entries_.push_back({name, entry});
    }
    return problems_.back().first();
  }

  std::size_t add_known() {
    std::size_t added = 0;
    for (const auto& [name, json] : entries_) {
      if (table_.kinds_.count(name)) continue;
      const std::string parent = json["is"].text_or("");
      const auto known = table_.kinds_.find(parent);
      if (!parent.empty() && known == table_.kinds_.end()) continue;
      Kind kind = parent.empty() ? Kind{} : child_of(known->second);
      kind.name = name;
      kind.lineage.insert(kind.lineage.begin(), name);
      read_kind(json, kind);
      table_.kinds_.emplace(name, std::move(kind));
      ++added;
    }
    return added;
  }

  void resolve(const Entry& entry) {
    Kind& kind = table_.kinds_.find(entry.name)->second;
    const auto to_name = [&](std::string& reference) {
      if (const Kind* found = table_.find(reference)) reference = found->name;
      else entry.json.report("\"" + reference + "\" is no kind");
    };
    for (auto& zone : kind.zones)
      for (auto& partner : zone.partners) to_name(partner);
    for (auto& gap : kind.gaps) to_name(gap.partner);
    for (auto& other : kind.tucks_under) to_name(other);

    const auto known = [&](const std::string& reference) {
      const Kind* found = table_.by_name(reference);
      if (!found) entry.json.report("\"" + reference + "\" is no kind");
      return found;
    };
    for (const auto* form : {&kind.forms.small, &kind.forms.wall, &kind.forms.ceiling, &kind.forms.round})
      if (!form->empty()) known(*form);
    if (kind.variant && kind.parent.empty()) entry.json.report("is a variant of nothing");
    known(kind.stocked_as);
    known(kind.built_as);
    for (const auto& [other, fit] : kind.substitutes) known(other);
    for (const auto& sense : kind.stands_for)
      if (const auto synset = language::lexicon().synset(sense)) table_.stand_ins_[*synset] = kind.name;
      else entry.json["stands_for"].report("\"" + sense + "\" is no sense of WordNet");
    const Kind* ancestor = &kind;
    for (int i = 0; i < most_ancestors && ancestor && !ancestor->serves.empty(); ++i) {
      ancestor = known(ancestor->serves);
      kind.supports = kind.supports || (ancestor && ancestor->supports);
    }
  }

  std::optional<Error> first_problem() const {
    for (const auto& problems : problems_)
      if (problems.first()) return problems.first();
    return std::nullopt;
  }

  KindTable& table_;
  std::deque<Json> documents_;
  std::deque<JsonReader::Problems> problems_;
  std::set<std::string> seen_;
  std::vector<Entry> entries_;
};

// Each pass goes before the next: a name as it is written before the singular of another.
void KindTable::index_names() {
  for (const bool derived : {false, true}) {
    for (const auto& [name, kind] : kinds_) add_name(name, {name, false, derived});
    for (const auto& [name, kind] : kinds_)
      for (const auto& other : kind.names) add_name(other, {name, false, derived});
    for (const auto& [name, kind] : kinds_)
      for (const auto& other : kind.loose_names) add_name(other, {name, true, derived});
    for (const auto& [name, kind] : kinds_)
      for (const auto& other : kind.resembles) add_name(other, {name, true, derived, true});
  }
}

void KindTable::add_name(const std::string& spelling, const Name& name) {
  const auto pieces = words(spelling);
  if (pieces.empty()) return;
  if (!name.derived) {
    names_.try_emplace(join(pieces, " "), name);
    return;
  }
  for (const auto& form : {last_in_singular(pieces), in_singular(pieces)})
    if (form != pieces) names_.try_emplace(join(form, " "), name);
}

Result<KindTable> KindTable::read(std::span<const KindFile> files) {
  KindTable table;
  if (auto error = Reader(table).run(files)) return *std::move(error);
  return table;
}

Result<KindTable> KindTable::parse(std::string_view text, const std::string& source) {
  const KindFile file{text, source};
  return read({&file, 1});
}

const KindTable& KindTable::built_in() {
  static const KindTable table = [] {
    std::vector<KindFile> files;
    for (const auto path : resources("data/kinds/")) files.push_back({*resource(path), std::string(path)});
    auto read = KindTable::read(files);
    // A test reads the files; a build whose data is broken has an empty table.
    return read ? *std::move(read) : KindTable{};
  }();
  return table;
}

const KindTable::Name* KindTable::look_up(std::string_view name) const {
  // Most are asked for as they are spelled here.
  if (const auto found = names_.find(name); found != names_.end()) return &found->second;
  const auto pieces = words(name);
  if (pieces.empty() || pieces.size() > most_words) return nullptr;
  for (const auto form : {as_written, last_in_singular, in_singular})
    if (const auto found = names_.find(join(form(pieces), " ")); found != names_.end())
      return &found->second;
  return nullptr;
}

const Kind* KindTable::by_name(std::string_view name) const {
  const auto found = kinds_.find(name);
  return found == kinds_.end() ? nullptr : &found->second;
}

const Kind* KindTable::named(std::string_view name) const {
  const Name* found = look_up(name);
  return found ? by_name(found->kind) : nullptr;
}

const Kind* KindTable::called(std::string_view name) const {
  const Name* found = look_up(name);
  return found && !found->loose ? by_name(found->kind) : nullptr;
}

bool KindTable::only_resembles(std::string_view name) const {
  const Name* found = look_up(name);
  return found && found->resembling;
}

const Kind* KindTable::spelled(std::string_view name) const {
  const auto found = names_.find(name);
  if (found == names_.end() || found->second.derived) return nullptr;
  return &planned(*by_name(found->second.kind));
}

const Kind* KindTable::stand_in(std::uint32_t synset) const {
  const auto found = stand_ins_.find(synset);
  return found == stand_ins_.end() ? nullptr : by_name(found->second);
}

const Kind& KindTable::planned(const Kind& kind) const {
  const Kind* found = &kind;
  while (found->variant) found = by_name(found->parent);
  return *found;
}

const Kind* KindTable::find(std::string_view name) const {
  if (const Kind* found = spelled(name)) return found;
  if (words(name).size() > most_find_words) return nullptr;
  if (const Kind* found = named(name)) return &planned(*found);
  // Then without its first word, and so on: English puts the kind last. A scent organ does not look
  // like what is told to be like an organ.
  for (std::size_t at = name.find(' '); at != std::string_view::npos; at = name.find(' ', at + 1))
    if (const std::string_view ending = name.substr(at + 1); !only_resembles(ending))
      if (const Kind* found = named(ending)) return &planned(*found);
  return nullptr;
}

const Kind& KindTable::get(std::string_view name) const {
  static const Kind unknown;
  if (const Kind* found = find(name)) return *found;
  const Kind* stand_in = stand_ins_.empty() ? nullptr : stand_in_for(*this, name);
  return stand_in ? *stand_in : unknown;
}

bool KindTable::is_a(std::string_view name, std::string_view kind) const {
  const Kind* wanted = find(kind);
  return wanted ? is_of(get(name), wanted->name) : words(name) == words(kind);
}

// The name is looked up once: one that no kind is called by is looked for in all of WordNet.
bool KindTable::is_any_of(std::string_view name, const std::vector<std::string>& kinds) const {
  if (kinds.empty()) return false;
  const Kind& own = get(name);
  return std::any_of(kinds.begin(), kinds.end(), [&](const std::string& kind) {
    const Kind* wanted = find(kind);
    return wanted ? is_of(own, wanted->name) : words(name) == words(kind);
  });
}

}  // namespace roomgen
