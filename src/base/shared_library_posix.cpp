#include "shared_library.h"

#include <dlfcn.h>

namespace roomgen {

namespace {

Error load_error(const std::string& name) {
  const char* reason = dlerror();
  return {Error::Kind::unavailable,
          name + " cannot be used: " + (reason ? reason : "no reason given")};
}

}  // namespace

Result<SharedLibrary> SharedLibrary::open(const std::string& name) {
  void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) return load_error(name);
  return SharedLibrary(handle, name);
}

Result<void*> SharedLibrary::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (!address) return load_error(name_);
  return address;
}

}  // namespace roomgen
