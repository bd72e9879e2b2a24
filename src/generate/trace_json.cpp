#include "trace_json.h"

#include "roomgen/base/json.h"

namespace roomgen {

Json terms_json(const PlacementTerms& terms) {
  return {{"held", terms.held},
          {"lost", terms.lost},
          {"relations", rounded(terms.relations)},
          {"rest", rounded(terms.rest)},
          {"walkway", rounded(terms.walkway)},
          {"spread", rounded(terms.spread)},
          {"evenness", rounded(terms.evenness)},
          {"closeness", rounded(terms.closeness)},
          {"rank_c", rounded(terms.rank_c)},
          {"rank_l", rounded(terms.rank_l)},
          {"fused", rounded(terms.fused, 8)}};
}

Json consultation_json(const Consultation& consultation) {
  if (consultation.calls == 0 && consultation.notes.empty()) return nullptr;
  return {{"calls", consultation.calls},
          {"input_tokens", consultation.input_tokens},
          {"output_tokens", consultation.output_tokens},
          {"seconds", rounded(consultation.seconds)},
          {"prompt_sha256", consultation.prompt_sha256},
          {"image_sha256", consultation.image_sha256},
          {"notes", consultation.notes},
          {"fell_back", consultation.fell_back}};
}

Json advice_json(const PlaceAdvice& advice) {
  Json json;
  json["reasoning"] = advice.reasoning;
  json["constraints"] = to_text(advice.relations);
  json["location"] =
      advice.location ? Json{rounded(advice.location->x()), rounded(advice.location->y())} : Json();
  json["facing_deg"] = advice.yaw ? Json(rounded(degrees(*advice.yaw), 2)) : Json();
  return json;
}

}  // namespace roomgen
