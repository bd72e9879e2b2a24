#pragma once

#include <algorithm>

#include "roomgen/kinds/kind_table.h"

namespace roomgen {

/// May things of the kind be put up so, as usual or also?
inline bool may_be_put_up(const Kind& kind, Mount mount) {
  return kind.mount == mount ||
         std::find(kind.also.begin(), kind.also.end(), mount) != kind.also.end();
}

}  // namespace roomgen
