#include "edit_roles.h"

#include <algorithm>

namespace roomgen {

namespace {

bool asks_nothing(EditRole role) { return role == EditRole::idle || role == EditRole::keep; }

bool ends_with_mark(const EditText& text, const RoleStretch& stretch) {
  return stretch.end > stretch.begin && text.is_mark(stretch.end - 1);
}

// "the bed to the window. Turn the desk": what has an order and a thing is whole before the next one.
bool begins_another(const EditText& text, const SpokenOrder& order, const RoleStretch& before,
                    const RoleStretch& stretch) {
  return stretch.role == EditRole::order && order.has(EditRole::order) && order.has(EditRole::thing) &&
         (asks_nothing(before.role) || ends_with_mark(text, before));
}

}  // namespace

std::vector<RoleStretch> stretches_of(const std::vector<EditRole>& roles) {
  std::vector<RoleStretch> all;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (all.empty() || all.back().role != roles[i]) all.push_back({roles[i], i, i});
    all.back().end = i + 1;
  }
  return all;
}

bool SpokenOrder::has(EditRole role) const {
  return std::any_of(parts.begin(), parts.end(), [&](const RoleStretch& part) { return part.role == role; });
}

std::vector<SpokenOrder> orders_of(const EditText& text, const std::vector<RoleStretch>& stretches) {
  std::vector<SpokenOrder> orders(1);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const RoleStretch& stretch = stretches[i];
    const bool is_next = stretch.role == EditRole::next;
    const bool is_other = i > 0 && begins_another(text, orders.back(), stretches[i - 1], stretch);
    if ((is_next || is_other) && !orders.back().parts.empty()) orders.emplace_back();
    if (!is_next) (asks_nothing(stretch.role) ? orders.back().remarks : orders.back().parts).push_back(stretch);
  }
  if (orders.back().parts.empty() && orders.size() > 1) {
    auto& left = orders[orders.size() - 2].remarks;
    left.insert(left.end(), orders.back().remarks.begin(), orders.back().remarks.end());
    orders.pop_back();
  }
  if (orders.back().parts.empty()) orders.clear();
  return orders;
}

}  // namespace roomgen
