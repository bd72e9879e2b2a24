#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::detail {

/// An element of an XML document. Texts are UTF-8, with entities replaced.
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
inline constexpr std::size_t max_xml_attributes = 1000;  ///< of an element

/// The elements of a document, parents before children; text between tags is skipped. UTF-8, UTF-16,
/// UTF-32 and Latin-1 are told by their marks and declarations. Numeric entities and the five of XML are
/// replaced, others stay as they are written and declarations of entities are refused: no document grows
/// by being read, and none makes another file be read.
Result<std::vector<XmlElement>> parse_xml(std::string_view text, const std::string& source);

}  // namespace roomgen::detail
