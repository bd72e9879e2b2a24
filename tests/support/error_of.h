#pragma once

#include <string>

#include "roomgen/base/result.h"

/// What is said of a failure; empty if there was none.
template <typename T>
std::string error_of(const roomgen::Result<T>& result) {
  return result ? "" : result.error().message;
}
