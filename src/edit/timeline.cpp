#include "timeline.h"

#include <algorithm>
#include <deque>

#include "base/sha256.h"
#include "roomgen/scene/scene.h"
#include "scene_patch.h"

namespace roomgen {

namespace {

// Snapshots lie far closer; so many changes of the largest scene take some ten seconds.
constexpr std::size_t most_steps = 20'000;

bool makes_state(const JournalEntry& entry) {
  return entry.kind == JournalEntry::Kind::edit || entry.kind == JournalEntry::Kind::scene;
}

Error damaged(std::size_t sequence, const std::string& why) {
  return {Error::Kind::invalid_input, "state " + std::to_string(sequence) + " cannot be made again: " + why};
}

}  // namespace

SceneState state_of(std::size_t sequence, Json document) {
  std::string text = dump_json(document);
  return {sequence, std::move(document), std::move(text)};
}

Result<SceneState> state_of_text(std::size_t sequence, std::string text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  const auto scene = scene_from_json(*json, source);
  if (!scene) return scene.error();
  return SceneState{sequence, to_json(*scene), std::move(text)};
}

std::string hash_of(const SceneState& state) { return sha256_hex(state.text); }

void Timeline::add(JournalEntry entry) {
  const std::size_t sequence = entry.sequence;
  if (entry.kind == JournalEntry::Kind::snapshot) {
    snapshots_[entry.to] = sequence;
    entries_[sequence] = std::move(entry);
    return;
  }
  if (!current_.empty()) head_before_ = head();
  current_ = entry.branch;
  Branch& branch = branches_[current_];
  if (makes_state(entry)) {
    if (entry.parent > 0) {
      children_.emplace(entry.parent, sequence);
      descents_[sequence] = below(entry.parent);
    }
    branch.head = branch.tip = sequence;
  } else {
    branch.head = entry.to;
    const auto last = branch.tip;
    if (last != branch.head && !after(branch.head, last)) branch.tip = branch.head;
  }
  entries_[sequence] = std::move(entry);
}

std::size_t Timeline::head() const {
  const auto found = branches_.find(current_);
  return found == branches_.end() ? 0 : found->second.head;
}

bool Timeline::knows(std::size_t sequence) const {
  const auto found = entries_.find(sequence);
  return (found != entries_.end() && makes_state(found->second)) || children_.count(sequence) > 0;
}

std::optional<std::size_t> Timeline::before(std::size_t sequence) const {
  const auto found = entries_.find(sequence);
  if (found == entries_.end() || found->second.parent == 0) return std::nullopt;
  return found->second.parent;
}

Timeline::Descent Timeline::descent(std::size_t sequence) const {
  const auto found = descents_.find(sequence);
  return found == descents_.end() ? Descent{0, sequence} : found->second;
}

// Jumps twice as long wherever two of one length meet (Myers, "An applicative random-access stack", 1983): any state before is
// a logarithm of them away.
Timeline::Descent Timeline::below(std::size_t parent) const {
  const Descent one = descent(parent), two = descent(one.jump);
  const bool are_alike = one.depth - two.depth == two.depth - descent(two.jump).depth;
  return {one.depth + 1, are_alike ? two.jump : parent};
}

// The state at that depth on the way back.
std::size_t Timeline::ancestor(std::size_t sequence, std::size_t depth) const {
  for (Descent at = descent(sequence); at.depth > depth; at = descent(sequence))
    sequence = descent(at.jump).depth >= depth ? at.jump : entries_.at(sequence).parent;
  return sequence;
}

std::optional<std::size_t> Timeline::after(std::size_t sequence, std::size_t tip) const {
  const std::size_t depth = descent(sequence).depth + 1;
  if (descent(tip).depth < depth) return std::nullopt;
  const std::size_t next = ancestor(tip, depth);
  return before(next) == sequence ? std::optional(next) : std::nullopt;
}

std::string Timeline::hash(std::size_t sequence) const {
  if (const auto found = entries_.find(sequence); found != entries_.end()) return found->second.after;
  const auto [first, last] = children_.equal_range(sequence);
  for (auto child = first; child != last; ++child)
    if (const auto& before = entries_.at(child->second).before; !before.empty()) return before;
  return "";
}

bool Timeline::is_written(std::size_t sequence, const SceneState& known) const {
  if (!known.text.empty() && sequence == known.sequence) return true;
  const auto found = entries_.find(sequence);
  return snapshots_.count(sequence) > 0 || (found != entries_.end() && found->second.kind == JournalEntry::Kind::scene);
}

Result<SceneState> Timeline::written(std::size_t sequence, const SceneState& known) const {
  if (!known.text.empty() && sequence == known.sequence) return known;
  const auto snapshot = snapshots_.find(sequence);
  const JournalEntry& entry = entries_.at(snapshot == snapshots_.end() ? sequence : snapshot->second);
  return state_of_text(sequence, entry.text, "state " + std::to_string(sequence));
}

// Along edits, whose change is known in both directions.
std::vector<Timeline::Step> Timeline::steps_from(std::size_t sequence) const {
  std::vector<Step> steps;
  const auto own = entries_.find(sequence);
  if (own != entries_.end() && own->second.kind == JournalEntry::Kind::edit)
    steps.push_back({own->second.parent, &own->second, true});
  const auto [first, last] = children_.equal_range(sequence);
  for (auto child = first; child != last; ++child)
    if (const auto& entry = entries_.at(child->second); entry.kind == JournalEntry::Kind::edit)
      steps.push_back({child->second, &entry, false});
  return steps;
}

// The shortest way from a state that is written out (`start`); breadth first.
std::vector<Timeline::Step> Timeline::way_to(std::size_t sequence, const SceneState& known, std::size_t& start) const {
  std::map<std::size_t, Step> onward;  // by state: the step from it that leads nearer to the end
  std::deque<std::size_t> open = {sequence};
  onward[sequence] = {};
  while (!open.empty()) {
    const auto at = open.front();
    open.pop_front();
    if (is_written(at, known)) {
      start = at;
      std::vector<Step> way;
      for (auto here = at; here != sequence; here = way.back().to) way.push_back(onward[here]);
      return way;
    }
    for (const auto& step : steps_from(at))
      if (!onward.count(step.to)) {
        onward[step.to] = {at, step.edit, !step.backward};
        open.push_back(step.to);
      }
  }
  start = 0;
  return {};
}

Result<SceneState> Timeline::state(std::size_t sequence, const SceneState& known) const {
  if (!knows(sequence)) return Error{Error::Kind::not_found, "there is no state " + std::to_string(sequence)};
  std::size_t start = 0;
  const auto way = way_to(sequence, known, start);
  if (start == 0) return damaged(sequence, "the journal is damaged around it");
  if (way.size() > most_steps)
    return damaged(sequence, "it is more than " + std::to_string(most_steps) + " changes from one that is written out");
  auto state = written(start, known);
  if (!state) return damaged(sequence, state.error().message);
  for (const auto& step : way) {
    const auto patch = parse_json(step.edit->patch, "its patch");
    if (!patch) return damaged(sequence, patch.error().message);
    auto document = apply_patch(std::move(state->document), step.backward ? inverse_patch(*patch) : *patch);
    if (!document) return damaged(sequence, document.error().message);
    // Only the last text is wanted.
    state = step.to == sequence ? state_of(step.to, *std::move(document))
                                : SceneState{step.to, *std::move(document), ""};
  }
  if (const auto expected = hash(sequence); !expected.empty() && hash_of(*state) != expected)
    return damaged(sequence, "what comes out is not what was there");
  return state;
}

}  // namespace roomgen
