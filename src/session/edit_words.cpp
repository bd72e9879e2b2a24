#include "edit_words.h"

namespace roomgen {

Result<std::vector<edit::Operation>> read_edit(std::string_view sentence, const Scene&, const KindTable&) {
  return Error{Error::Kind::not_understood, "\"" + std::string(sentence) + "\" is not understood"};
}

}  // namespace roomgen
