#include <optional>

#include "roomgen/base/text.h"
#include "token_readers.h"
#include "tone.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t longest_phrase = 3;  ///< words that name one surface
constexpr std::size_t longest_run = 10;    ///< words that describe one part of the room
constexpr std::size_t longest_link = 4;    ///< words between a part and what describes it

/// Words about one part of the room: tokens [begin, end).
struct Finding {
  std::size_t begin = 0, end = 0;
  RoomPart part = RoomPart::floor;
  bool one_wall = false;
  std::string description;
};

class FinishReader {
 public:
  FinishReader(const std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
         const FinishWords& finishes)
      : tokens_(tokens), words_(words), table_(table), finishes_(finishes) {}

  std::optional<Finding> read(std::size_t at) const {
    if (at > 0 && words_.negations.count(tokens_[at - 1].text)) return std::nullopt;
    if (auto found = read_described_first(at)) return found;
    return read_part_first(at);
  }

  /// Is something said to stand there: "on the oak floor"?
  bool is_target(std::size_t begin) const {
    static const WordSet places = {"on",      "against", "along",  "near",   "at",
                                   "in",      "to",      "by",     "facing", "from",
                                   "behind",  "over",    "beside", "onto",   "toward",
                                   "towards", "under",   "above",  "across", "opposite"};
    return begin > 0 && tokens_[begin - 1].kind == Token::Kind::word &&
           places.count(tokens_[begin - 1].text) > 0;
  }

 private:
  bool is_word(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::word;
  }
  bool is_word(std::size_t i, std::string_view word) const {
    return i < tokens_.size() && tokens_[i].is_word(word);
  }
  // Nothing that could be a noun.
  bool ends_phrase(std::size_t i) const {
    static const WordSet after = {"throughout", "everywhere", "all", "here", "finish", "surface"};
    return !is_word(i) || words_.stops.count(tokens_[i].text) || after.count(tokens_[i].text);
  }

  // --- Descriptions ---------------------------------------------------------------------------

  // Tokens of the descriptive word or name at i; 0 if there is none.
  std::size_t descriptive(std::size_t i) const {
    if (const auto name = longest(finishes_.surface_names, tokens_, i, longest_phrase))
      return name.length;
    if (begins_tone(tokens_, i, words_)) return 2;
    return is_word(i) && finishes_.describes(tokens_[i].text) ? 1 : 0;
  }

  bool is_color(std::size_t i) const {
    return is_word(i) && (finishes_.basic_colors.count(tokens_[i].text) ||
                          finishes_.colors.count(tokens_[i].text));
  }

  // The end of the description that begins at `begin`; `begin` if there is none.
  std::size_t run_end(std::size_t begin) const {
    std::size_t end = begin, i = begin;
    while (i < tokens_.size() && i < begin + longest_run) {
      if (const std::size_t length = descriptive(i)) {
        end = i += length;
      } else if (is_word(i) && finishes_.fillers.count(tokens_[i].text)) {
        ++i;
      } else if (i > begin && is_word(i, "and") && is_color(i - 1) && is_color(i + 1)) {
        ++i;  // "black and white"
      } else {
        break;
      }
    }
    return end;
  }

  std::string text(std::size_t begin, std::size_t end) const {
    std::vector<std::string> pieces;
    for (std::size_t i = begin; i < end; ++i)
      if (tokens_[i].kind == Token::Kind::word) pieces.push_back(tokens_[i].text);
    return join(pieces, " ");
  }

  // --- Phrases --------------------------------------------------------------------------------

  // Back over "a", "the".
  std::size_t with_determiner(std::size_t begin) const {
    static const WordSet determiners = {"a", "an", "the", "its", "one"};
    const bool any = begin > 0 && is_word(begin - 1) && determiners.count(tokens_[begin - 1].text);
    return any ? begin - 1 : begin;
  }

  Finding finding(std::size_t begin, std::size_t end, RoomPart part, const std::string& noun,
                  std::string description) const {
    Finding found;
    found.begin = with_determiner(begin);
    found.end = end;
    found.part = part;
    found.one_wall = noun == "wall";
    found.description = std::move(description);
    return found;
  }

  // "dark oak floors", "tiled".
  std::optional<Finding> read_described_first(std::size_t at) const {
    std::size_t end = at;
    // A filler may lead: "exposed brick", "painted white walls".
    while (is_word(end) && finishes_.fillers.count(tokens_[end].text) && end < at + longest_phrase)
      ++end;
    const std::size_t run = run_end(end);
    if (run == end) return std::nullopt;
    // And one may follow: "a navy accent wall".
    std::size_t part = run;
    while (is_word(part) && finishes_.fillers.count(tokens_[part].text)) ++part;
    if (is_part(part))
      return finding(at, part + 1, part_of(part), tokens_[part].text, text(at, part + 1));
    return read_alone(at, run);
  }

  // A part of the room, and not of "wall clock" or "floor cushions".
  bool is_part(std::size_t i) const {
    if (!is_word(i) || !finishes_.parts.count(tokens_[i].text)) return false;
    if (mention_at(table_, tokens_, i).length > 0) return false;
    const std::string& noun = tokens_[i].text;
    const bool singular = noun == "wall" || noun == "floor" || noun == "ceiling";
    return !singular || ends_phrase(i + 1);
  }

  RoomPart part_of(std::size_t i) const { return finishes_.parts.find(tokens_[i].text)->second; }

  // "exposed brick", "a tiled bathroom": the description names its part of the room itself.
  std::optional<Finding> read_alone(std::size_t at, std::size_t run) const {
    const bool is_thing = mention_at(table_, tokens_, run - 1).length > 0 && !is_laid_everywhere(at, run);
    if (!ends_phrase(run) || is_thing) return std::nullopt;
    for (std::size_t i = at; i < run; ++i)
      if (const auto alone = longest(finishes_.alone, tokens_, i, longest_phrase);
          alone && i + alone.length <= run)
        return finding(at, run, *alone.value, "", text(at, run));
    return std::nullopt;
  }

  // "Grey carpet.": without an article it is the floor.
  bool is_laid_everywhere(std::size_t at, std::size_t run) const {
    const bool begins = at == 0 || !is_word(at - 1) || is_word(at - 1, "and") || is_word(at - 1, "with");
    return begins && run > at + 1 && finishes_.alone.count(tokens_[run - 1].text) > 0;
  }

  // "the walls are painted in sage green", "floors of oak".
  std::optional<Finding> read_part_first(std::size_t at) const {
    if (!is_word(at) || !finishes_.parts.count(tokens_[at].text)) return std::nullopt;
    if (mention_at(table_, tokens_, at).length > 0 || is_target(with_determiner(at))) return std::nullopt;
    static const WordSet links = {
        "is",      "are",      "was",     "were",  "painted", "covered", "clad", "panelled",
        "paneled", "finished", "made",    "paved", "laid",    "lined",   "done", "coated",
        "tiled",   "papered",  "dressed", "in",    "of",      "with",    "all",  "both",
        "should",  "shall",    "must",    "be",    "need",    "to",      "will"};
    std::size_t begin = at + 1;
    while (is_word(begin) && links.count(tokens_[begin].text) && begin <= at + longest_link)
      ++begin;
    if (begin == at + 1) return std::nullopt;
    const std::size_t end = run_end(begin);
    if (end == begin || !ends_phrase(end)) return std::nullopt;
    return finding(at, end, part_of(at), tokens_[at].text,
                   text(begin, end) + " " + tokens_[at].text);
  }

  const std::vector<Token>& tokens_;
  const Vocabulary& words_;
  const KindTable& table_;
  const FinishWords& finishes_;
};

std::string& material(RoomMaterials& materials, const Finding& found) {
  if (found.part == RoomPart::floor) return materials.floor;
  if (found.part == RoomPart::ceiling) return materials.ceiling;
  return found.one_wall ? cover_named(materials, accent_name).finish : materials.walls;
}

}  // namespace

void read_finishes(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                   const FinishWords& finishes, Brief& brief) {
  const FinishReader reader(tokens, words, table, finishes);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const auto found = reader.read(at);
    if (!found) continue;
    std::string& said = material(brief.materials, *found);
    if (said.empty()) said = found->description;
    hear(brief, source_of(tokens, found->begin, found->end - found->begin), Heard::As::attribute,
         found->description);
    if (reader.is_target(found->begin)) {
      at = found->end - 1;
      continue;
    }
    const auto begin = tokens.begin() + static_cast<std::ptrdiff_t>(found->begin);
    tokens.erase(begin, tokens.begin() + static_cast<std::ptrdiff_t>(found->end));
    at = found->begin - 1;  // wraps to the beginning
  }
}

}  // namespace roomgen::brief
