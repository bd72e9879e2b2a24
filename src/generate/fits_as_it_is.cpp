#include "fits_as_it_is.h"

#include "roomgen/base/text.h"
#include "solve/refusal.h"

namespace roomgen {

namespace {

Error wrong_place(const Object& object, const std::string& why) {
  return {Error::Kind::not_found, object.id + " cannot stand there: " + why};
}

std::vector<std::string> ids_in_the_way(const Layout& layout, const Layout::Candidate& candidate,
                                        const Footprint& area) {
  std::vector<std::string> ids;
  for (const auto& thing : layout.things())
    if (layout.collides(candidate, area, bottom(candidate.object), thing))
      ids.push_back(thing.object->id);
  return ids;
}

}  // namespace

Status fits_as_it_is(Layout& layout, const Object& object) {
  const auto candidate = layout.candidate(object);
  const Footprint area = footprint(object);
  if (!layout.fits_room(candidate, area, bottom(object)))
    return wrong_place(object, "it would leave the room, or block a door or a window");
  if (const auto ids = ids_in_the_way(layout, candidate, area); !ids.empty())
    return wrong_place(object, join(ids, ", ") + (ids.size() == 1 ? " is" : " are") + " in the way");
  const auto verdict = layout.fits_exactly(candidate);
  return verdict ? Status() : wrong_place(object, misfit(layout, object, verdict));
}

}  // namespace roomgen
