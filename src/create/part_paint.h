#pragma once

#include "finish_look.h"
#include "paint_box.h"
#include "roomgen/geometry/model.h"

namespace roomgen::create {

/// The mean tone that a material shows.
Tone mean_tone(const Material& material);

/// Gives a part another look. What has a pattern of its own is mapped anew, in metres, along the part's
/// longest side; where the tone alone changes the texture keeps its drawing. `is_same_stuff`: the part is
/// of the look's substance already, or nearly.
void paint_part(ModelPart& part, Material& material, const PartLook& look, bool is_same_stuff,
                PaintBox& paints);

}  // namespace roomgen::create
