#include "stock.h"

#include "library/vocabulary.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::create {

void describe_by_kind(AssetInfo& info, const std::string& kind, bool carries) {
  const Kind* category = KindTable::built_in().find(kind);
  info.has_front = !category || category->traits.front;
  info.round = category && category->traits.round;
  const Kind* known = Vocabulary::built_in().find(kind);
  if (carries && known && known->supports) info.support_height = info.size.z();
}

}  // namespace roomgen::create
