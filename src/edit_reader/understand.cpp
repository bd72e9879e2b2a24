#include "roomgen/edit_reader/understand.h"

#include "edit_words.h"

namespace roomgen {

Result<Understanding> understand(const Session& session, std::string_view sentence) {
  return read_edit(sentence, session.scene(), session.kinds(), session.recall());
}

Result<Understanding> understand(Session& session, std::string_view sentence,
                                 const ModelEditing& editing) {
  const auto attempt = [&](std::span<const edit::Operation> operations) {
    return session.rehearse(operations);
  };
  return ask_for_edit(editing, sentence, session.scene(), session.recall(), attempt);
}

}  // namespace roomgen
