#include "train/learn_roles.h"

#include <algorithm>
#include <unordered_map>

#include "language/train/averaged_weights.h"
#include "role_model.h"

namespace roomgen {

namespace {

constexpr int rounds = 15;
constexpr int fewest = 2;  // places of the corpus where a feature has to occur

using Sums = std::array<double, role_label_count>;

class RoleLearner {
 public:
  explicit RoleLearner(const std::vector<MarkedEdit>& edits) : edits_(edits) {
    std::unordered_map<std::uint32_t, int> occurrences;
    const auto count = [&](const Features& features) {
      for (const auto feature : features) ++occurrences[feature];
    };
    for (const auto& edit : edits) {
      along(edit, edit.roles, [&](std::size_t at, const RoleContext& context) {
        count(word_features(edit.signs, at));
        count(context_features(edit.signs, at, context));
      });
      for (const auto& order : edit.orders) {
        count(deed_features(edit.text, edit.signs, order.order, order.previous));
        if (order.place) count(place_features(edit.text, edit.signs, order.order, order.deed));
      }
    }
    for (const auto& [feature, times] : occurrences)
      if (times >= fewest) weights_.know(feature);
  }

  void run() {
    language::LearningOrder order(edits_.size());
    for (int round = 0; round < rounds; ++round)
      for (const auto i : order.next()) learn(edits_[i]);
  }

  std::string bytes() const { return weights_.bytes(RoleModel::magic); }

 private:
  template <typename Visit>
  static void along(const MarkedEdit& edit, const std::vector<EditRole>& roles, const Visit& visit) {
    RoleContext context;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      visit(i, context);
      context.add(roles[i], edit.text.tokens[i].kind == design::Token::Kind::stop);
    }
  }

  Sums sums(const Features& features) const {
    Sums all{};
    for (const auto feature : features) weights_.add_to(all, feature);
    return all;
  }

  void change(const Features& features, std::size_t label, double by) {
    for (const auto feature : features) weights_.change(feature, label, by);
  }

  void learn(const MarkedEdit& edit) {
    weights_.step();
    const auto said = best_roles<double>(edit.text, edit.signs, [&](const Features& f) { return sums(f); });
    if (said != edit.roles) {
      follow(edit, said, -1.0);
      follow(edit, edit.roles, 1.0);
    }
    for (const auto& order : edit.orders) {
      learn(deed_features(edit.text, edit.signs, order.order, order.previous), first_deed, first_place,
            static_cast<std::size_t>(order.deed));
      if (order.place)
        learn(place_features(edit.text, edit.signs, order.order, order.deed), first_place, role_label_count,
              *order.place);
    }
  }

  void follow(const MarkedEdit& edit, const std::vector<EditRole>& roles, double by) {
    along(edit, roles, [&](std::size_t at, const RoleContext& context) {
      const auto role = static_cast<std::size_t>(roles[at]);
      change(word_features(edit.signs, at), role, by);
      change(context_features(edit.signs, at, context), role, by);
    });
  }

  // Which of some labels, from the first one on, is right.
  void learn(const Features& features, std::size_t first, std::size_t end, std::size_t right) {
    const Sums all = sums(features);
    const auto best = std::max_element(all.begin() + static_cast<std::ptrdiff_t>(first),
                                       all.begin() + static_cast<std::ptrdiff_t>(end));
    const auto said = static_cast<std::size_t>(best - all.begin());
    if (said == first + right) return;
    change(features, said, -1.0);
    change(features, first + right, 1.0);
  }

  const std::vector<MarkedEdit>& edits_;
  language::AveragedWeights weights_{role_label_count};
};

}  // namespace

std::vector<MarkedEdit> lesson_of(const std::vector<MarkedEdit>& edits, std::size_t member) {
  std::vector<MarkedEdit> lesson;
  for (std::size_t i = 0; i < edits.size(); ++i)
    if (member == 0 || i % 3 != member - 1) lesson.push_back(edits[i]);
  return lesson;
}

std::string learn_roles(const std::vector<MarkedEdit>& edits) {
  RoleLearner learner(edits);
  learner.run();
  return learner.bytes();
}

}  // namespace roomgen
