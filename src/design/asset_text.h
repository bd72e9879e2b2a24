#pragma once

#include <string>

#include "roomgen/design/designer.h"

namespace roomgen::design {

/// What an asset is and looks like, by who saw it, else by its name, with the looks that it was
/// given: "white leather sofa with right chaise, painted: upholstery navy velvet".
std::string told_looks(const AssetInfo& asset);

/// What a designer without eyes is told of an offer: the thing that is asked for, a line for each
/// asset, and one for what rules would make of the words.
std::string offer_text(const Plan& plan, const AssetOffer& offer, bool by_rules);
/// The first of these lines.
std::string offer_head(const Plan& plan, const AssetOffer& offer);
/// What of it goes on a sheet.
std::string offer_title(const Plan& plan, const AssetOffer& offer);
/// "study, 4 x 3.6 m"
std::string room_line(const Room& room);

}  // namespace roomgen::design
