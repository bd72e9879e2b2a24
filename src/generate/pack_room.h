#pragma once

#include "workplace.h"

namespace roomgen {

/// Arranges the room by annealing as the options say: when something found no place, or always. What a designer's word or a
/// lock binds stays. A result that is not better is dropped.
void pack_room(Work& work);

}  // namespace roomgen
