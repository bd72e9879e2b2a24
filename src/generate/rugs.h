#pragma once

#include "workplace.h"

namespace roomgen {

/// Lays the rugs that a designer said where they go so that nothing stands on their edges, as it said
/// where that can be: whoever is asked next sees them as they will be. `now`: the step at work.
void settle_rugs(Work& work, const Step* now);

/// Ends a room: lays the others so too, and lifts what stands on any.
void lay_rugs(const Workplace& place, const BuildState& state, Generation& result);

/// How a rug lies otherwise than it was said: " was moved by …"; empty if it does not.
std::string change_of_rug(const Object& said, const Object& lies);

}  // namespace roomgen
