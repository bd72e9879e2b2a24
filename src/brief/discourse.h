#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "brief.h"
#include "kind_mention.h"
#include "noun_phrase.h"
#include "placement_phrase.h"
#include "prompt_words.h"
#include "room_kinds.h"

namespace roomgen::design {

/// What a reader needs to know to name things.
struct Lexicon {
  const Vocabulary& words;
  const KindTable& table;
  const RoomKind& kind;  ///< of the room: what a "sink" is depends on it
};

/// What a text has spoken of so far: things, the one that it speaks of now, and what is said of the
/// places of those that are yet to be named.
class Discourse {
 public:
  Discourse(const Lexicon& lexicon, Brief& brief) : lexicon_(lexicon), brief_(brief) {}

  /// The category that a name means in this room.
  std::string category_name(const KindMention& kind) const;
  const Mention& mention(std::size_t index) const { return brief_.mentions[index]; }
  std::size_t count() const { return brief_.mentions.size(); }

  /// The thing spoken of before that a phrase means.
  std::optional<std::size_t> known(const NounPhrase& phrase) const;
  /// That, if the phrase is definite, else a new mention; none when there are too many.
  std::optional<std::size_t> refer(const NounPhrase& phrase);
  void multiply_last(int factor) { brief_.mentions.back().quantity *= factor; }
  void multiply(std::size_t mention, int factor) { brief_.mentions[mention].quantity *= factor; }

  /// The thing of which the next placement speaks.
  std::optional<std::size_t> subject() const { return subject_; }
  void speak_of(std::optional<std::size_t> mention) {
    subject_ = mention;
    nth_ = -1;
  }
  /// "one holds …, the other …": of the several that were spoken of last; false if there are none.
  bool speak_of_one_of_them(bool other);
  /// What "it" means: the last floor thing that is not the subject.
  std::optional<std::size_t> antecedent() const;
  std::optional<std::size_t> last_on_floor() const;
  /// What a placement without a target is relative to.
  std::optional<std::size_t> antecedent(RelationKind kind) const;

  /// Things listed together; "are against the wall" is said of all.
  void list(std::size_t mention, bool continues);
  void speak_of_all() { plural_ = true; }
  void speak_of_one() { plural_ = false; }

  /// Says something of the subject, or of the next thing when `leads`.
  void demand(const Demand& what, bool leads);
  void add(std::size_t mention, const Demand& what);
  /// Said of what hangs above something: pictures stay on the wall.
  void hang_lamps(bool leads);
  /// The small things listed last stand on what was named before them.
  void put_on_what_was_named();
  /// Says in what part of the room the subject is.
  void locate(const Placement& placement, const PlacePhrase& place, bool leads);

  /// What was said beforehand becomes true of this thing.
  void apply_leading(std::size_t mention);

  /// "holds a lamp, two books and a mug": what is said of the first is said of all that are listed.
  void open_list(std::vector<Demand> demands) { listed_ = std::move(demands); }
  void extend_list(std::size_t mention);
  void close_list() { listed_.clear(); }
  /// "a desk and a shelf side by side"
  void relate_listed(const Placement& placement);
  /// What was spoken of last of what things stand on; "tabletop" is a table's.
  std::optional<std::size_t> last_carrier(std::string_view top = "") const;
  /// The thing of that kind that was spoken of last.
  std::optional<std::size_t> last_of(const KindMention& kind) const;
  /// "a desk with a lamp", "a tray with two cups", but no "monitor with a keyboard".
  bool may_carry(std::size_t mention) const;
  /// "a table with four stools holds": who holds.
  void join_with(std::size_t owner) { with_owner_ = owner; }
  std::optional<std::size_t> holder() const;
  int holder_number() const { return nth_; }
  std::optional<std::size_t> with_owner() const { return with_owner_; }
  void end_sentence();

 private:
  Mention new_mention(const NounPhrase& phrase) const;
  std::optional<std::size_t> same_noun(const NounPhrase& phrase) const;
  std::optional<std::size_t> last_compound(std::string_view noun) const;
  bool is_small(std::size_t mention) const;
  /// Chairs and benches at a table, not at a desk.
  bool seats_at(std::size_t seat, std::size_t other) const;
  std::vector<std::size_t> subjects() const;
  bool is_listed(std::size_t mention) const;
  void locate_at_window(const Placement& placement, bool leads);
  void locate_at_wall(RelationKind first, const PlacePhrase& place, bool leads);
  void mount(Mount where, bool leads);
  void stand_on_floor(bool leads);
  void hang_lamp(Mention& mention) const;

  Lexicon lexicon_;
  Brief& brief_;
  std::optional<std::size_t> subject_;
  std::vector<std::size_t> group_;
  bool group_placed_ = false;  ///< its place was told: what is listed then is another group
  bool plural_ = false;
  int last_nth_ = 0;
  int nth_ = -1;  ///< which of the subject's things
  std::vector<Demand> leading_;
  std::vector<Demand> listed_;
  int sentence_ = 0;
  std::optional<std::size_t> with_owner_;
  std::optional<Mount> leading_mount_;
  bool lamps_hang_ = false;  ///< "Above hangs a lantern": of what is to be named
};

}  // namespace roomgen::design
