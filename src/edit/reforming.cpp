#include <nlohmann/json.hpp>
#include <optional>

#include "comparison.h"
#include "draft_changes.h"
#include "operations.h"

namespace roomgen {

namespace {

bool has_same_form(const Model& a, const Model& b) {
  return merged_mesh(a).positions == merged_mesh(b).positions;
}

// "A taller back", where no word of the program says so: the whole is built anew with so much more height. The program
// keeps to their own measure the parts that have one (a seat), so that the back is what grows.
std::optional<Object> grown(const Draft& draft, const Object& object, const std::string& words) {
  const Comparison comparison = comparison_in(words);
  if (comparison.ways.empty()) return std::nullopt;
  auto changed = with_size(draft, object, compared_size(comparison, object.size, false));
  if (!changed) return std::nullopt;
  Json params = Json::parse(changed->asset.procedural->params, nullptr, false);
  const Vec3& size = changed->size;
  params["size"] = {size.x(), size.y(), size.z()};
  changed->asset.procedural->params = params.dump();
  return *std::move(changed);
}

// By the words that it was made of, with more words; the seed stays, and with it all that they do not speak of.
Result<Object> reworded(const Object& object, const std::string& words) {
  Object changed = object;
  ProceduralSource& source = *changed.asset.procedural;
  Json params = Json::parse(source.params, nullptr, false);
  if (!params.is_object()) return cannot(object.id + " does not say how it was made");
  const std::string said = text_parameter(source, "description");
  const std::string& before = said.empty() ? object.description : said;
  params["description"] = before + ", " + words;
  source.params = params.dump();
  changed.description = before + ", " + words;
  return changed;
}

}  // namespace

Status carry_out(Draft& draft, const edit::Reform& reform) {
  const auto object = object_to_change(draft, reform.object);
  if (!object) return object.error();
  if (!object->asset.procedural || object->asset.procedural->recipe != "words")
    return cannot("the form of " + object->id + " is that of a finished mesh; replace it with \"" + object->category +
                  " " + reform.words + "\"");
  auto changed = reworded(*object, reform.words);
  if (!changed) return changed.error();
  const auto was = draft.shop.fetch_model(object->asset);
  if (!was) return was.error();
  for (int tries = 0; tries < 2; ++tries) {
    const auto is = draft.shop.fetch_model(changed->asset);
    if (!is) return cannot(object->id + " cannot be made so: " + is.error().message);
    if (*is && *was && !has_same_form(**was, **is)) return put_changed(draft, cluster_of(draft.scene, *object), *changed);
    auto larger = grown(draft, *object, reform.words);
    if (!larger) break;
    changed = *std::move(larger);
  }
  return Error{Error::Kind::not_understood, "\"" + reform.words + "\" changes nothing of the form of " + object->id};
}

}  // namespace roomgen
