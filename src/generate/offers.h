#pragma once

#include <vector>

#include "workplace.h"

namespace roomgen {

/// What there is for the things of a plan, those that are asked for in the same words as one; not
/// for those that have an asset by the plan, nor for what is made to measure for a window.
/// `surplus`: how many more there are than are offered at once.
Result<std::vector<AssetOffer>> offers_of(Workplace& place, std::size_t& surplus);

/// What other words find for an offer, with its first asset last.
Result<AssetOffer> searched_again(Workplace& place, const AssetOffer& offer,
                                  const std::string& words);

/// What the words of an item are made into at a size; nothing where nobody knows how.
Result<std::optional<AssetInfo>> made_of(const Workplace& place, const PlanItem& item,
                                         const Vec3& size);

/// What an item is asked for, or usual.
Vec3 wanted_size(const Workplace& place, const PlanItem& item);

/// Pictures of what is offered, each of a page of them.
Result<std::vector<Image>> sheets_of(const Workplace& place, const std::vector<AssetOffer>& offers);

/// Pictures of so many rows at most, which are no higher than this. The meshes are those of the
/// library.
Result<std::vector<Image>> pages_of(const Workplace& place,
                                    const std::vector<ContactSheet::Row>& rows,
                                    std::size_t rows_of_page, double most_row);

}  // namespace roomgen
