#include "room_kinds.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "dwelling_kinds.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::brief {

namespace {

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(500)) texts.push_back(element.text());
  return texts;
}

Range read_range(const JsonReader& json, Range fallback, double high) {
  if (!json.exists()) return fallback;
  const auto v = json.numbers(2, 0.0, high);
  if (v[0] > v[1]) json.report("the first number must not be larger than the second");
  return {v[0], v[1]};
}

void read_count(const JsonReader& json, int& low, int& high) {
  if (!json.exists()) return;
  const Range range = read_range(json, {}, 50);
  low = static_cast<int>(range.low);
  high = static_cast<int>(range.high);
}

Weighted read_weighted(const JsonReader& json) {
  Weighted words;
  if (!json.exists()) return words;
  for (const auto& [word, weight] : json.members())
    words.emplace_back(word, weight.number(0, 1000));
  return words;
}

std::optional<Vec3> read_size(const JsonReader& json) {
  if (!json.exists()) return std::nullopt;
  const auto v = json.numbers(3, 0.001, 20.0);
  return Vec3(v[0], v[1], v[2]);
}

std::vector<Piece> read_pieces(const JsonReader& json);

Piece read_piece(const JsonReader& json) {
  json.allow_only({"kind", "any", "of", "size", "count", "people", "for people", "chance", "weight", "area",
                   "each", "shared", "needs", "for", "unless", "then"});
  Piece piece;
  piece.any = read_weighted(json["any"]);
  if (const auto kind = json["kind"]; kind.exists()) piece.any = {{kind.text(), 1.0}};
  if (piece.any.empty()) json.report("a piece needs \"kind\" or \"any\"");
  piece.of = read_weighted(json["of"]);
  piece.size = read_size(json["size"]);
  read_count(json["count"], piece.low, piece.high);
  piece.people = json["people"].boolean_or(false);
  piece.for_people = static_cast<int>(json["for people"].integer_or(0, 0, 100));
  piece.chance = json["chance"].number_or(1.0, 0, 1);
  piece.weight = json["weight"].number_or(1.0, 0, 1000);
  piece.area = json["area"].number_or(0.0, 0, 1000);
  piece.each = json["each"].text_or("");
  piece.shared = json["shared"].boolean_or(false);
  piece.needs = json["needs"].text_or("");
  piece.serves = json["for"].text_or("");
  piece.unless = read_texts(json["unless"]);
  piece.then = read_pieces(json["then"]);
  return piece;
}

std::vector<Piece> read_pieces(const JsonReader& json) {
  std::vector<Piece> pieces;
  for (const auto& element : json.elements_or_none(100)) pieces.push_back(read_piece(element));
  return pieces;
}

DoorSwing read_swing(const JsonReader& json) {
  const std::string text = json.text_or("in");
  for (auto swing : {DoorSwing::in, DoorSwing::out, DoorSwing::sliding})
    if (text == name(swing)) return swing;
  json.report("\"" + text + "\" is none of in, out, sliding");
  return DoorSwing::in;
}

WindowHabit read_windows(const JsonReader& json) {
  WindowHabit habit;
  if (!json.exists()) return habit;
  json.allow_only({"count", "width", "sill", "head"});
  read_count(json["count"], habit.low, habit.high);
  habit.width = read_range(json["width"], habit.width, 5.0);
  habit.sill = json["sill"].number_or(habit.sill, 0, 3);
  habit.head = json["head"].number_or(habit.head, 0.5, 4);
  return habit;
}

RoomKind read_room_kind(const JsonReader& json, const std::string& type) {
  json.allow_only({"names", "leading", "alone",    "known_by", "made_by",   "width",
                   "depth", "height",  "smallest", "share",    "objects",   "windows",
                   "door",  "door_on", "swing",    "floors",   "walls",     "means",
                   "core",  "extras",  "details",  "for",      "instead_of"});
  RoomKind kind;
  kind.type = type;
  kind.names = read_texts(json["names"]);
  kind.leading = read_texts(json["leading"]);
  kind.alone = read_texts(json["alone"]);
  if (json["known_by"].exists()) kind.known_by = read_texts(json["known_by"]);
  kind.purposes = read_texts(json["for"]);
  kind.instead_of = read_texts(json["instead_of"]);
  kind.made_by = read_texts(json["made_by"]);
  kind.width = read_range(json["width"], {4.0, 5.0}, 20.0);
  kind.depth = read_range(json["depth"], {3.5, 4.5}, 20.0);
  kind.height = json["height"].number_or(kind.height, 1.0, 10.0);
  kind.smallest = json["smallest"].number_or(kind.smallest, 0.5, 10.0);
  kind.share = read_range(json["share"], {0.2, 0.32}, 0.9);
  read_count(json["objects"], kind.objects_low, kind.objects_high);
  kind.windows = read_windows(json["windows"]);
  kind.door = json["door"].number_or(kind.door, 0.5, 4.0);
  kind.door_on_long_side = json["door_on"].text_or("") == "long side";
  kind.swing = read_swing(json["swing"]);
  kind.floors = read_texts(json["floors"]);
  kind.walls = read_texts(json["walls"]);
  if (const auto means = json["means"]; means.exists())
    for (const auto& [word, category] : means.members()) kind.means[word] = category.text();
  kind.core = read_pieces(json["core"]);
  kind.extras = read_pieces(json["extras"]);
  kind.details = read_pieces(json["details"]);
  return kind;
}

Style read_style(const JsonReader& json) {
  json.allow_only({"adjective", "more", "fewer", "fullness", "size", "windows"});
  Style style;
  style.adjective = json["adjective"].text_or("");
  style.more = read_texts(json["more"]);
  style.fewer = read_texts(json["fewer"]);
  style.fullness = json["fullness"].number_or(1.0, 0.1, 5.0);
  style.size = json["size"].number_or(1.0, 0.3, 3.0);
  style.windows = static_cast<int>(json["windows"].integer_or(0, 0, 3));
  return style;
}

Variant read_variant(const JsonReader& json) {
  json.allow_only({"size", "scale"});
  Variant variant;
  variant.size = read_size(json["size"]);
  if (const auto scale = read_size(json["scale"])) variant.scale = *scale;
  return variant;
}

}  // namespace

const RoomKind& RoomKinds::get(std::string_view type) const {
  const auto found = types.find(type);
  return found == types.end() ? any : found->second;
}

const Style* RoomKinds::style(std::string_view word) const {
  const auto other = style_words.find(word);
  const auto found = styles.find(other == style_words.end() ? std::string(word) : other->second);
  return found == styles.end() ? nullptr : &found->second;
}

Result<RoomKinds> parse_room_kinds(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "types", "any room", "variants", "finishes", "styles", "style_words"});
  RoomKinds kinds;
  for (const auto& [type, entry] : root["types"].members())
    kinds.types[type] = read_room_kind(entry, type);
  kinds.any = read_room_kind(root["any room"], "");
  for (const auto& [variant, entry] : root["variants"].members())
    kinds.variants[variant] = read_variant(entry);
  for (const auto& entry : root["finishes"].elements_or_none(100))
    kinds.finishes.push_back({read_texts(entry["kinds"]), read_texts(entry["words"])});
  for (const auto& [word, entry] : root["styles"].members()) kinds.styles[word] = read_style(entry);
  for (const auto& [word, style] : root["style_words"].members())
    kinds.style_words[word] = style.text();
  if (problems.first()) return *problems.first();
  return kinds;
}

RoomNames all_room_names(const RoomKinds& kinds) {
  RoomNames names = room_names(kinds);
  for (const auto& [type, kind] : kinds.types)
    for (const auto& name : kind.leading) names.try_emplace(join(words(name), " "), type);
  return names;
}

std::string room_name(std::string_view said) {
  std::vector<std::string> pieces;
  for (auto piece : words(said)) {
    if (piece.ends_with("'s")) piece.resize(piece.size() - 2);
    std::erase(piece, '\'');
    if (!piece.empty() && piece != "s") pieces.push_back(std::move(piece));
  }
  return join(pieces, " ");
}

std::vector<std::string> rooms_of_design(std::string_view text) {
  const std::size_t key = text.find("\"for\""), open = text.find('[', key),
                    close = text.find(']', open);
  if (key == std::string_view::npos || close == std::string_view::npos) return {};
  const auto list = parse_json(text.substr(open, close - open + 1), "for");
  std::vector<std::string> rooms;
  for (const auto& one : list ? *list : Json::array())
    if (one.is_string()) rooms.push_back(room_name(one.get<std::string>()));
  return rooms;
}

namespace {

constexpr std::size_t most_words_of_name = 3;  // as many as are read

// "kids room with bunk bed" and "room" name no kind of their own, a kitchen island is a thing, an
// apartment has several rooms.
bool is_name_of_room(const std::string& name) {
  const auto pieces = words(name);
  if (pieces.empty() || (pieces.size() > 1 && KindTable::built_in().by_name(name))) return false;
  const auto& dwellings = built_in_dwelling_kinds();
  if (dwellings && dwellings->dwellings.count(pieces.back())) return false;
  const auto is_joint = [](const std::string& word) {
    return word == "with" || word == "for" || word == "and" || word == "of" || word == "in";
  };
  return name != "room" && pieces.size() <= most_words_of_name &&
         std::none_of(pieces.begin(), pieces.end(), is_joint);
}

// A bar, a toilet or a reading corner may be a thing or a part of a room.
bool is_also_no_room(const std::string& name) {
  return KindTable::built_in().by_name(name) || name.ends_with(" corner") ||
         name.ends_with(" area") || name.ends_with(" bar");
}

// A kind that only the book knows is like the one that it is a sort of: a sushi bar is a bar.
RoomKind kind_of_book(const std::string& name, const RoomNames& names, const RoomKinds& kinds) {
  RoomKind kind = kinds.any;
  for (std::size_t space = name.find(' '); space != std::string::npos;
       space = name.find(' ', space + 1))
    if (const auto known = names.find(name.substr(space + 1)); known != names.end()) {
      kind = kinds.get(known->second);
      break;
    }
  for (auto* list : {&kind.names, &kind.leading, &kind.alone, &kind.purposes, &kind.instead_of})
    list->clear();
  kind.known_by.emplace();
  kind.type = name;
  return kind;
}

// `names`: of all kinds, as they are known so far.
void add_rooms_of_design(std::vector<std::string> rooms, RoomNames& names, RoomKinds& kinds) {
  std::erase_if(rooms, [](const std::string& name) { return !is_name_of_room(name); });
  if (rooms.empty()) return;
  const auto first = names.find(rooms.front());
  const std::string type = first == names.end() ? rooms.front() : first->second;
  if (first == names.end()) kinds.types[type] = kind_of_book(type, names, kinds);
  RoomKind& kind = kinds.types[type];
  for (const auto& name : rooms) {
    if (!names.try_emplace(name, type).second) continue;
    if (is_also_no_room(name))
      kind.leading.push_back(name);
    else if (name != type)
      kind.names.push_back(name);
    // A crypt is one wherever it is named, a piano bank is none.
    if (name.find(' ') == std::string::npos) kind.alone.push_back(name);
  }
}

}  // namespace

const Result<RoomKinds>& built_in_room_kinds() {
  static const auto kinds = []() -> Result<RoomKinds> {
    auto all = parse_room_kinds(resource("data/rooms.json").value_or("{}"), "data/rooms.json");
    if (!all) return all;
    RoomNames names = all_room_names(*all);
    for (const auto path : resources("data/designs/"))
      add_rooms_of_design(rooms_of_design(*resource(path)), names, *all);
    return all;
  }();
  return kinds;
}

}  // namespace roomgen::brief
