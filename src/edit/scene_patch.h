#pragma once

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// What differs between two scenes (each as to_json(Scene) writes it), small where little changed, and
/// enough to go from either to the other:
///
///     {"lists": {"objects": [{"id": "lamp-0", "before": {"yaw_deg": 0}, "after": {"yaw_deg": 90}},
///                            {"at": 7, "after": {"id": "sofa-1", …}}]},
///      "members": {"room": {"before": {…}, "after": {…}}}}
///
/// In lists whose elements have ids of their own (objects, requirements, unplaced) an element that changed is
/// named with the members that did, one that went has "at", its place before, and "before", one that came
/// "at", its place after, and "after". Other members are given whole; null stands for none.
Json scene_patch(const Json& before, const Json& after);

/// The same the other way round.
Json inverse_patch(const Json& patch);

/// Fails where the document is not what the patch was made from.
Result<Json> apply_patch(Json document, const Json& patch);

}  // namespace roomgen
