#include "role_model.h"

#include <algorithm>
#include <limits>

extern "C" {
extern const unsigned char roomgen_edit_roles_0[], roomgen_edit_roles_1[], roomgen_edit_roles_2[];
extern const std::uint64_t roomgen_edit_roles_0_size, roomgen_edit_roles_1_size, roomgen_edit_roles_2_size;
}

namespace roomgen {

std::array<int, role_label_count> RoleModel::sums(const Features& features) const {
  std::array<int, role_label_count> all{};
  for (const auto feature : features) weights_.add_to(all, feature);
  return all;
}

const RoleModel& role_model(std::size_t member) {
  const auto model_of = [](const unsigned char* bytes, std::uint64_t size) {
    return RoleModel(std::string_view(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)));
  };
  static const std::array<RoleModel, role_model_count> built_in = {
      model_of(roomgen_edit_roles_0, roomgen_edit_roles_0_size),
      model_of(roomgen_edit_roles_1, roomgen_edit_roles_1_size),
      model_of(roomgen_edit_roles_2, roomgen_edit_roles_2_size)};
  return built_in[member];
}

namespace {

constexpr std::size_t beam_width = 24;

template <typename Number>
struct Reading {
  Number sum{};
  RoleContext context;
  std::vector<EditRole> roles;
};

// Of readings after which all that comes is the same only the best can win.
template <typename Number>
void keep_best(std::vector<Reading<Number>>& beam) {
  std::stable_sort(beam.begin(), beam.end(), [](const auto& a, const auto& b) { return a.sum > b.sum; });
  std::vector<Reading<Number>> kept;
  for (auto& reading : beam) {
    const bool is_known = std::any_of(kept.begin(), kept.end(),
                                      [&](const auto& other) { return other.context == reading.context; });
    if (!is_known) kept.push_back(std::move(reading));
    if (kept.size() == beam_width) break;
  }
  beam = std::move(kept);
}

template <typename Number>
std::vector<Reading<Number>> longer_by_one(const EditText& text, const std::vector<WordSigns>& signs,
                                           const std::vector<Reading<Number>>& beam, std::size_t at,
                                           const SumsOf<Number>& sums) {
  const auto by_word = sums(word_features(signs, at));
  const bool ends_sentence = text.tokens[at].kind == design::Token::Kind::stop;
  std::vector<Reading<Number>> longer;
  for (const auto& reading : beam) {
    const auto by_context = sums(context_features(signs, at, reading.context));
    for (std::size_t role = 0; role < edit_role_count; ++role) {
      Reading<Number> next = reading;
      next.sum += by_word[role] + by_context[role];
      next.roles.push_back(static_cast<EditRole>(role));
      next.context.add(next.roles.back(), ends_sentence);
      longer.push_back(std::move(next));
    }
  }
  return longer;
}

}  // namespace

template <typename Number>
std::vector<EditRole> best_roles(const EditText& text, const std::vector<WordSigns>& signs, const SumsOf<Number>& sums) {
  std::vector<Reading<Number>> beam(1);
  for (std::size_t at = 0; at < signs.size(); ++at) {
    beam = longer_by_one(text, signs, beam, at, sums);
    keep_best(beam);
  }
  return std::move(beam.front().roles);
}

template std::vector<EditRole> best_roles<int>(const EditText&, const std::vector<WordSigns>&, const SumsOf<int>&);
template std::vector<EditRole> best_roles<double>(const EditText&, const std::vector<WordSigns>&, const SumsOf<double>&);

std::vector<EditRole> read_roles(const RoleModel& model, const EditText& text, const std::vector<WordSigns>& signs) {
  return best_roles<int>(text, signs, [&](const Features& features) { return model.sums(features); });
}

ReadDeed read_deed(const RoleModel& model, const EditText& text, const std::vector<WordSigns>& signs,
                   const SpokenOrder& order, std::string_view previous) {
  const auto sums = model.sums(deed_features(text, signs, order, previous));
  const auto first = sums.begin() + first_deed, end = sums.begin() + first_place;
  const auto best = std::max_element(first, end);
  int second = std::numeric_limits<int>::min();
  for (auto other = first; other != end; ++other)
    if (other != best) second = std::max(second, *other);
  return {static_cast<EditDeed>(best - first), *best - second};
}

namespace {

constexpr int clear_lead = 512;  // twice the weight of what is learned from one mistake

}  // namespace

std::optional<std::size_t> read_place_words(const RoleModel& model, const EditText& text,
                                            const std::vector<WordSigns>& signs, const SpokenOrder& order, EditDeed deed) {
  const auto sums = model.sums(place_features(text, signs, order, deed));
  const auto best = std::max_element(sums.begin() + first_place, sums.end());
  for (auto other = sums.begin() + first_place; other != sums.end(); ++other)
    if (other != best && *best - *other < clear_lead) return std::nullopt;
  return static_cast<std::size_t>(best - sums.begin()) - first_place;
}

}  // namespace roomgen
