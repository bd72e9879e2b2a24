#pragma once

#include <string_view>

#include "edit_text.h"
#include "roomgen/edit_reader/understand.h"

namespace roomgen {

/// What a sentence asks to be changed in a scene, by rules. Several clauses are several operations; "it" and
/// "the lamp you just added" may mean what earlier ones bring. not_understood says which words are not, or
/// between which things a reference cannot decide: a wrong edit is worse than a refused one.
Result<Understanding> read_edit(std::string_view sentence, const Scene& scene, const KindTable& kinds,
                                const Recall& recall);

}  // namespace roomgen
