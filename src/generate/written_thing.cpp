#include "written_thing.h"

#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "scene/written_asset.h"

namespace roomgen {

Result<WrittenThing> written_thing(const AssetLibrary& library, const std::string& program,
                                   const PlanItem& item, std::uint64_t seed) {
  create::Description description;
  description.noun = item.category;
  description.prompt = item.description;
  description.size = item.size;
  create::CreateOptions options;
  options.seed = seed;
  auto object = create::create_written(program, description, item.mount, options);
  if (!object) return object.error();
  AssetRef ref;
  ref.procedural = {program_recipe, json_line(shape::write_program(object->program)), 0};
  auto asset = library.find(asset_key(ref));
  if (!asset) return asset.error();
  asset->mount = item.mount;
  WrittenThing thing{*std::move(asset), std::move(object->notes),
                     join(object->soundness.problems, ", ")};
  if (!thing.fault.empty()) thing.notes.push_back(thing.fault);
  return thing;
}

}  // namespace roomgen
