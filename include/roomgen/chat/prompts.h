#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen {

/// What language models are told: the Markdown files of prompts/, whose {{slots}} are filled for
/// each question. They are compiled in; a folder may hold other versions of some of them.
class Prompts {
 public:
  using Slots = std::map<std::string, std::string, std::less<>>;

  static Prompts built_in();
  /// Files of the folder that are called like those of prompts/ (plan-system.md) replace the
  /// built-in ones. Fails for a folder that cannot be read or holds none of them, and for a slot that
  /// the built-in version does not have, since nothing would fill it.
  static Result<Prompts> from_folder(const std::filesystem::path& folder);

  /// The text of "place-user" with its slots filled. Precondition: `slots` has a value for each
  /// slot of the text; fails with invalid_input and the slot's name otherwise. Values are not
  /// searched for slots.
  Result<std::string> render(std::string_view name, const Slots& slots) const;

  /// SHA-256 over all texts: which prompts a trace belongs to.
  std::string version() const;

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace roomgen
