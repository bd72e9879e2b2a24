#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace roomgen::detail {

/// Brief names for the things of kinds of which there are many: "dc12" for "dining chair-12".
class MarkNames {
 public:
  /// `ids` are those that have to be named in one picture.
  explicit MarkNames(const std::vector<std::string>& ids);

  /// The id itself unless its kind is named briefly.
  std::string of(const std::string& id) const;
  /// Several of a kind with a brief name: "dc0..3,8".
  std::string of(const std::vector<std::string>& ids) const;
  bool is_brief(const std::string& id) const { return brief_.contains(kind_of(id)); }
  /// One kind less has a brief name: that of the fewest things.
  void spell_out_rarest();
  /// "dc = dining chair", by kind.
  std::vector<std::string> legend() const;

  static std::string kind_of(const std::string& id) { return id.substr(0, id.rfind('-')); }

 private:
  std::map<std::string, int> counts_;         ///< by kind
  std::map<std::string, std::string> brief_;  ///< by kind
};

}  // namespace roomgen::detail
