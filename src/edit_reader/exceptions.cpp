#include <algorithm>

#include "clause.h"

namespace roomgen {

namespace {

// The one thing that is changed; empty where there are several or none.
std::string object_of(const edit::Operation& operation) {
  return std::visit([](const auto& one) -> std::string {
    if constexpr (requires { one.object; }) return one.object;
    return "";
  }, operation);
}

}  // namespace

void leave_out_exceptions(const EditText& text, Clause& clause) {
  const std::size_t begin = text.behind_comma(clause.end);
  const auto length = longest_in(text.edits.except, text.tokens, begin);
  if (length == 0 || clause.operations.size() < 2) return;
  const auto others = things(text, begin + length, true);
  if (!others) return;
  std::erase_if(clause.operations, [&](const edit::Operation& operation) {
    return std::count(others->value.begin(), others->value.end(), object_of(operation)) > 0;
  });
  clause.end = others->end;
}

}  // namespace roomgen
