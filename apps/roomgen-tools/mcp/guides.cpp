#include "guides.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "about.h"
#include "roomgen/base/text.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/relation.h"

#define PAGE(name)                                      \
  extern "C" const unsigned char roomgen_page_##name[]; \
  extern "C" const std::uint64_t roomgen_page_##name##_size;
PAGE(skill)
PAGE(groups)
PAGE(constraints)
PAGE(shapes)
#undef PAGE

namespace roomgen::mcp {

namespace {

constexpr const char* start = "roomgen:///docs/";

std::string page(const std::string& name) {
  const auto text = [](const unsigned char* bytes, std::uint64_t count) {
    return std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  };
  if (name == "skill.md") return text(roomgen_page_skill, roomgen_page_skill_size);
  if (name == "groups.md") return text(roomgen_page_groups, roomgen_page_groups_size);
  if (name == "shapes.md") return text(roomgen_page_shapes, roomgen_page_shapes_size);
  return text(roomgen_page_constraints, roomgen_page_constraints_size);
}

// As a model is told.
std::string prompt(const std::string& name) {
  std::vector<std::string> kinds, relations;
  for (const auto& [kind_name, kind] : KindTable::built_in().all()) kinds.push_back(kind_name);
  for (const auto& spelling : relation_spellings()) relations.emplace_back(spelling.text);
  const Prompts prompts = Prompts::built_in();
  const auto text =
      prompts.render(name, {{"kinds", join(kinds, ", ")},
                            {"relations", join(relations, ", ")},
                            {"frame", "metres, x to the right and y up the picture with marks"},
                            {"words", *prompts.render("place-words", {})}});
  return text ? *text : text.error().message;
}

const Json& guides() {
  static const Json all = about()["guides"];
  return all;
}

}  // namespace

Json list_guides() {
  Json all = Json::array();
  for (const auto& guide : guides())
    all.push_back({{"uri", start + guide["name"].get<std::string>()},
                   {"name", guide["name"]},
                   {"title", guide["title"]},
                   {"mimeType", "text/markdown"}});
  return all;
}

std::optional<std::string> read_guide(const std::string& uri) {
  for (const auto& guide : guides())
    if (const auto name = guide["name"].get<std::string>(); uri == start + name)
      return guide["prompt"] == "" ? page(name) : prompt(guide["prompt"]);
  return std::nullopt;
}

}  // namespace roomgen::mcp
