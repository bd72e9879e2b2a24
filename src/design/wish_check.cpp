#include "wish_check.h"

#include "brief/prompt_words.h"
#include "brief/room_kinds.h"
#include "brief/said_wish.h"
#include "language/foreign.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"
#include "solve/arrangement.h"

namespace roomgen::design {

namespace {

Error invalid(const std::string& message) {
  return {Error::Kind::invalid_input, message};
}

}  // namespace

Status check_knowledge() {
  if (!brief::built_in_room_kinds()) return brief::built_in_room_kinds().error();
  if (!brief::built_in_vocabulary()) return brief::built_in_vocabulary().error();
  if (!built_in_arrangements()) return built_in_arrangements().error();
  return {};
}

Status check_request(const PlanRequest& request) {
  if (trim(request.prompt).empty())
    return invalid("the prompt is empty; say what room you want, as in \"a cosy bedroom for two\"");
  if (request.prompt.size() > max_prompt_bytes)
    return Error{Error::Kind::limit, "the prompt has " + std::to_string(request.prompt.size()) +
                                         " bytes; at most " + std::to_string(max_prompt_bytes) +
                                         " are read"};
  if (request.size && !request.room)
    for (double side : {request.size->x(), request.size->y()})
      if (!(side >= least_room_side && side <= greatest_room_side))
        return invalid("a room of " + format_number(request.size->x()) + " x " +
                       format_number(request.size->y()) + " m: sides must be from " +
                       format_number(least_room_side) + " to " + format_number(greatest_room_side) +
                       " m");
  if (request.room) return check(*request.room);
  return {};
}

Status check_understood(const PlanRequest& request, const brief::Brief& brief) {
  const auto tokens = language::tokenize(request.prompt, brief::max_tokens);
  const brief::SaidWish* read = brief::reading_of(request);
  const auto foreign =
      read && read->is_by_model ? std::nullopt : language::foreign_language(tokens);
  if (foreign)
    return Error{Error::Kind::not_understood,
                 "the prompt seems to be " + foreign->name + ". " + foreign->refusal};
  if (request.room && !request.room->type.empty()) return {};
  if (brief.understood) return {};
  return Error{Error::Kind::not_understood,
               "no word of the prompt names a room or a thing: say what room you want in English, "
               "as in \"a cosy bedroom for two\", or let a language model read it (--model)"};
}

}  // namespace roomgen::design
