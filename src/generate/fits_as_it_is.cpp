#include "fits_as_it_is.h"

#include "roomgen/base/text.h"
#include "solve/refusal.h"

namespace roomgen {

namespace {

Error wrong_place(const Object& object, const std::string& why) {
  return {Error::Kind::not_found, object.id + " cannot stand there: " + why};
}

}  // namespace

Status fits_as_it_is(Layout& layout, const Object& object, bool even_useless) {
  auto candidate = layout.candidate(object);
  candidate.even_useless = even_useless;
  candidate.by_meshes = true;
  const Footprint area = footprint(object);
  if (!layout.fits_room(candidate, area, bottom(object)))
    return wrong_place(object, "it would leave the room, or block a door or a window");
  const auto verdict = layout.fits_exactly(candidate);
  if (verdict && layout.fits(candidate, area, bottom(object))) return {};
  const auto ids = verdict.useless ? std::vector<std::string>() : in_the_way(layout, object);
  if (ids.empty()) return wrong_place(object, misfit(layout, object, verdict));
  return wrong_place(object, join(ids, ", ") + (ids.size() == 1 ? " is" : " are") + " in the way");
}

}  // namespace roomgen
