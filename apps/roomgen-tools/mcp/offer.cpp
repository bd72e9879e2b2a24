#include "offer.h"

#include "base64.h"

namespace roomgen::mcp {

ToolAnswer text_answer(const std::string& text, Json data) {
  ToolAnswer answer;
  answer.content.push_back({{"type", "text"}, {"text", text}});
  answer.data = std::move(data);
  return answer;
}

void add_picture(ToolAnswer& answer, const std::string& picture) {
  const char* type = picture.starts_with("\x89PNG") ? "image/png" : "image/jpeg";
  answer.content.push_back({{"type", "image"}, {"data", base64(picture)}, {"mimeType", type}});
}

}  // namespace roomgen::mcp
