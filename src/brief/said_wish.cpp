#include "said_wish.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "brief_form.h"
#include "dwelling_kinds.h"
#include "picture_text.h"
#include "prompt.h"
#include "prompt_passes.h"
#include "room_type.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t most_rooms = 12;

void take(std::vector<std::string>& from, std::vector<std::string>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

std::string name_of(const SaidRoom& room, const SaidDwelling& dwelling) {
  return room.type + " " + std::to_string(&room - dwelling.rooms.data() + 1);
}

// A room's own brief among those of the others.
void add_room(Json& form, const SaidDwelling& dwelling, const SaidRoom& room, const Json& brief) {
  Json own = {{"name", name_of(room, dwelling)},
              {"only_from",
               room.owner == SaidRoom::none ? "" : name_of(dwelling.rooms[room.owner], dwelling)},
              {"lies", Json::array()}};
  for (const auto& [key, value] : brief.items())
    if (key != "format" && key != "version" && key != "rooms") own[key] = value;
  form["rooms"].push_back(std::move(own));
}

/// Several rooms of a form, each with what is said of it.
class RoomsReader {
 public:
  RoomsReader(const Json& json, const RoomKinds& kinds, const KindTable& table, WishReading& result)
      : root_{&json, ""}, kinds_(kinds), table_(table), result_(result) {}

  void read() {
    SaidDwelling dwelling;
    dwelling.tokens = result_.wish.brief.tokens;
    const auto nodes = root_["rooms"].elements(most_rooms);
    for (const auto& node : nodes) read_room(node, dwelling);
    for (std::size_t i = 0; i < dwelling.rooms.size(); ++i) {
      SaidRoom& room = dwelling.rooms[i];
      room.owner = room_called(nodes[i]["only_from"].text(), i);
      add_room(result_.wish.form, dwelling, room, to_json(room.brief, result_.wish.prompt));
      conclude(room.brief, kinds_, table_);
    }
    // What is said of the whole: styles are those of each room.
    const Brief& whole = result_.wish.brief;
    for (const auto& words : whole.heard)
      dwelling.heard.push_back(
          {words.tokens, words.as, words.as == Heard::As::style ? "" : words.word});
    dwelling.area = whole.area;
    if (!dwelling.area && whole.size) dwelling.area = whole.size->prod();
    result_.wish.dwelling = std::move(dwelling);
  }

 private:
  void read_room(const FormNode& node, SaidDwelling& dwelling) {
    BriefReading reading =
        brief_from_json(*node.json, result_.wish.prompt, kinds_, table_, node.pointer);
    take(reading.problems, result_.problems);
    take(reading.repairs, result_.repairs);
    Brief& own = reading.brief;
    for (const auto& style : result_.wish.brief.styles) own.styles.push_back(style);
    // Words of other rooms are theirs; how rooms lie is heard, and nothing judges it.
    for (const auto& words : own.heard)
      if (words.as == Heard::As::room && words.word == "kind")
        dwelling.heard.push_back({words.tokens, Heard::As::room, own.type});
    hear_lies(node, own);
    SaidRoom room;
    room.type = own.type.empty() ? default_room_type : own.type;
    names_.push_back(lower(node["name"].text()));
    room.brief = std::move(own);
    dwelling.rooms.push_back(std::move(room));
  }

  void hear_lies(const FormNode& node, Brief& own) {
    BriefReading ways;
    ways.brief.tokens = own.tokens;
    Form form(node, {result_.wish.prompt, kinds_, table_}, ways);
    for (const auto& lie : node["lies"].elements(most_rooms))
      for (const std::size_t heard : form.hear(lie["words"], Heard::As::room, said_remark, 0))
        hear(own, ways.brief.heard[heard].tokens, Heard::As::room, said_remark);
    take(ways.problems, result_.problems);
  }

  std::size_t room_called(const std::string& name, std::size_t but) const {
    const auto found = std::find(names_.begin(), names_.end(), lower(name));
    const auto index = static_cast<std::size_t>(found - names_.begin());
    return name.empty() || found == names_.end() || index == but ? SaidRoom::none : index;
  }

  const FormNode root_;
  const RoomKinds& kinds_;
  const KindTable& table_;
  WishReading& result_;
  std::vector<std::string> names_;
};

}  // namespace

const SaidWish* reading_of(const PlanRequest& request) {
  return request.said && request.said->prompt == request.prompt ? request.said.get() : nullptr;
}

Brief brief_of(const PlanRequest& request, const RoomKinds& kinds, const KindTable& table) {
  const SaidWish* said = reading_of(request);
  return said ? said->brief : read_prompt(request.prompt, kinds, table);
}

SaidWish wish_by_rules(const std::string& prompt, const RoomKinds& kinds, const KindTable& table) {
  SaidWish wish{prompt, read_words(prompt, kinds, table)};
  if (const auto& dwellings = built_in_dwelling_kinds())
    wish.dwelling = read_dwelling(prompt, *dwellings, kinds, table);
  wish.form = to_json(wish.dwelling ? Brief() : wish.brief, prompt);
  if (wish.dwelling)
    for (auto& room : wish.dwelling->rooms) {
      add_room(wish.form, *wish.dwelling, room, to_json(room.brief, prompt));
      conclude(room.brief, kinds, table);
    }
  conclude(wish.brief, kinds, table);
  return wish;
}

WishReading wish_from_json(const Json& json, const std::string& prompt, const RoomKinds& kinds,
                           const KindTable& table) {
  BriefReading whole = brief_from_json(json, prompt, kinds, table);
  WishReading result{
      {prompt, std::move(whole.brief)}, std::move(whole.problems), std::move(whole.repairs)};
  const std::size_t rooms = FormNode{&json, ""}["rooms"].elements(most_rooms).size();
  result.wish.is_by_model = true;
  result.wish.form = to_json(result.wish.brief, prompt);
  if (rooms > 1)
    RoomsReader(json, kinds, table, result).read();
  else if (rooms == 1 && result.wish.brief.mentions.empty()) {
    WishReading alone = wish_from_json(*FormNode{&json, ""}["rooms"].elements(1).front().json,
                                       prompt, kinds, table);
    if (!alone.is_empty) return alone;
  }
  name_pictures(result.wish.form, prompt, result.wish.brief.tokens);
  result.is_empty = !result.wish.dwelling && !result.wish.brief.understood;
  conclude(result.wish.brief, kinds, table);
  return result;
}

}  // namespace roomgen::brief
