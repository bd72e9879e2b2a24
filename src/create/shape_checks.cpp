#include "maker_replies.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr double least_extent = 0.01, greatest_extent = 6.0;  // metres

}  // namespace

Status check_extent(const shape::Shape& shape) {
  const double extent = shape::bounds(shape).size().maxCoeff();
  if (extent >= least_extent && extent <= greatest_extent) return {};
  return Error{Error::Kind::invalid_input, "the whole is " + format_number(extent) +
                                               " m large; all lengths are metres, and furniture "
                                               "has " +
                                               format_number(least_extent) + " to " +
                                               format_number(greatest_extent) + " m"};
}

}  // namespace roomgen::create
