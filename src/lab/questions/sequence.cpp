#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "site.h"

namespace roomgen::lab::detail {

namespace {

constexpr std::size_t ordered = 3, offered = 4;

using Things = std::vector<const Reference*>;

const Appearance& seen(const QuestionSite& site, const Reference* reference) { return site.seen[reference->object]; }

bool surely_before(const QuestionSite& site, const Reference* a, const Reference* b) {
  return seen(site, a).surely_before(seen(site, b));
}

// The first frame after `frame` at which an object fills so much of the picture.
std::size_t next_with(const QuestionSite& site, std::size_t object, std::size_t frame, double share) {
  for (std::size_t later = frame + 1; later < site.frames.size(); ++later)
    if (site.share(later, object) >= share) return later;
  return Appearance::never;
}

// Drawn without repetition, in the order of their words.
Things drawn(const QuestionSite& site, Random& random, std::size_t count) {
  Things all = site.references.all();
  std::erase_if(all, [&](const Reference* one) { return !seen(site, one).is_seen(); });
  random.shuffle(all);
  if (all.size() < count) return {};
  all.resize(count);
  std::sort(all.begin(), all.end(), [](const Reference* a, const Reference* b) { return a->text < b->text; });
  return all;
}

std::vector<std::size_t> first_frames(const QuestionSite& site, const Things& things) {
  std::vector<std::size_t> frames;
  for (const Reference* one : things) frames.push_back(seen(site, one).first_seen);
  return frames;
}

std::string order_text(const Things& things) {
  std::vector<std::string> texts;
  for (const Reference* one : things) texts.push_back(one->text);
  return join(texts, ", then ");
}

Json ids_of(const QuestionSite& site, const Things& things) {
  Json ids = Json::array();
  for (const Reference* one : things) ids.push_back(site.object(one->object).id);
  return ids;
}

// Other orders of the same things.
std::vector<std::string> other_orders(Random& random, Things things) {
  const std::string right = order_text(things);
  std::vector<std::string> orders;
  std::sort(things.begin(), things.end());
  do
    if (const auto text = order_text(things); text != right) orders.push_back(text);
  while (std::next_permutation(things.begin(), things.end()));
  std::sort(orders.begin(), orders.end());
  random.shuffle(orders);
  orders.resize(std::min(orders.size(), offered - 1));
  return orders;
}

// Do they ask one thing, in other words or with other choices?
bool same_question(const SpatialQuestion& one, const SpatialQuestion& other) {
  const auto& a = one.arguments;
  const auto& b = other.arguments;
  if (a.contains("a") && a.contains("b")) return a.at("a") == b.at("a") && a.at("b") == b.at("b") && a.at("right") == b.at("right");
  return one.text == other.text && one.objects == other.objects;
}

template <typename Make>
std::vector<SpatialQuestion> tried(const QuestionSite& site, const Make& make) {
  std::vector<SpatialQuestion> questions;
  for (std::size_t tries = tries_for_one * site.most; tries > 0 && questions.size() < site.most; --tries) {
    auto question = make();
    if (!question) continue;
    const bool known = std::any_of(questions.begin(), questions.end(), [&](const SpatialQuestion& other) {
      return same_question(other, *question);
    });
    if (!known) questions.push_back(std::move(*question));
  }
  return questions;
}

}  // namespace

std::vector<SpatialQuestion> order_questions(const QuestionSite& site, Random& random) {
  return tried(site, [&]() -> std::optional<SpatialQuestion> {
    const Things things = drawn(site, random, ordered);
    Things sorted = things;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const Reference* a, const Reference* b) {
      return seen(site, a).first_seen < seen(site, b).first_seen;
    });
    for (std::size_t k = 1; k < sorted.size(); ++k)
      if (!surely_before(site, sorted[k - 1], sorted[k])) return std::nullopt;
    if (sorted.empty()) return std::nullopt;
    std::vector<std::string> texts;
    for (const Reference* one : things) texts.push_back(one->text);
    const QuestionDraft draft{"order", {}, {{"list", join(texts, ", ")}}, things, first_frames(site, things),
                      {{"order", ids_of(site, sorted)}}};
    return choice_question(site, random, draft, order_text(sorted), other_orders(random, sorted));
  });
}

// From the beginning on, large things come first, and who knows that needs no video. So it is asked of what comes after
// a stop of the camera.
std::vector<SpatialQuestion> first_questions(const QuestionSite& site, Random& random) {
  auto stops = stops_of(site);
  if (stops.size() < 2) return {};
  stops.pop_back();
  return tried(site, [&]() -> std::optional<SpatialQuestion> {
    const std::size_t stop = random.pick(stops);
    const auto& looked_at = site.references.of(target_of(site, stop));
    const Things things = drawn(site, random, offered);
    if (!looked_at || looked_at->by_time || things.empty()) return std::nullopt;
    const auto next = [&](const Reference* one, double share) { return next_with(site, one->object, stop, share); };
    const auto& limits = question_forms().limits;
    const Reference* right = *std::min_element(things.begin(), things.end(), [&](const Reference* a, const Reference* b) {
      return next(a, limits.seen) < next(b, limits.seen);
    });
    const std::size_t when = next(right, limits.seen);
    if (when == Appearance::never) return std::nullopt;
    std::vector<std::string> wrong;
    for (const Reference* one : things) {
      if (one->object == looked_at->object || site.share(stop, one->object) >= limits.faint) return std::nullopt;
      if (one == right) continue;
      if (next(one, limits.faint) <= when) return std::nullopt;
      wrong.push_back(one->text);
    }
    const QuestionDraft draft{"first", {{"a", &*looked_at}}, {}, things, {stop, when},
                      {{"frame", site.frames[stop].frame.number}, {"right", site.object(right->object).id}, {"of", ids_of(site, things)}}};
    return choice_question(site, random, draft, right->text, wrong);
  });
}

// Of five things in a row the second to fourth may be between the two that are named.
std::vector<SpatialQuestion> between_questions(const QuestionSite& site, Random& random) {
  return tried(site, [&]() -> std::optional<SpatialQuestion> {
    Things things = drawn(site, random, offered + 1);
    std::stable_sort(things.begin(), things.end(), [&](const Reference* a, const Reference* b) {
      return seen(site, a).first_seen < seen(site, b).first_seen;
    });
    if (things.empty()) return std::nullopt;
    const auto start = static_cast<std::size_t>(random.integer(0, static_cast<int>(offered) - 2));
    const Reference *a = things[start], *right = things[start + 1], *b = things[start + 2];
    if (!surely_before(site, a, right) || !surely_before(site, right, b)) return std::nullopt;
    std::vector<std::string> wrong;
    for (const Reference* one : things) {
      if (one == a || one == b || one == right) continue;
      if (!surely_before(site, one, a) && !surely_before(site, b, one)) return std::nullopt;
      wrong.push_back(one->text);
    }
    const QuestionDraft draft{"between", {{"a", a}, {"b", b}}, {}, things, first_frames(site, things),
                      {{"right", site.object(right->object).id}, {"of", ids_of(site, things)}}};
    return choice_question(site, random, draft, right->text, wrong);
  });
}

}  // namespace roomgen::lab::detail
