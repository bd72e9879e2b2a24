#pragma once

#include <string>

namespace roomgen::decode {

/// The decoder's side of wire.h: answers over `channel` until nobody asks any more. `held` says what holds
/// the process by now. Returns the exit code.
int serve(int channel, const std::string& held);

}  // namespace roomgen::decode
