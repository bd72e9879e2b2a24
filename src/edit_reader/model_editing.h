#pragma once

#include <functional>
#include <string_view>

#include "edit_text.h"
#include "roomgen/edit_reader/understand.h"

namespace roomgen {

/// Can the operations be carried out? Fails with what is in the way.
using TryOperations = std::function<Status(std::span<const edit::Operation>)>;

/// What a sentence asks to be changed, as a language model understands it. An answer that cannot be read, or not
/// be carried out, goes back with the reason.
Result<Understanding> ask_for_edit(const ModelEditing& editing, std::string_view sentence, const Scene& scene,
                                   const Recall& recall, const TryOperations& attempt);

}  // namespace roomgen
