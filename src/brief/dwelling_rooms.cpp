#include <algorithm>
#include <map>
#include <optional>

#include "dwelling_reading.h"
#include "roomgen/scene/scene.h"

namespace roomgen::brief {

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// Not "a kitchen corner" or "a bedroom set": a name goes on with what is no part of it.
bool is_whole(const DwellingText& text, const std::vector<NamedRoom>& names,
              const NamedRoom& named) {
  if (text.ends_phrase(named.end)) return true;
  const Token& next = text.tokens[named.end];
  if (text.words.room_parts.count(next.text)) return false;
  const bool name_follows = std::any_of(names.begin(), names.end(), [&](const NamedRoom& other) {
    return other.noun == named.end;
  });
  return text.words.stops.count(next.text) || name_follows ||
         longest(text.dwellings.links, text.tokens, named.end, 2) ||
         text.words.definite.count(next.text) || next.is_word("each") || next.is_word("plus");
}

class RoomFinder {
 public:
  RoomFinder(const DwellingText& text, std::vector<NamedRoom>& names,
             std::vector<std::string>& notes)
      : text_(text), names_(names), notes_(notes), whole_(whole_dwelling(text, names)) {}

  std::vector<FoundRoom> run() {
    introduce();
    if (rooms_.size() < 2 && (!whole_ || rooms_.empty())) return {};
    if (whole_) add_usual_rooms(*whole_);
    bound_rooms();
    return std::move(rooms_);
  }

 private:
  void introduce() {
    for (auto& named : names_) {
      if (named.type.empty()) continue;
      const auto known = rooms_of_type(rooms_, named.type);
      if (named.definite || (named.ordinal > 0 && !known.empty())) {
        if (named.every) named.rooms = known;
        else if (!known.empty()) named.rooms = {known[std::min(named.ordinal, known.size() - 1)]};
        continue;
      }
      if (const auto elaborated = counted_before(named, known)) {
        named.rooms = {*elaborated};
        continue;
      }
      const bool told = is_first(named) || (known.empty() && is_bare_in_list(named)) || named.numbered || is_plural(named) || whole_;
      if (!told || !is_whole(text_, names_, named) || !is_linked(named)) continue;
      for (int n = 0; n < named.count; ++n) add_room(named);
    }
  }

  // "a two-bedroom flat: a bedroom with a double bed, a bedroom with a cot": those that the dwelling's name has counted, one
  // after the other.
  std::optional<std::size_t> counted_before(const NamedRoom& named, const std::vector<std::size_t>& known) {
    if (named.count != 1 || is_plural(named)) return std::nullopt;
    for (const NamedRoom& other : names_) {
      if (&other == &named) return std::nullopt;
      const bool is_of_whole = other.type == named.type && whole_ && other.end == whole_->noun;
      if (!is_of_whole || !other.numbered) continue;
      const auto next = static_cast<std::size_t>(elaborated_[named.type]++);
      return next < known.size() && next < static_cast<std::size_t>(other.count) ? std::optional(known[next]) : std::nullopt;
    }
    return std::nullopt;
  }
  // "hall with hooks, kitchen with a table, living room": no article is needed in a list.
  bool is_bare_in_list(const NamedRoom& named) const {
    if (named.begin != named.noun || named.begin == 0 || !is_whole(text_, names_, named)) return false;
    const auto kind = text_.tokens[named.begin - 1].kind;
    return kind == Token::Kind::comma || kind == Token::Kind::stop;
  }

  // "with a", ", a", "leading to two": how a further room is named.
  bool is_linked(const NamedRoom& named) const {
    const auto& links = text_.dwellings.links;
    std::size_t at = named.begin;
    // "a modern three-bedroom house"
    while (at > 0 && named.begin - at < longest_phrase &&
           text_.tokens[at - 1].kind == Token::Kind::word &&
           !text_.words.stops.count(text_.tokens[at - 1].text) &&
           !links.count(text_.tokens[at - 1].text))
      --at;
    if (at == 0 || text_.ends_phrase(at - 1)) return true;
    for (std::size_t n = 1; n <= 2 && n <= at; ++n)
      if (const auto link = longest(links, text_.tokens, at - n, n); link.length == n) return true;
    return false;
  }

  bool is_first(const NamedRoom& named) const {
    return std::none_of(names_.begin(), names_.end(), [&](const NamedRoom& other) {
      return !other.type.empty() && other.noun < named.noun;
    });
  }

  bool is_plural(const NamedRoom& named) const {
    const std::string& last = text_.tokens[named.end - 1].text;
    return !text_.rooms.count(last) && last.ends_with('s');
  }

  void add_room(NamedRoom& named) {
    const auto owners = owners_of(named);
    // Each of two bedrooms has its own.
    const std::size_t copies = std::max<std::size_t>(1, owners.size());
    for (std::size_t n = 0; n < copies; ++n) {
      named.rooms.push_back(rooms_.size());
      FoundRoom room;
      room.type = named.type;
      if (!owners.empty()) room.owner = owners[n];
      room.introduced = named.end;
      room.adjectives = adjectives(named);
      rooms_.push_back(room);
    }
  }

  // "a bedroom with an en-suite bathroom and a closet": the room before "with", if it may have one
  // of its own.
  std::vector<std::size_t> owners_of(const NamedRoom& named) const {
    const auto& kinds = text_.dwellings.rooms;
    const auto self = static_cast<std::size_t>(&named - names_.data());
    for (std::size_t k = self; k-- > 0;) {
      const NamedRoom& other = names_[k];
      if (other.type.empty() || other.rooms.empty() ||
          ends_sentence_between(other.end, named.begin))
        break;
      const auto kind = kinds.find(other.type);
      const bool may = kind != kinds.end() && is_in(kind->second.owns, named.type);
      std::size_t link = other.end;
      if (text_.is_word(link, "each")) ++link;
      if (may && (text_.is_word(link, "with") || text_.is_word(link, "has") || named.en_suite))
        return other.rooms;
      if (!rooms_.empty() && rooms_[other.rooms[0]].owner == SaidRoom::none && !may) break;
    }
    if (!named.en_suite) return {};
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (is_in(kinds.at(rooms_[i].type).owns, named.type)) return {i};
    return {};
  }

  bool ends_sentence_between(std::size_t from, std::size_t to) const {
    for (std::size_t i = from; i < to; ++i)
      if (text_.tokens[i].kind == Token::Kind::stop) return true;
    return false;
  }

  std::string adjectives(const NamedRoom& named) const {
    std::string list;
    for (std::size_t i = named.begin; i < named.noun; ++i) {
      const Token& token = text_.tokens[i];
      if (token.kind != Token::Kind::word || text_.words.numbers.count(token.text) ||
          text_.words.definite.count(token.text) || token.is_word("separate") ||
          token.is_word("private"))
        continue;
      list += token.text + " ";
    }
    return list;
  }

  // "without a bathroom" too
  bool is_spoken_of(const std::string& type) const {
    return std::any_of(names_.begin(), names_.end(), [&](const NamedRoom& name) { return name.type == type; });
  }

  // "A two-bedroom apartment" says nothing of its kitchen, which it has all the same.
  void add_usual_rooms(const NamedRoom& whole) {
    // Who names the room where people meet, or two that it may be, or a kitchen and a bathroom, has named all that there
    // shall be, but for what none can lack: "an open kitchen" alone leaves the living room to be added.
    const auto named_with = [&](int hub) {
      return std::count_if(rooms_.begin(), rooms_.end(), [&](const FoundRoom& room) {
        return text_.dwellings.rooms.at(room.type).hub >= hub;
      });
    };
    const bool has_all_needed = std::all_of(text_.dwellings.never_without.begin(), text_.dwellings.never_without.end(),
                                            [&](const std::string& type) { return !rooms_of_type(rooms_, type).empty(); });
    const bool is_whole = named_with(2) > 0 || named_with(1) > 1 || (named_with(1) > 0 && has_all_needed);
    if (is_whole && rooms_.size() < 2) return;  // "an apartment living room"
    const auto& usual = text_.dwellings.dwellings.at(text_.tokens[whole.noun].text);
    const std::size_t before = rooms_.size();
    for (const auto& type : is_whole ? text_.dwellings.never_without : usual) {
      if (!rooms_of_type(rooms_, type).empty() || is_spoken_of(type)) continue;
      FoundRoom room;
      room.type = type;
      room.introduced = text_.tokens.size();
      rooms_.push_back(room);
      if (is_whole) notes_.push_back("a " + type + " was added, which a dwelling cannot lack");
    }
    if (!is_whole && rooms_.size() > before) notes_.push_back("rooms that such a dwelling usually has were added");
  }

  void bound_rooms() {
    // So many need a hallway, which is one of them.
    const auto hallways = rooms_of_type(rooms_, "hallway");
    const std::size_t most = max_rooms - (hallways.empty() || hallways.front() >= max_rooms ? 1 : 0);
    if (rooms_.size() <= most) return;
    notes_.push_back("the prompt asks for " + std::to_string(rooms_.size()) + " rooms; " +
                     std::to_string(most) + " are made");
    rooms_.resize(most);
    for (auto& room : rooms_)
      if (room.owner != SaidRoom::none && room.owner >= most) room.owner = SaidRoom::none;
    for (auto& named : names_)
      std::erase_if(named.rooms, [&](std::size_t room) { return room >= most; });
  }

  const DwellingText& text_;
  std::vector<NamedRoom>& names_;
  std::vector<std::string>& notes_;
  const NamedRoom* const whole_;  ///< "a two-bedroom flat"; null if none is named
  std::vector<FoundRoom> rooms_;
  std::map<std::string, int> elaborated_;  ///< how many of a type that was counted were told of, by type
};

}  // namespace

std::vector<std::size_t> rooms_of_type(const std::vector<FoundRoom>& rooms,
                                       const std::string& type) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (rooms[i].type == type) found.push_back(i);
  return found;
}

const NamedRoom* whole_dwelling(const DwellingText& text, const std::vector<NamedRoom>& names) {
  for (const auto& named : names) {
    if (!named.type.empty() || named.definite || !is_whole(text, names, named)) continue;
    // "a room of an apartment" is one room.
    const std::size_t before = named.begin - 1;
    if (named.begin == 0 || !(text.is_word(before, "in") || text.is_word(before, "of") ||
                              text.is_word(before, "for")))
      return &named;
  }
  return nullptr;
}

std::vector<FoundRoom> find_rooms(const DwellingText& text, std::vector<NamedRoom>& names,
                                  std::vector<std::string>& notes) {
  return RoomFinder(text, names, notes).run();
}

}  // namespace roomgen::brief
