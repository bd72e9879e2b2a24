#include "models.h"

#include <algorithm>
#include <cstdio>

#ifdef ROOMGEN_HAS_ASSETS
#include "roomgen/library/load_models.h"
#endif

namespace roomgen::cli {

#ifdef ROOMGEN_HAS_ASSETS

void add_model_options(CLI::App& command, ModelOptions& options) {
  add_library_options(command, options.libraries);
}

Result<ModelTable> models_of(const Scene& scene, const ModelOptions& options,
                             const Context& context) {
  const auto& objects = scene.objects;
  const auto rooms = rooms_of(scene);
  const bool boxes_only =
      std::all_of(objects.begin(), objects.end(),
                  [](const Object& object) { return object.asset.is_box(); }) &&
      std::all_of(rooms.begin(), rooms.end(), [](const Room& room) {
        return std::all_of(room.openings.begin(), room.openings.end(), [](const Opening& opening) {
          return opening.joinery.asset.is_box();
        });
      });
  if (boxes_only) return ModelTable();
  auto library = open_all_libraries(options.libraries, context);
  if (!library) return library.error();
  return load_models(scene, **library, [](LogLevel, std::string_view message) {
    std::fprintf(stderr, "roomgen: %.*s; drawn as a box\n", static_cast<int>(message.size()),
                 message.data());
  });
}

#else

void add_model_options(CLI::App&, ModelOptions&) {}

Result<ModelTable> models_of(const Scene&, const ModelOptions&, const Context&) {
  return ModelTable();
}

#endif

}  // namespace roomgen::cli
