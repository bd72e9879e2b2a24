#pragma once

#include <string>

#include "roomgen/design/designer.h"

namespace roomgen::design {

/// What an asset is and looks like, by who saw it, else by its name, with the looks that it was
/// given: "white leather sofa with right chaise, painted: upholstery navy velvet".
std::string told_looks(const AssetInfo& asset);

/// What a designer without eyes is told of an offer: the thing that is asked for, and a line for
/// each asset.
std::string offer_text(const Plan& plan, const AssetOffer& offer);
/// The first of these lines, for a sheet.
std::string offer_title(const Plan& plan, const AssetOffer& offer);

}  // namespace roomgen::design
