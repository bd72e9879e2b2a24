#pragma once

#include <string>

#include "roomgen/base/result.h"

namespace roomgen {

/// A C library of the system that is loaded when it is first needed: what costs much to load, and what
/// most runs of a program do without, does not slow its start. Stays loaded until the program ends, so
/// that its functions may be kept.
class SharedLibrary {
 public:
  /// `name` as the system's loader knows it ("libOSMesa.so.8"). Error::Kind::unavailable without it.
  static Result<SharedLibrary> open(const std::string& name);

  /// Sets `target`, a pointer to a function, to the library's function `name`. The type is the caller's
  /// word: take it from the library's own header with decltype.
  template <typename Function>
  Status find(const char* name, Function*& target) const {
    const auto address = symbol(name);
    if (!address) return address.error();
    target = reinterpret_cast<Function*>(*address);
    return {};
  }

 private:
  SharedLibrary(void* handle, std::string name) : handle_(handle), name_(std::move(name)) {}
  Result<void*> symbol(const char* name) const;

  void* handle_;
  std::string name_;
};

}  // namespace roomgen
