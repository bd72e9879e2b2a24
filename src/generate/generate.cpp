#include "roomgen/generate/generate.h"

#include "least_room.h"

namespace roomgen {

Result<Generation> generate(const Plan& plan, Designer& designer, const AssetLibrary& library,
                            const KindTable& categories, const BuildOptions& options) {
  auto builder = RoomBuilder::begin(plan, designer, library, categories, options);
  if (!builder) return builder.error();
  while (builder->next() && builder->stopped().empty() && !options.cancel.cancelled())
    if (const auto step = builder->step(); !step && step.error().kind != Error::Kind::cancelled)
      return step.error();
  if (builder->stopped().empty() && !options.cancel.cancelled()) (void)builder->improve();
  if (auto status = builder->check_kind(); !status)
    return options.tells_least
               ? with_least_room(status.error(), plan, library, categories, options)
               : status.error();
  return builder->generation();
}

}  // namespace roomgen
