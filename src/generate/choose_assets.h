#pragma once

#include "workplace.h"

namespace roomgen {

/// Forgets the assets of a plan's items that no library has, with a note each: their words decide.
Status check_assets(Plan& plan, const AssetLibrary& library);

/// Lets the designer choose what the things of the plan shall be, and writes that into the plan.
void choose_assets(Workplace& place);

}  // namespace roomgen
