#include "make_asset.h"

#include <nlohmann/json.hpp>

#include "library/qualifiers.h"
#include "offers.h"
#include "roomgen/create/create.h"

namespace roomgen {

namespace {

// By the words themselves, whatever the item is called.
PlanItem named_by(PlanItem item, const std::string& words) {
  const KindPhrase own = own_name("", words);
  const std::string head = own.known ? own.kind : qualify(words).head;
  if (!head.empty()) item.category = head;
  item.description = words;
  return item;
}

// The program is the asset: it is built again from its key alone.
Result<AssetInfo> made_by(create::Maker& maker, const Workplace& place, const std::string& words,
                          const Vec3& size, std::vector<std::string>& notes) {
  auto objects = create::make_rule_maker()->decompose(words);
  if (!objects) return objects.error();
  create::Description description =
      objects->empty() ? create::Description() : std::move(objects->front());
  description.prompt = words;
  create::CreateOptions options;
  options.seed = place.options.seed;
  options.cancel = place.options.cancel;
  description.size = size;
  auto object = create::create_described(description, maker, options);
  if (!object) return object.error();
  notes.insert(notes.end(), object->notes.begin(), object->notes.end());
  AssetRef ref;
  ref.procedural = {"program", json_line(shape::write_program(object->program)), 0};
  return place.library.find(asset_key(ref));
}

}  // namespace

Result<MadeAsset> make_asset(Workplace& place, const PlanItem& item, const std::string& words,
                             const Vec3& size) {
  MadeAsset result;
  if (place.options.maker) {
    auto made = made_by(*place.options.maker, place, words, size, result.notes);
    if (made) return result.asset = *std::move(made), result;
    result.notes.push_back("the maker failed (" + made.error().message + "); rules make it");
  }
  auto asset = made_of(place, named_by(item, words), size);
  if (!asset) return asset.error();
  result.asset = *std::move(asset);
  return result;
}

}  // namespace roomgen
