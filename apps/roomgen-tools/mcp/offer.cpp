#include "offer.h"

#include "base64.h"

namespace roomgen::mcp {

ToolAnswer text_answer(const std::string& text, Json data) {
  ToolAnswer answer;
  answer.content.push_back({{"type", "text"}, {"text", text}});
  answer.data = std::move(data);
  return answer;
}

void add_picture(ToolAnswer& answer, const std::string& png) {
  answer.content.push_back({{"type", "image"}, {"data", base64(png)}, {"mimeType", "image/png"}});
}

}  // namespace roomgen::mcp
