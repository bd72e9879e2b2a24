#include "roomgen/geometry/vec.h"

#include "roomgen/base/text.h"

namespace roomgen {

std::string size_text(const Vec3& size) {
  return format_number(size.x(), 2) + " x " + format_number(size.y(), 2) + " x " +
         format_number(size.z(), 2);
}

}  // namespace roomgen
