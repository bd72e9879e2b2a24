#include <algorithm>
#include <optional>

#include "dwelling_reading.h"

namespace roomgen::brief {

namespace {

// How much such a thing belongs to such a room.
double usual(const RoomKind& kind, const std::string& category, const KindTable& table) {
  const auto hears = [&](const std::vector<Piece>& pieces) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return std::any_of(piece.any.begin(), piece.any.end(), [&](const auto& any) {
        return table.is_a(category, any.first);
      });
    });
  };
  return hears(kind.core) ? 3.0 : hears(kind.extras) ? 2.0 : hears(kind.details) ? 1.0 : 0.0;
}

class ClauseSharer {
 public:
  ClauseSharer(const DwellingText& text, const std::vector<NamedRoom>& names,
               const std::vector<FoundRoom>& rooms, const RoomKinds& kinds,
               const KindTable& table)
      : text_(text), names_(names), rooms_(rooms), kinds_(kinds), table_(table) {}

  std::vector<std::vector<Stretch>> run() {
    about_.resize(rooms_.size());
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= text_.tokens.size(); ++i) {
      if (i < text_.tokens.size() && text_.tokens[i].kind != Token::Kind::stop) continue;
      share_sentence({begin, i});
      begin = i + 1;
    }
    return std::move(about_);
  }

 private:
  // "in the bedroom": what is said of it came before.
  bool looks_back(const NamedRoom& named) const {
    if (named.begin == 0) return false;
    for (const char* word : {"in", "inside", "within", "into", "for"})
      if (text_.is_word(named.begin - 1, word)) return true;
    return false;
  }

  // ", everything in cream and gold": where what is said of all rooms begins.
  std::size_t begin_of_all(const Stretch& sentence) const {
    for (std::size_t i = sentence.end; i-- > sentence.begin + 1;) {
      const bool names_room = std::any_of(names_.begin(), names_.end(),
                                          [&](const NamedRoom& named) { return named.begin == i; });
      if (names_room) break;
      const bool is_all =
          text_.is_word(i, "all") && i + 1 < sentence.end && text_.is_word(i + 1, "in");
      if (joins(i - 1) && (is_all || text_.is_word(i, "everything"))) return i;
    }
    return sentence.end;
  }

  void share_sentence(const Stretch& whole) {
    const Stretch sentence{whole.begin, begin_of_all(whole)};
    share_rooms(sentence);
    if (sentence.end < whole.end)
      for (auto& own : about_) own.push_back({sentence.end, whole.end});
  }

  void share_rooms(const Stretch& sentence) {
    std::vector<const NamedRoom*> here;
    for (const auto& named : names_)
      if (named.noun >= sentence.begin && named.noun < sentence.end &&
          (!named.rooms.empty() || named.type.empty()))
        here.push_back(&named);
    if (here.empty()) return give_away(sentence);
    std::size_t begin = sentence.begin;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const NamedRoom& named = *here[k];
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

  bool joins(std::size_t i) const {
    return text_.tokens[i].kind == Token::Kind::comma || text_.tokens[i].is_word("and");
  }

  // Where the words about one room end and those about the next begin.
  std::size_t border(const NamedRoom& named, const NamedRoom& next) const {
    if (!looks_back(next)) return next.begin;
    if (looks_back(named)) return named.end;
    for (std::size_t i = next.begin; i-- > named.end;)
      if (joins(i)) return i;
    return next.begin;
  }

  void give(const NamedRoom& named, const Stretch& range) {
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
      if (i != range.end && !joins(i)) continue;
      if (const auto room = usual_room({begin, i})) about_[*room].push_back({begin, i});
      begin = i + 1;
    }
  }

  std::optional<std::size_t> usual_room(const Stretch& range) const {
    std::optional<std::size_t> best;
    double most = 0.0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const KindMention thing = mention_at(text_.things, text_.tokens, i);
      if (!thing.category) continue;
      for (std::size_t room = 0; room < rooms_.size(); ++room) {
        const double vote = usual(kinds_.get(rooms_[room].type), thing.category->name, table_);
        if (vote > most) best = room, most = vote;
      }
      i += thing.length - 1;
      if (!best) best = living_room();  // wherever people are
    }
    return best;
  }

  std::size_t living_room() const {
    for (const char* type : {"living room", "studio", "bedroom"})
      if (const auto found = rooms_of_type(rooms_, type); !found.empty()) return found[0];
    return 0;
  }

  const DwellingText& text_;
  const std::vector<NamedRoom>& names_;
  const std::vector<FoundRoom>& rooms_;
  const RoomKinds& kinds_;
  const KindTable& table_;
  std::vector<std::vector<Stretch>> about_;  ///< by room
};

}  // namespace

std::vector<std::vector<Stretch>> share_clauses(const DwellingText& text,
                                                const std::vector<NamedRoom>& names,
                                                const std::vector<FoundRoom>& rooms,
                                                const RoomKinds& kinds,
                                                const KindTable& table) {
  return ClauseSharer(text, names, rooms, kinds, table).run();
}

}  // namespace roomgen::brief
