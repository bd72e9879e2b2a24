#include "roomgen/lab/scores.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "csv.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

constexpr int max_quantity = 10000;
// Of one field, in bytes, and of a whole table.
constexpr std::size_t most_of_field = 2000, longest_requirement = 500, most_in_all = 200'000;

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size() || value > max_quantity)
    return std::nullopt;
  return value;
}

std::optional<Wanted::Comparison> comparison(std::string_view text) {
  static const std::map<std::string_view, Wanted::Comparison> known = {
      {"eq", Wanted::Comparison::eq}, {"lt", Wanted::Comparison::lt},
      {"gt", Wanted::Comparison::gt}, {"le", Wanted::Comparison::le},
      {"ge", Wanted::Comparison::ge}};
  const auto found = known.find(text);
  if (found == known.end()) return std::nullopt;
  return found->second;
}

// "chair:2" is the third of the chairs.
std::string without_number(const std::string& thing) { return thing.substr(0, thing.find(':')); }

// Reads the requirements of one field, each "comparison,quantity,…".
class FieldReader {
 public:
  FieldReader(std::string where, std::string_view field) : where_(std::move(where)) {
    // A field of a million semicolons is not taken apart first.
    is_too_long_ = static_cast<std::size_t>(std::count(field.begin(), field.end(), ';')) > most_of_field;
    if (is_too_long_) return;
    for (auto& piece : split(field, ';'))
      if (!piece.empty()) specs_.push_back(std::move(piece));
  }

  /// `take` gets the text, the wanted count and what follows them, at least `least` pieces.
  template <typename Take>
  Status each(std::size_t least, Take take) const {
    if (is_too_long_)
      return Error{Error::Kind::limit, where_ + ": has more than " + std::to_string(most_of_field) + " requirements"};
    for (const auto& text : specs_) {
      if (text.size() > longest_requirement) return error(shortened(text, 60) + "...", "is too long");
      auto pieces = split(text, ',');
      Wanted wanted;
      if (auto status = read_wanted(text, pieces, wanted); !status) return status;
      if (pieces.size() < least ||
          std::any_of(pieces.begin(), pieces.end(), [](const auto& p) { return p.empty(); }))
        return error(text, "expected more after the quantity");
      if (auto status = take(text, wanted, pieces); !status) return status;
    }
    return {};
  }

  Error error(const std::string& text, const std::string& what) const {
    return {Error::Kind::invalid_input, where_ + ": \"" + text + "\": " + what};
  }

 private:
  // Takes the comparison and the quantity off the front; "eq1,chair" is "eq,1,chair".
  Status read_wanted(const std::string& text, std::vector<std::string>& pieces,
                     Wanted& wanted) const {
    const std::string head = lower(pieces.front());
    const auto digits = head.find_first_of("0123456789");
    std::string quantity;
    std::size_t used = 1;
    if (digits != std::string::npos) quantity = head.substr(digits);
    else if (pieces.size() > 1) quantity = pieces[used++];
    const auto how = comparison(trim(head.substr(0, digits)));
    if (!how) return error(text, "expected eq, lt, gt, le or ge first");
    const auto number = whole_number(quantity);
    if (!number || *number < 0) return error(text, "expected a quantity after the comparison");
    wanted = {*how, *number};
    pieces.erase(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(used));
    return {};
  }

  std::string where_;
  std::vector<std::string> specs_;
  bool is_too_long_ = false;
};

using Pieces = std::vector<std::string>;

class RowReader {
 public:
  RowReader(const std::map<std::string, std::size_t>& columns, const CsvRecord& record,
            const std::string& source)
      : columns_(columns), record_(record), source_(source) {}

  std::string field(const std::string& column) const {
    const auto found = columns_.find(column);
    return found == columns_.end() || found->second >= record_.fields.size()
               ? std::string()
               : record_.fields[found->second];
  }

  Result<Requirements> read() const {
    Requirements row;
    row.id = trim(field("ID"));
    row.description = field("Description");
    row.difficulty = lower(trim(field("Difficulty")));
    for (const auto& status :
         {read_counts(row), read_attributes(row), read_object_relations(row), read_room_relations(row)})
      if (!status) return status.error();
    return row;
  }

 private:
  FieldReader reader(const std::string& column) const {
    return {source_ + ":" + std::to_string(record_.line) + ": " + column, field(column)};
  }

  Status read_counts(Requirements& row) const {
    return reader("ObjCount").each(1, [&](const auto& text, const Wanted& wanted, const Pieces& p) {
      row.counts.push_back({text, wanted, p[0]});
      return Status();
    });
  }

  Status read_attributes(Requirements& row) const {
    return reader("ObjAttr").each(2, [&](const auto& text, const Wanted& wanted, const Pieces& p) {
      row.attributes.push_back({text, wanted, p[0], {p.begin() + 1, p.end()}});
      return Status();
    });
  }

  Status read_object_relations(Requirements& row) const {
    const auto fields = reader("OORel");
    return fields.each(4, [&](const auto& text, const Wanted& wanted, const Pieces& p) -> Status {
      ObjectRelationRequirement relation{text, wanted, lower(p[0]), 0, {}};
      const auto anchor = whole_number(p[1]);
      if (!anchor) return fields.error(text, "expected the anchor's index after the relation");
      relation.anchor = *anchor;
      for (std::size_t i = 2; i < p.size(); ++i) relation.things.push_back(without_number(p[i]));
      row.object_relations.push_back(std::move(relation));
      return {};
    });
  }

  Status read_room_relations(Requirements& row) const {
    return reader("OARel").each(3, [&](const auto& text, const Wanted& wanted, const Pieces& p) {
      row.room_relations.push_back(
          {text, wanted, lower(p[0]), without_number(p[1]), {p.begin() + 2, p.end()}});
      return Status();
    });
  }

  const std::map<std::string, std::size_t>& columns_;
  const CsvRecord& record_;
  const std::string& source_;
};

}  // namespace

bool Wanted::holds(int count) const {
  switch (comparison) {
    case Comparison::eq: return count == quantity;
    case Comparison::lt: return count < quantity;
    case Comparison::gt: return count > quantity;
    case Comparison::le: return count <= quantity;
    case Comparison::ge: return count >= quantity;
  }
  return false;
}

std::vector<std::string> Requirements::categories() const {
  std::vector<std::string> all;
  const auto add = [&](const std::string& category) {
    if (std::find(all.begin(), all.end(), category) == all.end()) all.push_back(category);
  };
  for (const auto& count : counts) add(count.category);
  for (const auto& attribute : attributes) add(attribute.category);
  for (const auto& relation : object_relations)
    for (const auto& thing : relation.things) add(thing);
  for (const auto& relation : room_relations) add(relation.thing);
  return all;
}

Result<std::vector<Requirements>> parse_requirements(std::string_view text,
                                                     const std::string& source) {
  const auto records = parse_csv(text, source);
  if (!records) return records.error();
  if (records->empty()) return Error{Error::Kind::invalid_input, source + ": is empty"};
  std::map<std::string, std::size_t> columns;
  const auto& head = records->front().fields;
  for (std::size_t i = 0; i < head.size(); ++i) columns[std::string(trim(head[i]))] = i;
  for (const auto* needed : {"ID", "Description", "ObjCount"})
    if (!columns.count(needed))
      return Error{Error::Kind::invalid_input,
                   source + ":1: no column \"" + needed + "\" in the head line"};
  std::vector<Requirements> rows;
  std::size_t in_all = 0;
  for (std::size_t i = 1; i < records->size(); ++i) {
    auto row = RowReader(columns, (*records)[i], source).read();
    if (!row) return row.error();
    in_all += row->counts.size() + row->attributes.size() + row->object_relations.size() + row->room_relations.size();
    if (in_all > most_in_all)
      return Error{Error::Kind::limit, source + ":" + std::to_string((*records)[i].line) + ": is beyond the " +
                                           std::to_string(most_in_all) + " requirements that are read"};
    rows.push_back(*std::move(row));
  }
  return rows;
}

}  // namespace roomgen::lab
