#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <system_error>

#include "shared_library.h"

namespace roomgen {

namespace {

Error load_error(const std::string& name) {
  const auto code = static_cast<int>(::GetLastError());
  return {Error::Kind::unavailable,
          name + " cannot be used: " + std::system_category().message(code)};
}

}  // namespace

Result<SharedLibrary> SharedLibrary::open(const std::string& name) {
  const HMODULE handle = ::LoadLibraryA(name.c_str());
  if (!handle) return load_error(name);
  return SharedLibrary(handle, name);
}

Result<void*> SharedLibrary::symbol(const char* name) const {
  const auto address = ::GetProcAddress(static_cast<HMODULE>(handle_), name);
  if (!address) return load_error(name_);
  return reinterpret_cast<void*>(address);
}

}  // namespace roomgen
