#pragma once

#include "edit_text.h"
#include "roomgen/session/session.h"

namespace roomgen {

/// What a text asks for, by the roles that its words have as the model learned it (role_model.h): the words that
/// order, what they are about, where to, how much. Each order is read by the rules as it is said, else by its parts;
/// what the rules then do not read whole, or
/// read as something else than the model says, is not understood, nor is what no other member of the committee of models
/// reads the same way.
Result<Understanding> read_by_roles(const EditText& text);

}  // namespace roomgen
