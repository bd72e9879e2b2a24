#include "learned_reader.h"

#include <algorithm>

#include "brief/placement_phrase.h"
#include "clause_tails.h"
#include "deed_evidence.h"
#include "edit_reader.h"
#include "new_things.h"
#include "part_orders.h"
#include "plain_wording.h"
#include "role_model.h"
#include "roomgen/base/text.h"
#include "spoken_parts.h"
#include "word_order.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

// ---- The words of an order ---------------------------------------------------------------------

void append_words(EditText& to, const EditText& from, std::size_t begin, std::size_t end) {
  const auto copy = [&](auto& list, const auto& other) {
    list.insert(list.end(), other.begin() + static_cast<std::ptrdiff_t>(begin),
                other.begin() + static_cast<std::ptrdiff_t>(end));
  };
  copy(to.raw, from.raw);
  copy(to.tokens, from.tokens);
}

RoleStretch without_marks(const EditText& text, RoleStretch part) {
  while (part.begin < part.end && text.is_mark(part.begin)) ++part.begin;
  while (part.end > part.begin && text.is_mark(part.end - 1)) --part.end;
  return part;
}

void clear_words(EditText& text) {
  text.raw.clear();
  text.tokens.clear();
}

EditText without_words(EditText text) {
  clear_words(text);
  return text;
}

/// Puts an order together from its parts.
class OrderWords {
 public:
  OrderWords(const EditText& text, const EditText& so_far, const SpokenOrder& order)
      : text_(text), words_(without_words(so_far)), order_(order) {}

  OrderWords& add(const RoleStretch& part) {
    const auto plain = without_marks(text_, part);
    append_words(words_, text_, plain.begin, plain.end);
    return *this;
  }
  OrderWords& say(const std::string& word) {
    insert_word(words_, words_.tokens.size(), word);
    return *this;
  }
  OrderWords& say_all(const std::string& phrase) {
    for (const auto& word : split(phrase, ' ')) say(word);
    return *this;
  }
  /// What the amounts say, without what is said around it.
  OrderWords& add_lengths() {
    for (const auto& part : order_.parts)
      if (part.role == EditRole::amount)
        if (const auto length = length_within(text_, part)) add(*length);
    return *this;
  }
  /// The parts with one of the roles, from left to right.
  OrderWords& add_all(std::initializer_list<EditRole> roles) {
    for (const auto& part : order_.parts)
      if (std::count(roles.begin(), roles.end(), part.role) > 0) add(part);
    return *this;
  }
  OrderWords& add_things() {
    bool is_first = true;
    for (const auto& part : things_of_order()) {
      if (!is_first) say("and");
      is_first = false;
      add(part);
    }
    if (is_first && !words_.latest.empty()) say(words_.latest.size() > 1 ? "them" : "it");
    return *this;
  }
  EditText taken() {
    word_plainly(words_);
    return std::move(words_);
  }

 private:
  // "the globe, would it fit on …": what takes up a name says nothing more.
  std::vector<RoleStretch> things_of_order() const {
    std::vector<RoleStretch> named, taken_up;
    for (const auto& part : order_.parts) {
      if (part.role != EditRole::thing) continue;
      const auto thing = named_thing_at(text_, part.begin);
      (thing && thing->which == Which::pronoun ? taken_up : named).push_back(part);
    }
    return named.empty() ? taken_up : named;
  }

  const EditText& text_;
  EditText words_;
  const SpokenOrder& order_;
};

bool is_whole(const EditText& text, const ReadClause& clause) {
  if (!clause) return false;
  std::size_t end = end_of_tail(text, clause->end);
  while (end < text.tokens.size() && text.is_mark(end)) ++end;
  return end >= text.tokens.size();
}

// ---- What an order asks for --------------------------------------------------------------------

bool is_for(const edit::Operation& operation, EditDeed deed) {
  const auto is_one_of = [&]<typename... T>() { return (std::holds_alternative<T>(operation) || ...); };
  switch (deed) {
    case EditDeed::add: return is_one_of.operator()<edit::Add>();
    case EditDeed::remove: return is_one_of.operator()<edit::Remove>();
    case EditDeed::move: return is_one_of.operator()<edit::Move, edit::Put, edit::Shift>();
    case EditDeed::turn: return is_one_of.operator()<edit::Turn, edit::Face>();
    case EditDeed::face: return is_one_of.operator()<edit::Face, edit::Turn>();
    case EditDeed::swap: return is_one_of.operator()<edit::Swap>();
    case EditDeed::replace: return is_one_of.operator()<edit::Replace>();
    case EditDeed::resize: return is_one_of.operator()<edit::Resize, edit::Refit, edit::Reform>();
    case EditDeed::recolour: return is_one_of.operator()<edit::Recolor, edit::Cover>();
    case EditDeed::lock:
    case EditDeed::unlock: {
      const auto* lock = std::get_if<edit::Lock>(&operation);
      return lock && lock->locked == (deed == EditDeed::lock);
    }
    case EditDeed::rearrange: return is_one_of.operator()<edit::Rearrange, edit::Arrange, edit::Move>();
    case EditDeed::room: return is_one_of.operator()<edit::Open, edit::Close, edit::Refit, edit::Reshape, edit::Cover>();
    case EditDeed::undo: return is_one_of.operator()<edit::Revert>();
  }
  return false;
}

bool are_for(const std::vector<edit::Operation>& operations, std::size_t first, EditDeed deed) {
  return operations.size() > first &&
         std::all_of(operations.begin() + static_cast<std::ptrdiff_t>(first), operations.end(),
                     [&](const edit::Operation& operation) { return is_for(operation, deed); });
}

/// Reads the orders of a text one behind the other.
class LearnedReader {
 public:
  LearnedReader(const EditText& text, const std::vector<WordSigns>& signs, const RoleModel& model)
      : text_(text), signs_(signs), model_(model), so_far_({without_words(text), {}, {}}) {}

  Result<Understanding> run() {
    const auto stretches = stretches_of(roles());
    if (leaves_words_unread(text_, signs_, stretches)) return not_understood("it is not clear what shall be done");
    const auto orders = orders_of(text_, stretches);
    for (std::size_t i = 0; i < orders.size(); ++i) {
      const auto& order = orders[i];
      for (const auto& remark : order.remarks) {
        if (has_orders_before(orders, i, remark) && may_ask(text_, remark))
          return what_at(text_, remark.begin, "it is not clear what is meant");
        hear(remark);
      }
      if (order.parts.empty()) continue;
      const bool is_taken_up = i + 1 < orders.size() && speaks_of_it(orders[i + 1]);
      const ReadDeed said = read_deed(model_, text_, signs_, order, previous_);
      const bool is_denial = is_denied(text_, order) && said.deed != EditDeed::lock && said.deed != EditDeed::remove;
      if (is_taken_up && (is_mere_mention(order) || is_denial)) {
        hear({EditRole::idle, order.parts.front().begin, order.parts.back().end});
        continue;
      }
      if (is_denial || !is_evident(text_, order, said))
        return what_at(text_, order.parts.front().begin, "it is not clear what shall be done");
      previous_ = deed_names[static_cast<std::size_t>(said.deed)];
      if (const auto failed = read(order, said.deed)) return *failed;
    }
    if (so_far_->gathered.operations.empty()) return not_understood("nothing in it says what to change");
    return Understanding{so_far_->gathered.settled(), std::move(so_far_->remarks)};
  }

 private:
  // What is left out of what is changed says which is meant: "except the desk".
  std::vector<EditRole> roles() const {
    auto roles = read_roles(model_, text_, signs_);
    for (const auto& stretch : stretches_of(roles))
      if (stretch.role == EditRole::keep && longest_in(text_.edits.except, text_.tokens, stretch.begin) > 0)
        std::fill(roles.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
                  roles.begin() + static_cast<std::ptrdiff_t>(stretch.end), EditRole::thing);
    return roles;
  }

  static bool has_orders_before(const std::vector<SpokenOrder>& orders, std::size_t at, const RoleStretch& remark) {
    return at > 0 || (!orders[at].parts.empty() && orders[at].parts.front().begin < remark.begin);
  }

  // "we'd never have had the stool sitting there; slide it …"
  static bool is_mere_mention(const SpokenOrder& order) {
    return order.has(EditRole::thing) && std::all_of(order.parts.begin(), order.parts.end(), [](const RoleStretch& part) {
             return part.role == EditRole::thing || part.role == EditRole::order;
           });
  }

  bool speaks_of_it(const SpokenOrder& order) const {
    return std::none_of(order.parts.begin(), order.parts.end(), [&](const RoleStretch& part) {
      return part.role == EditRole::thing && longest_in(text_.edits.pronouns, text_.tokens, part.begin) == 0;
    });
  }

  void hear(const RoleStretch& remark) {
    const auto plain = without_marks(text_, remark);
    if (plain.begin == plain.end) return;
    auto& words = so_far_->text;
    append_words(words, text_, plain.begin, plain.end);
    so_far_->speak_of(0, words.tokens.size());
    so_far_->note_remark(0, words.tokens.size());
    clear_words(words);
  }

  std::optional<Error> read(const SpokenOrder& spoken, EditDeed deed) {
    auto said = read_as_said(spoken, deed);
    if (said) return so_far_.emplace(*std::move(said)), std::nullopt;
    auto by_parts = read_by_parts(spoken, deed);
    if (!by_parts) return by_parts.error();
    so_far_.emplace(*std::move(by_parts));
    return std::nullopt;
  }

  OrderWords words(const SpokenOrder& spoken) const { return {text_, so_far_->text, spoken}; }
  ReadSoFar with_words(EditText text) const { return {std::move(text), so_far_->gathered, so_far_->remarks}; }

  Result<ReadSoFar> read_as_said(const SpokenOrder& spoken, EditDeed deed) const {
    OrderWords all = words(spoken);
    for (const auto& part : spoken.parts) all.add(part);
    auto read = read_on(with_words(all.taken()));
    if (!read) return read.error();
    if (!are_for(read->gathered.operations, so_far_->gathered.operations.size(), deed))
      return not_understood("not understood");
    clear_words(read->text);
    return read;
  }

  Result<ReadSoFar> read_by_parts(const SpokenOrder& spoken, EditDeed deed) const {
    Error failed = not_understood("it is not clear what shall be done");
    for (EditText& said : wordings(spoken, deed)) {
      auto clause = read_parts(said, deed);
      if (is_whole(said, clause) && are_for(clause->operations, 0, deed)) return taken(std::move(said), *clause);
      failed = clause ? what_at(said, clause->end, "not understood") : clause.error();
    }
    if (deed == EditDeed::add) return read_addition(spoken, std::move(failed));
    if (auto cover = read_cover(text_, spoken); cover && are_for(cover->operations, 0, deed))
      return taken(without_words(so_far_->text), *cover);
    auto things = words(spoken).add_things().taken();
    const auto what = roomgen::things(things, 0, true);
    if (!what || what->end < things.tokens.size()) return failed;
    const auto clause = read_order_of(text_, spoken, deed, what->value);
    return clause ? taken(std::move(things), *clause) : Result<ReadSoFar>(failed);
  }

  // What such a thing is like may be said apart from it.
  Result<ReadSoFar> read_addition(const SpokenOrder& spoken, Error failed) const {
    using enum EditRole;
    const std::string looks = looks_apart(text_, spoken);
    std::vector<EditText> all = {words(spoken).add_all({thing, place, target}).taken()};
    const auto where = spoken.has(target) ? read_place_words(model_, text_, signs_, spoken, EditDeed::add) : std::nullopt;
    if (where) all.push_back(words(spoken).add_all({thing}).say_all(place_words[*where]).add_all({target}).taken());
    for (EditText& said : all) {
      auto clause = read_add(said, 0);
      if (!is_whole(said, clause) || !are_for(clause->operations, 0, EditDeed::add)) continue;
      for (auto& operation : clause->operations)
        if (auto& add = std::get<edit::Add>(operation); !looks.empty()) add.description += " " + looks;
      return taken(std::move(said), *clause);
    }
    return failed;
  }

  ReadSoFar taken(EditText said, const Clause& clause) const {
    ReadSoFar next = with_words(std::move(said));
    next.take(clause, 0);
    clear_words(next.text);
    return next;
  }

  std::vector<EditText> wordings(const SpokenOrder& spoken, EditDeed deed) const {
    using enum EditRole;
    switch (deed) {
      case EditDeed::add: return {words(spoken).add_all({thing, look, amount, place, target}).taken()};
      case EditDeed::remove:
      case EditDeed::lock:
      case EditDeed::unlock: return {words(spoken).add_things().add_all({place, target}).taken()};
      case EditDeed::face:
        return {words(spoken).add_things().say("facing").add_all({target}).taken(),
                words(spoken).add_things().add_all({place, target, amount}).taken()};
      case EditDeed::swap: return {words(spoken).add_things().say("and").add_all({target, look}).taken(),
                               words(spoken).add_things().taken()};
      case EditDeed::replace: return {words(spoken).add_things().say("with").add_all({look}).taken()};
      case EditDeed::resize:
      case EditDeed::recolour: return {words(spoken).add_things().add_all({amount, look, place, target}).taken()};
      case EditDeed::move: return wordings_of_move(spoken);
      default:
        return {words(spoken).add_things().add_all({amount, place, target, look}).taken(),
                words(spoken).add_things().add_all({place, target}).add_all({amount}).taken()};
    }
  }

  std::vector<EditText> wordings_of_move(const SpokenOrder& spoken) const {
    using enum EditRole;
    std::vector<EditText> all = {words(spoken).add_things().add_all({amount, place, target, look}).taken(),
                                 words(spoken).add_things().add_all({place, target}).add_all({amount}).taken(),
                                 words(spoken).add_things().add_lengths().add_all({place, target}).taken()};
    const auto place_said = spoken.has(target) ? read_place_words(model_, text_, signs_, spoken, EditDeed::move) : std::nullopt;
    if (place_said)
      all.push_back(words(spoken).add_things().add_lengths().say_all(place_words[*place_said]).add_all({target}).taken());
    return all;
  }

  ReadClause read_parts(const EditText& said, EditDeed deed) const {
    switch (deed) {
      case EditDeed::add: return read_add(said, 0);
      case EditDeed::remove: return read_verb(said, "remove", "remove", 0);
      case EditDeed::move: return read_put(said, 0, false);
      case EditDeed::turn:
      case EditDeed::face: return read_turn(said, 0);
      case EditDeed::swap: return read_swap(said, 0);
      case EditDeed::replace: return read_replace(said, 0);
      case EditDeed::resize: return read_verb(said, "make", "make", 0);
      case EditDeed::recolour: return read_looks(said, 0);
      case EditDeed::lock:
      case EditDeed::unlock: return read_lock(said, 0, deed == EditDeed::lock, false);
      case EditDeed::rearrange: return read_verb(said, "rearrange", "rearrange", 0);
      case EditDeed::room: return what_at(said, 0, "it is not clear how the room shall change");
      case EditDeed::undo: return Clause{{edit::Revert{}}, {}, {}, said.tokens.size()};
    }
    return what_at(said, 0, "not understood");
  }

  const EditText& text_;
  const std::vector<WordSigns>& signs_;
  const RoleModel& model_;
  std::optional<ReadSoFar> so_far_;
  std::string_view previous_;
};

}  // namespace

// Which words matter to a model it has by chance where it knows few of them: then another one says otherwise.
Result<Understanding> read_by_roles(const EditText& text) {
  const auto signs = signs_of(text);
  auto understood = LearnedReader(text, signs, role_model(0)).run();
  for (std::size_t member = 1; understood && member < role_model_count; ++member) {
    const auto other = LearnedReader(text, signs, role_model(member)).run();
    if (other && other->operations == understood->operations) return understood;
  }
  return understood ? not_understood("it may be understood in several ways; say it more plainly") : understood.error();
}

}  // namespace roomgen
