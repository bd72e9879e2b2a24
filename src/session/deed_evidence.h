#pragma once

#include "role_model.h"

namespace roomgen {

/// Whether the words of an order leave no doubt that it is for the deed that the model takes it for. What a word that
/// nobody knows may ask for is not done: something taken away or locked by mistake is worse than asking again.
bool is_evident(const EditText& text, const SpokenOrder& order, const ReadDeed& read);
/// "shouldn't hang opposite the bed", "nobody shifts it": what is not to be.
bool is_denied(const EditText& text, const SpokenOrder& order);
/// Whether a remark behind an order may still ask for something: "…, the ball instead".
bool may_ask(const EditText& text, const RoleStretch& remark);
/// Whether words that mean something are taken for what joins orders, or for talk that runs on into one.
bool leaves_words_unread(const EditText& text, const std::vector<WordSigns>& signs,
                         const std::vector<RoleStretch>& stretches);

}  // namespace roomgen
