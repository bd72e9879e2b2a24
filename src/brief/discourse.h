#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brief.h"
#include "placement_phrase.h"
#include "prompt_words.h"
#include "room_kinds.h"
#include "thing_phrase.h"

namespace roomgen::brief {

/// What a reader needs to know to name things.
struct Lexicon {
  const Vocabulary& words;
  const KindTable& table;
  const RoomKind& kind;  ///< of the room: what a "sink" is depends on it
};

/// Mentions of a brief, by their index.
using Indices = std::vector<std::size_t>;
bool is_among(const Indices& indices, std::size_t index);

/// What a text has spoken of so far: things, and what it says of their places.
class Discourse {
 public:
  Discourse(const Lexicon& lexicon, Brief& brief) : lexicon_(lexicon), brief_(brief) {}

  /// The category that a name means in this room.
  std::string category_name(const KindMention& kind) const;
  const Mention& mention(std::size_t index) const { return brief_.mentions[index]; }
  std::size_t count() const { return brief_.mentions.size(); }
  /// What is looked for further back lies before this mention.
  void look_back_from(std::size_t mention) { horizon_ = mention; }
  /// The words (of Brief::heard) that say the demands which follow.
  void told_by(std::size_t heard) { told_by_ = heard; }
  std::size_t told() const { return told_by_; }

  /// The thing spoken of before that a phrase means.
  std::optional<std::size_t> known(const ThingPhrase& phrase) const;
  /// What was spoken of that a phrase such as "a nightstand" may mean: of that kind, and as it says.
  std::optional<std::size_t> one_of(const ThingPhrase& phrase) const;
  /// That, if the phrase is definite, else a new mention; none when there are too many.
  std::optional<std::size_t> refer(const ThingPhrase& phrase, int sentence);
  /// Some of several, as a mention of their own.
  std::size_t part(std::size_t whole, int count);
  /// As many more of the same, of which nothing is said yet.
  std::size_t another(std::size_t first, int count);
  /// Things that were taken for others are some of several.
  void adopt(std::size_t part, std::size_t whole);
  /// The mention, and those that are parts of it.
  std::vector<std::size_t> with_parts(std::size_t mention) const;
  void multiply(std::size_t mention, int factor);
  /// "floor to ceiling"
  void reach_ceiling(Mention& mention) const;
  /// How many there are at least, of a plural without a number.
  void expect(std::size_t mention, int count);
  /// How many there are, said behind them.
  void set_count(std::size_t mention, int count);
  /// Another word of what it is like.
  void describe(std::size_t mention, const std::string& look);

  /// What "it" means: the last floor thing that is none of the subjects; of what is one, where there is such.
  std::optional<std::size_t> antecedent(const std::vector<std::size_t>& subjects, bool is_one = false) const;
  /// What a placement of the subjects (at least one) without a target is relative to.
  std::optional<std::size_t> antecedent(RelationKind kind,
                                        const std::vector<std::size_t>& subjects) const;
  /// The last of several that were spoken of: "one holds …, the other …"; also of a plural without a number.
  std::optional<std::size_t> last_of_several(const std::vector<std::size_t>& but = {}, bool is_open = false) const;
  /// The thing of that kind that was spoken of last.
  std::optional<std::size_t> last_of(const KindMention& kind) const;
  /// The last thing of a kind that is none of the subjects.
  std::optional<std::size_t> last_of_category(const std::string& category, const std::vector<std::size_t>& subjects) const;
  /// What was spoken of last of what things stand on; "tabletop" is a table's.
  std::optional<std::size_t> last_carrier(std::string_view top = "") const;

  /// Says something of things; of several that are small on something, and of others, the small
  /// ones.
  void demand(const std::vector<std::size_t>& subjects, const Demand& what);
  void add(std::size_t mention, const Demand& what);
  /// Says in what part of the room things are.
  void locate(const std::vector<std::size_t>& subjects, const Placement& placement,
              const PlacePhrase& place);
  /// Halves of things at places that there are two of: "at opposite ends of the room", "along both long walls".
  enum class Both { ends, long_walls, short_walls, side_walls };
  void locate_at_both(const Indices& subjects, Both both);
  /// "a desk with a lamp", "a table with four chairs": where what a thing has is.
  void own(std::size_t owner, std::size_t mention, bool is_each = false, int nth = -1);
  /// What can hang from the ceiling and hangs over a table, hangs there: a lamp, a plant.
  void hang_from_ceiling(const std::vector<std::size_t>& subjects);

  /// "a desk with a lamp", "a tray with two cups", but no "monitor with a keyboard".
  bool may_carry(std::size_t mention) const;
  bool is_small(std::size_t mention) const;

 private:
  Mention new_mention(const ThingPhrase& phrase, int sentence) const;
  bool are_others(const ThingPhrase& phrase, std::size_t known) const;
  bool is_other_kind(const ThingPhrase& phrase, std::size_t known) const;
  void note_bound(const ThingPhrase& phrase);
  void note_reading(const KindMention& kind);
  bool names_more_than(const KindMention& kind) const;
  std::optional<std::size_t> same_noun(const ThingPhrase& phrase) const;
  std::optional<std::size_t> last_compound(std::string_view noun) const;
  /// Chairs and benches at a table, not at a desk.
  bool seats_at(std::size_t seat, std::size_t other) const;
  /// A chair that something to sit or work at is with: "a counter with six stools".
  bool works_at(std::size_t seat, std::size_t other) const;
  bool stands_beside_seat(std::size_t index, std::size_t owner) const;
  void locate_at_window(const std::vector<std::size_t>& subjects, const Placement& placement);
  void locate_at_wall(const std::vector<std::size_t>& subjects, RelationKind first,
                      const PlacePhrase& place);
  void demand_at_wall(const Indices& subjects, const std::string& wall);
  void demand_middle_of(const Indices& subjects, const std::string& wall);
  /// Every other one of them, or half of one kind, of which there are two then at least.
  std::pair<Indices, Indices> halves(const Indices& subjects);
  void mount(const std::vector<std::size_t>& subjects, Mount where);
  void hang_at_ceiling(const std::vector<std::size_t>& subjects, RelationKind relation);

  Lexicon lexicon_;
  /// The mentions that were made before what is being read.
  std::size_t made() const { return std::min(horizon_, count()); }

  Brief& brief_;
  std::size_t horizon_ = static_cast<std::size_t>(-1);
  std::size_t told_by_ = HeardWords::none;
};

/// What is not near is planned far.
void keep_away(const Denial& denial, Discourse& talk);

}  // namespace roomgen::brief
