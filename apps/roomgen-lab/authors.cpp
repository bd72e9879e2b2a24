#include "authors.h"

#include "roomgen/render/pictures.h"

namespace roomgen::cli {

using namespace lab;

namespace {

// The kinds that a library holds, with the size of the best of each.
std::vector<KindOffer> kind_offers(const AssetLibrary& library, const KindTable& kinds) {
  std::vector<KindOffer> offers;
  for (const auto& [name, kind] : kinds.all()) {
    if (kind.variant || kind.is_stand_in()) continue;
    const auto found = library.search({.category = name, .size = kind.size, .limit = 1});
    if (found && !found->empty() && !found->front().asset.stand_in) offers.push_back({name, found->front().asset.size});
  }
  return offers;
}

}  // namespace

Authors::Authors(ComposedModel& model, const DesignerOptions& options, const AssetLibrary& library)
    : model_(model), options_(options) {
  if (options.designer == "model") kinds_ = kind_offers(library, KindTable::built_in());
}

ProgramAuthor Authors::author() const {
  return options_.designer == "model"
             ? model_author(*model_.model, model_.prompts,
                            {.thinking = options_.thinking, .kinds = kinds_})
             : rule_author();
}

void Authors::show(ComposeOptions& options) {
  if (options_.designer == "model")
    options.picture = [this](const Scene& scene, const ModelTable& models) { return picture(scene, models); };
}

Result<std::string> Authors::picture(const Scene& scene, const ModelTable& models) {
  const auto renderer = drawer_.renderer();
  if (!renderer) return renderer.error();
  const auto image = segmentation_picture(**renderer, scene, models);
  return image ? encode_for(options_, *image) : image.error();
}

}  // namespace roomgen::cli
