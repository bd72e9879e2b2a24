#include "osmesa.h"

#include "base/shared_library.h"

namespace roomgen::detail {

namespace {

Result<OsMesa> load_osmesa() {
  const auto library = SharedLibrary::open(ROOMGEN_OSMESA);
  if (!library) return library.error();
  OsMesa mesa;
#define ROOMGEN_FIND(name) \
  if (auto found = library->find("OSMesa" #name, mesa.name); !found) return found.error();
  ROOMGEN_OSMESA_FUNCTIONS(ROOMGEN_FIND)
#undef ROOMGEN_FIND
  return mesa;
}

}  // namespace

const Result<OsMesa>& osmesa() {
  static const Result<OsMesa> mesa = load_osmesa();
  return mesa;
}

}  // namespace roomgen::detail
