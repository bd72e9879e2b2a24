#pragma once

#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/scene/relation.h"
#include "reply_notes.h"
#include "target_names.h"

namespace roomgen::design {

/// The constraints of an answer, however they are written: one text, a list of texts, of pairs or
/// of objects, an object with a member for each. What cannot be kept is noted in `notes`.
std::vector<Relation> read_reply_relations(const Json& value, const TargetNames& targets,
                                           ReplyNotes& notes);

/// Adds a relation that is not there yet and contradicts none that is; notes why it did not.
void add_relation(std::vector<Relation>& relations, const Relation& relation,
                  ReplyNotes& notes);

}  // namespace roomgen::design
