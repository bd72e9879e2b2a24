#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <utility>

#include "complexity.h"
#include "compose_steps.h"
#include "roomgen/base/text.h"

namespace roomgen::lab::compose {

namespace {

using Ids = std::set<std::string, std::less<>>;

std::string id_of(const std::string& measure) { return "measure-" + measure; }

bool says_anything(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '%' || c >= 0x80; });
}

/// Cuts an entry that nobody understood at the ends of spans.
class Cutter {
 public:
  Cutter(const Heard& entry, std::string_view prompt) : entry_(entry), prompt_(prompt), at_(entry.begin) {}

  void cut(const MeasureSpan& said) {
    const std::size_t begin = std::max<std::size_t>(said.span.begin, at_), end = std::min<std::size_t>(said.span.end, entry_.end);
    if (begin >= end) return;
    add(begin, Heard::As::not_understood, {});
    add(end, Heard::As::count, {id_of(said.measure)});
  }

  std::vector<Heard> take() {
    add(entry_.end, Heard::As::not_understood, {});
    return std::move(pieces_);
  }

 private:
  void add(std::size_t end, Heard::As as, std::vector<std::string> requirements) {
    const auto is_space = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(prompt_[i])) != 0; };
    std::size_t begin = std::exchange(at_, end);
    while (begin < end && is_space(begin)) ++begin;
    while (begin < end && is_space(end - 1)) --end;
    std::string text(prompt_.substr(begin, end - begin));
    if (says_anything(text)) pieces_.push_back({begin, end, std::move(text), as, std::move(requirements)});
  }

  const Heard& entry_;
  std::string_view prompt_;
  std::size_t at_;  ///< bytes before it are in pieces
  std::vector<Heard> pieces_;
};

const MeasureSpan* span_around(const Heard& entry, const std::vector<MeasureSpan>& spans) {
  const auto found = std::ranges::find_if(spans, [&](const MeasureSpan& said) {
    return said.span.begin <= entry.begin && entry.end <= said.span.end;
  });
  return found == spans.end() ? nullptr : &*found;
}

// What nothing measures of the room, and what is counted in vain ("seats" that are no kind of thing), where only words
// say so that measures understand.
Ids misheard(const Scene& scene, const std::vector<MeasureSpan>& spans) {
  Ids ids;
  for (const auto& [requirement, compliance, reason] : scene.requirements)
    if ((requirement.kind == Requirement::Kind::room && compliance == Compliance::not_judged) ||
        (requirement.kind == Requirement::Kind::count && compliance == Compliance::not_met))
      ids.insert(requirement.id);
  for (const auto& entry : scene.heard)
    if (!span_around(entry, spans))
      for (const auto& id : entry.requirements) ids.erase(id);
  return ids;
}

RequirementVerdict verdict_on(const MeasureVerdict& measure) {
  Requirement requirement;
  requirement.id = id_of(measure.name);
  requirement.kind = Requirement::Kind::room;
  requirement.attribute = measure.name;
  requirement.amount = measure.asked.low;
  requirement.clause = measure.name + ": " + range_text(measure.asked);
  RequirementVerdict verdict{requirement, measure.missed > 0.0 ? Compliance::not_met : Compliance::met, ""};
  if (!verdict.met()) verdict.reason = format_number(measure.reached, 2) + " is reached";
  return verdict;
}

std::vector<Heard> with_spans(std::vector<Heard> heard, std::string_view prompt, const std::vector<MeasureSpan>& spans,
                              const Ids& gone) {
  std::vector<Heard> result;
  for (auto& entry : heard) {
    if (entry.as == Heard::As::not_understood && entry.end <= prompt.size()) {
      Cutter cutter(entry, prompt);
      for (const auto& said : spans) cutter.cut(said);
      std::ranges::move(cutter.take(), std::back_inserter(result));
      continue;
    }
    const bool names_gone = std::ranges::any_of(entry.requirements, [&](const auto& id) { return gone.contains(id); });
    std::erase_if(entry.requirements, [&](const auto& id) { return gone.contains(id); });
    if (const auto* said = span_around(entry, spans); said && entry.requirements.empty()) {
      if (names_gone || entry.as == Heard::As::person) entry.as = Heard::As::count;
      entry.requirements.push_back(id_of(said->measure));
    }
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace

void hear_measures(Scene& scene, std::string_view prompt, const std::vector<MeasureVerdict>& measures) {
  auto spans = complexity_spans(prompt);
  // Those that an option overrides are measured all the same.
  std::erase_if(spans, [&](const MeasureSpan& said) {
    return std::ranges::find(measures, said.measure, &MeasureVerdict::name) == measures.end();
  });
  const Ids gone = misheard(scene, spans);
  std::erase_if(scene.requirements, [&](const auto& verdict) { return gone.contains(verdict.requirement.id); });
  for (const auto& measure : measures) scene.requirements.push_back(verdict_on(measure));
  scene.heard = with_spans(std::move(scene.heard), prompt, spans, gone);
}

}  // namespace roomgen::lab::compose
