#pragma once

#include "edit_text.h"

namespace roomgen {

/// The same said plainly: what is written short is written out ("I'd", "the sofa's too big", "gimme"), and
/// courtesies that may stand anywhere are left out ("delete please the rug").
void word_plainly(EditText& text);

}  // namespace roomgen
