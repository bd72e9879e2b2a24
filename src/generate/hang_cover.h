#pragma once

#include "workplace.h"

namespace roomgen {

/// A curtain or blind at its window, and the asset that is made to this measure.
struct Hanging {
  Object object;
  AssetInfo asset;
  std::string window;
};

/// Where a cover of a window (Kind::covers_window) hangs: at a window that has none, preferably the one
/// that its relations name; it needs no advice. not_found with the reason if nowhere.
Result<Hanging> find_hanging(Work& work, const PlannedObject& planned);

/// Hangs it up.
void hang_up(Work& work, const PlannedObject& planned, Hanging hanging);

}  // namespace roomgen
