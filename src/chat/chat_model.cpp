#include "roomgen/chat/chat_model.h"

namespace roomgen {

const char* name(ChatMessage::Role role) {
  switch (role) {
    case ChatMessage::Role::system:
      return "system";
    case ChatMessage::Role::assistant:
      return "assistant";
    case ChatMessage::Role::user:
      break;
  }
  return "user";
}

}  // namespace roomgen
