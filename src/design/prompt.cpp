#include "prompt.h"
#include "roomgen/base/text.h"
namespace roomgen::design {
Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const CategoryTable&) {
  Brief b;
  const std::string text = " " + join(words(prompt), " ") + " ";
  for (const auto& [type, kind] : kinds.types) if (text.find(" " + type + " ") != std::string::npos) { b.type = type; b.type_known = true; }
  return b;
}
}
