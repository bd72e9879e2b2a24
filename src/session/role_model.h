#pragma once

#include <functional>
#include <optional>

#include "edit_roles.h"
#include "language/linear_model.h"
#include "role_features.h"

namespace roomgen {

/// What is learned from data/language/edits: which role a word has, and what an order is for. Both are sums of
/// weights, learned by an averaged perceptron; roles are the best of a beam from left to right.
class RoleModel {
 public:
  explicit RoleModel(std::string_view bytes) : weights_(bytes, magic) {}

  /// The sums of the labels' weights.
  std::array<int, role_label_count> sums(const Features& features) const;

  static constexpr std::string_view magic = "roomgen edit roles 1\n";

 private:
  language::LinearModel weights_;
};

/// A committee: the first member has learned from all sentences, the others each from two thirds of them.
inline constexpr std::size_t role_model_count = 3;
const RoleModel& role_model(std::size_t member);

/// Sums of weights by label, for features.
template <typename Number>
using SumsOf = std::function<std::array<Number, role_label_count>(const Features&)>;

/// The roles of a text's words.
template <typename Number>
std::vector<EditRole> best_roles(const EditText& text, const std::vector<WordSigns>& signs, const SumsOf<Number>& sums);

extern template std::vector<EditRole> best_roles<int>(const EditText&, const std::vector<WordSigns>&, const SumsOf<int>&);
extern template std::vector<EditRole> best_roles<double>(const EditText&, const std::vector<WordSigns>&, const SumsOf<double>&);

std::vector<EditRole> read_roles(const RoleModel& model, const EditText& text, const std::vector<WordSigns>& signs);
struct ReadDeed {
  EditDeed deed = EditDeed::move;
  int lead = 0;  ///< over the second best
};
ReadDeed read_deed(const RoleModel& model, const EditText& text, const std::vector<WordSigns>& signs,
                   const SpokenOrder& order, std::string_view previous);
/// The number of the place in `place_names` that an order's words of place say, where one is clearly the likeliest.
std::optional<std::size_t> read_place_words(const RoleModel& model, const EditText& text,
                                            const std::vector<WordSigns>& signs, const SpokenOrder& order, EditDeed deed);

}  // namespace roomgen
