#pragma once

#include <memory>

#include "roomgen/create/maker.h"

namespace roomgen::create {

/// Works offline: knowledge (data/create, data/shapes) and a grammar of English descriptions. Equal
/// requests give equal programs.
std::unique_ptr<Maker> make_rule_maker();

}  // namespace roomgen::create
