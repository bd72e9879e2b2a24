#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::detail {

/// An element of an XML document.
struct XmlElement {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string name;  ///< as written, with its prefix
  std::vector<std::pair<std::string, std::string>> attributes;
  std::size_t line = 1;
  std::size_t parent = none;  ///< index

  /// Null if it has no such attribute.
  const std::string* find(std::string_view attribute) const;
};

inline constexpr std::size_t max_xml_elements = 50000;
inline constexpr std::size_t max_xml_depth = 64;

/// The elements of a document, parents before children. Strict: tags must nest, attributes must be
/// quoted. Text between tags is skipped; of entities the five of XML alone are replaced, so that no
/// document grows by being read.
Result<std::vector<XmlElement>> parse_xml(std::string_view text, const std::string& source);

}  // namespace roomgen::detail
