#include "item_kind.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "brief/brief_form.h"
#include "kinds/mounting.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_words = 60;         ///< bytes of a name
constexpr std::size_t max_description = 300;  ///< bytes

/// How many times larger or smaller than usual a thing may be, the surer its name is.
constexpr double any_size = 1e9;    ///< the kind's very name
constexpr double sure_size = 2.2;   ///< another name of the kind, or a sort of it
constexpr double vague_size = 1.6;  ///< by the last word only, or by what WordNet says
constexpr double sheet_size = 4.0;  ///< pictures and rugs come in all sizes
constexpr double thin = 0.1;        ///< metres: below it thickness tells nothing

Vec3 sorted(const Vec3& size) {
  Vec3 sides = size.cwiseMax(thin);
  std::sort(sides.begin(), sides.end());
  return sides;
}

bool is_about(const Vec3& size, const Kind& kind, double most) {
  const Vec3 said = sorted(size), usual = sorted(kind.size);
  if (said.x() <= thin && usual.x() <= thin) most = std::max(most, sheet_size);
  return (said.array() <= most * usual.array()).all() &&
         (usual.array() <= most * said.array()).all();
}

// "Counter" alone is no kitchen counter, except in a kitchen.
bool claims_more(const Kind& kind, const std::string& ending, const ItemLexicon& lexicon) {
  const auto named = words(kind.name), said = words(ending), room = words(lexicon.kind.type);
  return said.size() == 1 && named.size() > 1 && named.back() == singular(said.back()) &&
         std::find(room.begin(), room.end(), named.front()) == room.end();
}

/// Which kind a name means.
class Naming {
 public:
  Naming(const SaidThing& thing, std::string name, const ItemLexicon& lexicon)
      : thing_(thing), name_(std::move(name)), lexicon_(lexicon), table_(lexicon.table) {}

  std::string kind() const {
    bool is_shared = false;
    for (std::size_t at = 0; at < name_.size(); at = next_word(at)) {
      const std::string ending = name_.substr(at);
      const Kind* kind = table_.named(ending);
      if (kind && fits(table_.planned(*kind), ending)) return table_.planned(*kind).name;
      is_shared = is_shared || kind;
    }
    const brief::KindMention meant = brief::name_in_form(name_, table_).kind;
    const bool is_guess = meant.length > 0 && meant.is_inferred() && !meant.is_stand_in();
    if (is_guess && is_near(*meant.category, vague_size)) return meant.category->name;
    if (is_shared || is_guess) return own_name();
    return meant.is_stand_in() ? name_ : "";
  }

 private:
  std::size_t next_word(std::size_t at) const {
    const std::size_t blank = name_.find(' ', at);
    return blank == std::string::npos ? name_.size() : blank + 1;
  }

  bool fits(const Kind& kind, const std::string& ending) const {
    if (claims_more(kind, ending, lexicon_)) return false;
    if (kind.lamp) return true;  // at any size, and nothing else shines
    if (table_.only_resembles(ending)) return false;
    const bool is_whole = ending.size() == name_.size();
    const bool is_own = table_.by_name(ending) || table_.by_name(singular(ending));
    if (is_whole && is_own) return true;
    return is_near(kind, is_own || (is_whole && table_.called(ending)) ? sure_size : vague_size);
  }

  bool is_near(const Kind& kind, double most) const {
    if (thing_.size && !is_about(*thing_.size, kind, most)) return false;
    const bool is_put_otherwise = thing_.mount && !may_be_put_up(kind, *thing_.mount);
    return most > vague_size || !is_put_otherwise;
  }

  // As one word it ends in no other kind's name: "scent-organ", and of a boiler that is a "copper
  // steam boiler" the "steam-boiler". The name itself where nothing else is known of it.
  std::string own_name() const {
    std::string own = join(split(name_, ' '), "-");
    if (const std::size_t at = own.find("-s-"); at != std::string::npos) own.erase(at, 1);
    if (!table_.find(own)) return own;
    const std::string phrase =
        thing_.description.substr(0, thing_.description.find_first_of(",;."));
    const auto said = split(lower(phrase), ' ');
    const auto head = std::find(said.begin(), said.end(), own);
    const bool is_sort = head != said.begin() && head != said.end() &&
                         std::all_of(std::prev(head)->begin(), std::prev(head)->end(),
                                     [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
    if (is_sort && std::prev(head)->size() > 1 && !table_.find(*std::prev(head) + "-" + own))
      return *std::prev(head) + "-" + own;
    return table_.find(name_)->name;
  }

  const SaidThing& thing_;
  const std::string name_;
  const ItemLexicon& lexicon_;
  const KindTable& table_;
};

// The first kind that is named in a text.
std::string first_kind(const std::string& text, const KindTable& table) {
  const auto tokens = brief::tokenize(text);
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (const brief::KindMention match = brief::mention_at(table, tokens, i); match.length > 0)
      return match.category->name;
  return "";
}

}  // namespace

std::string plain_name(const std::string& name) {
  auto pieces = words(name);
  const auto is_number = [](const std::string& word) {
    return word.find_first_not_of("0123456789") == std::string::npos;
  };
  if (pieces.size() > 1 && is_number(pieces.back())) pieces.pop_back();
  return shortened(join(pieces, " "), max_words);
}

std::string kind_of(const SaidThing& thing, const ItemLexicon& lexicon) {
  const std::string plain = plain_name(thing.name);
  const auto& means = lexicon.kind.means;
  if (const auto meant = means.find(plain); meant != means.end()) return meant->second;
  if (std::string kind = Naming(thing, plain, lexicon).kind(); !kind.empty()) return kind;
  // A name that says nothing leaves it to the description; any other is its own kind.
  const std::set<std::string> says_nothing = {"object",    "item",  "thing", "piece",
                                              "furniture", "asset", "prop"};
  const auto pieces = words(plain);
  const bool is_empty = !pieces.empty() && (says_nothing.count(pieces.front()) > 0 ||
                                            says_nothing.count(pieces.back()) > 0);
  return is_empty ? first_kind(shortened(thing.description, max_description), lexicon.table) : "";
}

}  // namespace roomgen::design
