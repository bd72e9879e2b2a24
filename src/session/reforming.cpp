#include <nlohmann/json.hpp>

#include "changed_thing.h"
#include "operations.h"

namespace roomgen {

namespace {

bool has_same_form(const Model& a, const Model& b) {
  return merged_mesh(a).positions == merged_mesh(b).positions;
}

}  // namespace

// The words that it was made of get more words; the seed stays, and with it all that they do not speak of.
Status carry_out(Draft& draft, const edit::Reform& reform) {
  const auto object = object_to_change(draft, reform.object);
  if (!object) return object.error();
  if (!object->asset.procedural || object->asset.procedural->recipe != "words")
    return cannot("the form of " + object->id + " is that of a finished mesh; replace it with \"" + object->category +
                  " " + reform.words + "\"");
  Object changed = *object;
  ProceduralSource& source = *changed.asset.procedural;
  Json params = Json::parse(source.params, nullptr, false);
  if (!params.is_object()) return cannot(object->id + " does not say how it was made");
  const std::string before = params.value("description", object->description);
  params["description"] = before + ", " + reform.words;
  source.params = params.dump();
  const auto was = draft.shop.fetch_model(object->asset), is = draft.shop.fetch_model(changed.asset);
  if (!was) return was.error();
  if (!is) return cannot(object->id + " cannot be made so: " + is.error().message);
  if (!*is || !*was || has_same_form(**was, **is))
    return Error{Error::Kind::not_understood, "\"" + reform.words + "\" changes nothing of the form of " + object->id};
  changed.description = before + ", " + reform.words;
  return put_changed(draft, cluster_of(draft.scene, *object), changed);
}

}  // namespace roomgen
