#include "dwelling_prompt.h"

#include <algorithm>

#include "kind_names.h"
#include "measures.h"
#include "room_type.h"
#include "roomgen/base/text.h"
#include "roomgen/design/tokens.h"
#include "roomgen/scene/scene.h"

namespace roomgen::design {

namespace {

constexpr std::size_t longest_name = 3;
constexpr std::size_t longest_phrase = 6;  ///< words before the noun of a room
constexpr int most_of_a_kind = 8;

/// A room, or the dwelling as a whole, where the prompt names it.
struct Named {
  std::size_t begin = 0;  ///< of its phrase: "two large bedrooms"
  std::size_t noun = 0, end = 0;
  std::string type;       ///< empty: the dwelling
  int count = 1;
  bool numbered = false;  ///< "two", "a"
  bool definite = false;  ///< "the bedroom"
  bool every = false;     ///< "both bedrooms", "each bedroom"
  bool en_suite = false;
  std::size_t ordinal = 0;  ///< "the second bedroom": 1
  std::vector<std::size_t> rooms;  ///< that it means
};

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

class DwellingReader {
 public:
  DwellingReader(std::string_view prompt, const Vocabulary& words, const DwellingKinds& dwellings,
                 const RoomKinds& kinds, const CategoryTable& table)
      : tokens_(tokenize(prompt)),
        words_(words),
        dwellings_(dwellings),
        kinds_(kinds),
        table_(table),
        names_(table),
        room_names_(room_names(kinds)) {}

  std::optional<SaidDwelling> run() {
    find_names();
    introduce();
    if (!is_dwelling()) return std::nullopt;
    add_usual_rooms();
    bound_rooms();
    if (result_.rooms.size() < 2) return std::nullopt;
    read_total_area();
    collect_styles();
    share_clauses();
    write_prompts();
    return std::move(result_);
  }

 private:
  bool is_word(std::size_t i, std::string_view word) const {
    return i < tokens_.size() && tokens_[i].is_word(word);
  }
  bool ends_phrase(std::size_t i) const {
    return i >= tokens_.size() || tokens_[i].kind == Token::Kind::comma ||
           tokens_[i].kind == Token::Kind::stop;
  }

  // --- Names of rooms -------------------------------------------------------------------------

  // A room's name at i, in the singular or plural; its length, 0 if there is none.
  std::size_t room_at(std::size_t i, std::string& type) const {
    std::string phrase;
    std::size_t length = 0;
    for (std::size_t n = 0; n < longest_name && i + n < tokens_.size(); ++n) {
      if (tokens_[i + n].kind != Token::Kind::word) break;
      phrase += (n ? " " : "") + tokens_[i + n].text;
      for (const auto& name : singulars(phrase)) {
        const auto found = room_names_.find(name);
        if (found == room_names_.end() || dwellings_.no_rooms.count(name) ||
            !dwellings_.rooms.count(found->second))
          continue;
        type = found->second;
        length = n + 1;
        break;
      }
    }
    return names_.match(tokens_, i).length > length ? 0 : length;
  }

  void find_names() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != Token::Kind::word) continue;
      Named named;
      std::size_t length = room_at(i, named.type);
      const bool dwelling =
          length == 0 && dwellings_.dwellings.count(tokens_[i].text) && names_.match(tokens_, i).length == 0;
      if (dwelling) length = 1;
      if (length == 0) continue;
      named.noun = i;
      named.end = i + length;
      named.en_suite = is_word(i, "ensuite") || is_word(i + 1, "suite");
      // "en suite bathroom" is one room.
      std::string again;
      if (const std::size_t more = room_at(named.end, again); more > 0 && again == named.type)
        named.end += more;
      read_determiner(named);
      i = named.end - 1;
      named_.push_back(named);
    }
  }

  // Backwards from the noun: its adjectives, its number or article.
  void read_determiner(Named& named) {
    const std::size_t least = named_.empty() ? 0 : named_.back().end;
    std::size_t i = named.noun;
    while (i > least && named.noun - i < longest_phrase) {
      const Token& token = tokens_[i - 1];
      if (token.is_word("both") || token.is_word("each") || token.is_word("every") ||
          token.is_word("all"))
        named.every = named.definite = true;
      else if (words_.definite.count(token.text))
        named.definite = true;
      else if (token.kind == Token::Kind::number && token.value >= 1 && token.value <= most_of_a_kind)
        named.count = static_cast<int>(token.value), named.numbered = true;
      else if (const auto number = words_.numbers.find(token.text);
               token.kind == Token::Kind::word && number != words_.numbers.end() && number->second > 0)
        named.count = number->second, named.numbered = true;
      else if (token.kind != Token::Kind::word || words_.stops.count(token.text) ||
               words_.negations.count(token.text))
        break;
      else if (token.is_word("second") || token.is_word("other"))
        named.ordinal = 1;
      else if (token.is_word("third"))
        named.ordinal = 2;
      --i;
      if (named.numbered || (named.definite && !named.every)) break;
    }
    named.begin = i;
  }

  // --- Which rooms there are ------------------------------------------------------------------

  // "with a", ", a", "leading to two": how a further room is named.
  bool is_linked(const Named& named) const {
    std::size_t at = named.begin;
    // "a modern three-bedroom house"
    while (at > 0 && named.begin - at < longest_phrase && tokens_[at - 1].kind == Token::Kind::word &&
           !words_.stops.count(tokens_[at - 1].text) && !dwellings_.links.count(tokens_[at - 1].text))
      --at;
    if (at == 0 || ends_phrase(at - 1)) return true;
    for (std::size_t n = 1; n <= 2 && n <= at; ++n)
      if (const auto link = longest(dwellings_.links, tokens_, at - n, n); link.length == n)
        return true;
    return false;
  }

  // Not "a kitchen corner" or "a bedroom set": a name goes on with what is no part of it.
  bool is_whole(const Named& named) const {
    if (ends_phrase(named.end)) return true;
    if (words_.room_parts.count(tokens_[named.end].text)) return false;
    return words_.stops.count(tokens_[named.end].text) || starts_name(named.end) ||
           longest(dwellings_.links, tokens_, named.end, 2) || words_.definite.count(tokens_[named.end].text) ||
           tokens_[named.end].is_word("each") || tokens_[named.end].is_word("plus");
  }
  bool starts_name(std::size_t i) const {
    return std::any_of(named_.begin(), named_.end(), [&](const Named& n) { return n.noun == i; });
  }

  bool is_first(const Named& named) const {
    return std::none_of(named_.begin(), named_.end(), [&](const Named& other) {
      return !other.type.empty() && other.noun < named.noun;
    });
  }

  void introduce() {
    for (auto& named : named_) {
      if (named.type.empty()) continue;
      const auto known = rooms_of_type(named.type);
      if (named.definite || (named.ordinal > 0 && !known.empty())) {
        if (named.every) named.rooms = known;
        else if (!known.empty()) named.rooms = {known[std::min(named.ordinal, known.size() - 1)]};
        continue;
      }
      const bool leads = is_first(named);
      const bool told = leads || named.numbered || is_plural(named) || dwelling();
      if (!told || !is_whole(named) || !is_linked(named)) continue;
      for (int n = 0; n < std::min(named.count, most_of_a_kind); ++n) add_room(named);
    }
  }

  bool is_plural(const Named& named) const {
    const std::string& last = tokens_[named.end - 1].text;
    return !room_names_.count(last) && last.ends_with('s');
  }

  std::vector<std::size_t> rooms_of_type(const std::string& type) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < result_.rooms.size(); ++i)
      if (result_.rooms[i].type == type) found.push_back(i);
    return found;
  }

  void add_room(Named& named) {
    const auto owners = owners_of(named);
    // Each of two bedrooms has its own.
    const std::size_t copies = std::max<std::size_t>(1, owners.size());
    for (std::size_t n = 0; n < copies; ++n) {
      named.rooms.push_back(result_.rooms.size());
      SaidRoom room;
      room.type = named.type;
      if (!owners.empty()) room.owner = owners[n];
      result_.rooms.push_back(room);
      about_.emplace_back();
      introduced_.push_back(named.end);
      adjectives_.push_back(adjectives(named));
    }
  }

  // "a bedroom with an en-suite bathroom and a closet": the room before "with", if it may have one
  // of its own.
  std::vector<std::size_t> owners_of(const Named& named) const {
    const auto self = static_cast<std::size_t>(&named - named_.data());
    for (std::size_t k = self; k-- > 0;) {
      const Named& other = named_[k];
      if (other.type.empty() || other.rooms.empty() || ends_sentence_between(other.end, named.begin))
        break;
      const auto kind = dwellings_.rooms.find(other.type);
      const bool may = kind != dwellings_.rooms.end() && is_in(kind->second.owns, named.type);
      std::size_t link = other.end;
      if (is_word(link, "each")) ++link;
      if (may && (is_word(link, "with") || is_word(link, "has") || named.en_suite)) return other.rooms;
      if (!result_.rooms.empty() && result_.rooms[other.rooms[0]].owner == SaidRoom::none && !may) break;
    }
    if (!named.en_suite) return {};
    for (std::size_t i = 0; i < result_.rooms.size(); ++i)
      if (is_in(dwellings_.rooms.at(result_.rooms[i].type).owns, named.type)) return {i};
    return {};
  }

  bool ends_sentence_between(std::size_t from, std::size_t to) const {
    for (std::size_t i = from; i < to; ++i)
      if (tokens_[i].kind == Token::Kind::stop) return true;
    return false;
  }

  std::string adjectives(const Named& named) const {
    std::string text;
    for (std::size_t i = named.begin; i < named.noun; ++i) {
      const Token& token = tokens_[i];
      if (token.kind != Token::Kind::word || words_.numbers.count(token.text) ||
          words_.definite.count(token.text) || token.is_word("separate") || token.is_word("private"))
        continue;
      text += token.text + " ";
    }
    return text;
  }

  // The whole is named first, or two rooms are.
  const Named* dwelling() const {
    for (const auto& named : named_)
      if (named.type.empty() && !named.definite && is_whole(named) &&
          (named.begin == 0 || !(is_word(named.begin - 1, "in") || is_word(named.begin - 1, "of") ||
                                 is_word(named.begin - 1, "for"))))
        return &named;
    return nullptr;
  }

  bool is_dwelling() const {
    return result_.rooms.size() >= 2 || (dwelling() && !result_.rooms.empty());
  }

  // "A two-bedroom apartment" says nothing of its kitchen, which it has all the same.
  void add_usual_rooms() {
    const Named* whole = dwelling();
    if (!whole) return;
    // Who names one of the rooms where people meet has named all that there shall be.
    if (std::any_of(result_.rooms.begin(), result_.rooms.end(), [&](const SaidRoom& room) {
          return dwellings_.rooms.at(room.type).hub > 0;
        }))
      return;
    for (const auto& type : dwellings_.dwellings.at(tokens_[whole->noun].text)) {
      if (!rooms_of_type(type).empty()) continue;
      SaidRoom room;
      room.type = type;
      result_.rooms.push_back(room);
      about_.emplace_back();
      introduced_.push_back(tokens_.size());
      adjectives_.emplace_back();
    }
    result_.notes.push_back("rooms that such a dwelling usually has were added");
  }

  void bound_rooms() {
    // So many need a hallway, which is one of them.
    const std::size_t most = max_rooms - (rooms_of_type("hallway").empty() ? 1 : 0);
    if (result_.rooms.size() <= most) return;
    result_.notes.push_back("the prompt asks for " + std::to_string(result_.rooms.size()) +
                            " rooms; " + std::to_string(most) + " are made");
    result_.rooms.resize(most);
    about_.resize(most);
    adjectives_.resize(most);
    introduced_.resize(most);
    for (auto& room : result_.rooms)
      if (room.owner != SaidRoom::none && room.owner >= most) room.owner = SaidRoom::none;
    for (auto& named : named_)
      std::erase_if(named.rooms, [&](std::size_t room) { return room >= most; });
  }

  // "a 70 m2 apartment"
  void read_total_area() {
    const Named* whole = dwelling();
    if (!whole) return;
    std::vector<Token> head(tokens_.begin(), tokens_.begin() + static_cast<std::ptrdiff_t>(whole->end));
    Brief brief;
    read_measures(head, words_, names_, brief);
    if (brief.area) result_.area = brief.area;
    else if (brief.size) result_.area = brief.size->prod();
  }

  // "a modern apartment": each of its rooms is.
  void collect_styles() {
    const Named* whole = dwelling();
    if (!whole) return;
    for (std::size_t i = whole->noun; i-- > 0 && whole->noun - i <= 2 * longest_phrase;) {
      if (tokens_[i].kind == Token::Kind::stop) break;
      if (kinds_.style(tokens_[i].text)) styles_ += tokens_[i].text + " ";
    }
  }

  // --- What is said of them -------------------------------------------------------------------

  struct Stretch {
    std::size_t begin = 0, end = 0;
  };

  void share_clauses() {
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= tokens_.size(); ++i) {
      if (i < tokens_.size() && tokens_[i].kind != Token::Kind::stop) continue;
      share_sentence({begin, i});
      begin = i + 1;
    }
  }

  // "in the bedroom": what is said of it came before.
  bool looks_back(const Named& named) const {
    if (named.begin == 0) return false;
    for (const char* word : {"in", "inside", "within", "into", "for"})
      if (is_word(named.begin - 1, word)) return true;
    return false;
  }

  void share_sentence(const Stretch& sentence) {
    std::vector<const Named*> here;
    for (const auto& named : named_)
      if (named.noun >= sentence.begin && named.noun < sentence.end &&
          (!named.rooms.empty() || named.type.empty()))
        here.push_back(&named);
    if (here.empty()) return give_away(sentence);
    std::size_t begin = sentence.begin;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Named& named = *here[k];
      // What stands before the first room is said of it when it looks back, else of nobody known.
      if (k == 0 && !looks_back(named)) {
        give_away({begin, named.begin});
        begin = named.begin;
      }
      const std::size_t end = k + 1 < here.size() ? border(named, *here[k + 1]) : sentence.end;
      give(named, {begin, end});
      begin = end;
    }
  }

  // Where the words about one room end and those about the next begin.
  std::size_t border(const Named& named, const Named& next) const {
    if (!looks_back(next)) return next.begin;
    if (looks_back(named)) return named.end;
    for (std::size_t i = next.begin; i-- > named.end;)
      if (tokens_[i].kind == Token::Kind::comma || tokens_[i].is_word("and")) return i;
    return next.begin;
  }

  void give(const Named& named, const Stretch& range) {
    if (named.type.empty()) return give_away({std::max(range.begin, named.end), range.end});
    for (const std::size_t room : named.rooms) {
      if (looks_back(named)) about_[room].push_back({range.begin, named.begin});
      about_[room].push_back({named.end, range.end});
    }
  }

  // Clauses that name no room: piece by piece to the room where such things stand.
  void give_away(const Stretch& range) {
    std::size_t begin = range.begin;
    for (std::size_t i = range.begin; i <= range.end; ++i) {
      const bool border = i == range.end || tokens_[i].kind == Token::Kind::comma || tokens_[i].is_word("and");
      if (!border) continue;
      if (const auto room = usual_room({begin, i})) about_[*room].push_back({begin, i});
      begin = i + 1;
    }
  }

  std::optional<std::size_t> usual_room(const Stretch& range) const {
    std::optional<std::size_t> best;
    double most = 0.0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const KindMatch thing = names_.match(tokens_, i);
      if (!thing.category) continue;
      for (std::size_t room = 0; room < result_.rooms.size(); ++room) {
        const double vote = usual(kinds_.get(result_.rooms[room].type), thing.category->name);
        if (vote > most) best = room, most = vote;
      }
      i += thing.length - 1;
      if (!best) best = living_room();  // wherever people are
    }
    return best;
  }

  double usual(const RoomKind& kind, const std::string& category) const {
    const auto hears = [&](const std::vector<Piece>& pieces) {
      return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
        return std::any_of(piece.any.begin(), piece.any.end(), [&](const auto& any) {
          return table_.is_a(category, any.first);
        });
      });
    };
    return hears(kind.core) ? 3.0 : hears(kind.extras) ? 2.0 : hears(kind.details) ? 1.0 : 0.0;
  }

  std::size_t living_room() const {
    for (const char* type : {"living room", "studio", "bedroom"})
      if (const auto rooms = rooms_of_type(type); !rooms.empty()) return rooms[0];
    return 0;
  }

  // --- Prompts --------------------------------------------------------------------------------

  // Without the words that only join it to the next room's.
  std::string text_of(Stretch range) const {
    const auto joins = [&](const Token& token) {
      return token.kind == Token::Kind::comma || token.is_word("and") || token.is_word("plus") ||
             token.is_word("each") || token.is_word("while") || token.is_word("but");
    };
    while (range.begin < range.end && joins(tokens_[range.begin])) ++range.begin;
    while (range.end > range.begin &&
           (joins(tokens_[range.end - 1]) ||
            dwellings_.links.count(tokens_[range.end - 1].text) || tokens_[range.end - 1].is_word("to") ||
            tokens_[range.end - 1].is_word("leading") || tokens_[range.end - 1].is_word("in")))
      --range.end;
    std::string text;
    for (std::size_t i = range.begin; i < range.end; ++i)
      text += (tokens_[i].kind == Token::Kind::comma ? "," : (text.empty() ? "" : " ") + tokens_[i].text);
    return text;
  }

  void write_prompts() {
    for (std::size_t r = 0; r < result_.rooms.size(); ++r) {
      SaidRoom& room = result_.rooms[r];
      room.prompt = "a " + styles_ + adjectives_[r] + room.type;
      for (const auto& range : about_[r]) {
        const std::string text = text_of(range);
        if (text.empty()) continue;
        // At once it goes on about the room that it names, later it comes back to it.
        const bool goes_on = range.begin == introduced_[r];
        if (begins_with_link(text))
          room.prompt += (goes_on ? " " : ". the " + room.type + " ") + text;
        else
          room.prompt += (text.starts_with("there ") ? ". " : ". there is ") + text;
      }
    }
  }

  static bool begins_with_link(const std::string& text) {
    for (const char* link : {"with ", "has ", "have ", "contains ", "features ", "includes ", "for ", "that ", "where "})
      if (text.starts_with(link)) return true;
    return false;
  }

  const std::vector<Token> tokens_;
  const Vocabulary& words_;
  const DwellingKinds& dwellings_;
  const RoomKinds& kinds_;
  const CategoryTable& table_;
  const KindNames names_;
  const std::map<std::string, std::string, std::less<>> room_names_;
  std::vector<Named> named_;
  SaidDwelling result_;
  std::vector<std::vector<Stretch>> about_;  ///< by room
  std::vector<std::string> adjectives_;    ///< by room
  std::vector<std::size_t> introduced_;    ///< by room: the token behind its name
  std::string styles_;
};

}  // namespace

std::optional<SaidDwelling> read_dwelling(std::string_view prompt, const DwellingKinds& dwellings,
                                          const RoomKinds& kinds, const CategoryTable& table) {
  const auto& words = built_in_vocabulary();
  if (!words) return std::nullopt;
  return DwellingReader(prompt, *words, dwellings, kinds, table).run();
}

}  // namespace roomgen::design
