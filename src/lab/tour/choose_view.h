#pragma once

#include <variant>

#include "site.h"

namespace roomgen::lab::detail {

struct ChosenView {
  TourView view;  ///< without what depends on the way to it
  GridNode node = 0;
};

/// The best accepted viewpoint for a target, or why there is none. Fails only if the renderer does.
Result<std::variant<ChosenView, UnseenTarget>> choose_view(const TourSite& site, Renderer& renderer,
                                                           const Object& target, const ShortestWays& ways);

}  // namespace roomgen::lab::detail
