#pragma once

#include <functional>
#include <string_view>

#include "edit_text.h"
#include "roomgen/edit/session.h"
#include "roomgen/edit_reader/understand.h"

namespace roomgen {

/// What a sentence asks to be changed in a scene, by rules. Several clauses are several operations; "it" and
/// "the lamp you just added" may mean what earlier ones bring. not_understood says which words are not, or
/// between which things a reference cannot decide: a wrong edit is worse than a refused one.
Result<Understanding> read_edit(std::string_view sentence, const Scene& scene, const KindTable& kinds,
                                const Recall& recall);

/// What a text asks for, clause by clause; what each speaks of is known to those behind it.
Result<Understanding> read_clauses(EditText text);

/// Can the operations be carried out? Fails with what is in the way.
using TryOperations = std::function<Status(std::span<const edit::Operation>)>;

/// What a sentence asks to be changed, as a language model understands it. An answer that cannot be read, or not
/// be carried out, goes back with the reason.
Result<Understanding> ask_for_edit(const ModelEditing& editing, std::string_view sentence, const Scene& scene,
                                   const Recall& recall, const TryOperations& attempt);

}  // namespace roomgen
