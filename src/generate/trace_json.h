#pragma once

#include "roomgen/base/json.h"
#include "roomgen/design/designer.h"
#include "roomgen/solve/place.h"

namespace roomgen {

// Members of the lines of trace.jsonl (docs/trace.md).

Json terms_json(const PlacementTerms& terms);
/// What a language model was asked for an answer; null if none was.
Json consultation_json(const Consultation& consultation);
Json advice_json(const PlaceAdvice& advice);

}  // namespace roomgen
