#pragma once

#include "base/json_reader.h"
#include "base/json_reader.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen {

/// What a kind has before its own entry is read: all of its parent that is handed down.
Kind child_of(const Kind& parent);
/// Reads the entry of a kind over what it inherits.
void read_kind(const JsonReader& json, Kind& kind);

}  // namespace roomgen
