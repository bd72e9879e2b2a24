#pragma once

#include <nlohmann/json_fwd.hpp>

namespace roomgen {

/// Keeps the order of keys, so that files read as their authors wrote them and output is stable.
using Json = nlohmann::ordered_json;

class JsonReader;

}  // namespace roomgen
