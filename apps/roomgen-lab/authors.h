#pragma once

#include <vector>

#include "designers.h"
#include "room_files.h"
#include "roomgen/lab/compose.h"
#include "roomgen/library/library.h"

namespace roomgen::cli {

/// Who writes programs: rules, or a model that is told what the library holds and shown the rooms. All arguments must
/// outlive it.
class Authors {
 public:
  Authors(ComposedModel& model, const DesignerOptions& options, const AssetLibrary& library);

  /// For one composition.
  lab::ProgramAuthor author() const;
  /// What the author is shown of each round; nothing for rules.
  void show(lab::ComposeOptions& options);

 private:
  Result<std::string> picture(const Scene& scene, const ModelTable& models);

  ComposedModel& model_;
  const DesignerOptions& options_;
  std::vector<lab::KindOffer> kinds_;
  PictureDrawer drawer_;
};

}  // namespace roomgen::cli
