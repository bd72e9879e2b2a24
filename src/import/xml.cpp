#include "xml.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <pugixml.hpp>

#include "drawing.h"

namespace roomgen::detail {

namespace {

std::string meaning(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_end_element_mismatch:
      return "a closing tag closes nothing that is open, or an element is not closed";
    case pugi::status_no_document_element:
      return "is no XML document: it has no element";
    case pugi::status_bad_attribute:
      return "an attribute has no value in quotes, or a tag has no end";
    case pugi::status_out_of_memory:
      return "the document is too large";
    default:
      return "is no sound XML: a tag, comment or declaration is broken or has no end";
  }
}

// Flattens the tree, in the order of the document and without recursion.
class Flattener final : public pugi::xml_tree_walker {
 public:
  Flattener(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  Result<std::vector<XmlElement>> flatten(pugi::xml_document& document) && {
    document.traverse(*this);
    if (error_) return *error_;
    return std::move(elements_);
  }

 private:
  bool for_each(pugi::xml_node& node) override {
    advance_to(node.offset_debug());
    if (node.type() == pugi::node_doctype && std::strchr(node.value(), '['))
      fail("a document type with declarations is not read; leave it out");
    if (node.type() == pugi::node_element) add(node);
    return !error_;
  }

  void add(const pugi::xml_node& node) {
    const auto level = static_cast<std::size_t>(depth());
    if (elements_.size() >= max_xml_elements) return fail("the document has too many elements");
    if (level >= max_xml_depth) return fail("elements are nested too deeply");
    XmlElement element;
    element.name = node.name();
    element.line = line_;
    open_.resize(level + 1);
    element.parent = level == 0 ? XmlElement::none : open_[level - 1];
    for (const auto& attribute : node.attributes()) {
      if (element.attributes.size() >= max_xml_attributes) return fail("an element has too many attributes");
      if (element.find(attribute.name()))
        return fail("attribute \"" + std::string(attribute.name()) + "\" is there twice");
      element.attributes.emplace_back(attribute.name(), attribute.value());
    }
    open_[level] = elements_.size();
    elements_.push_back(std::move(element));
  }

  // Offsets count bytes of UTF-8: in other encodings the line is one near by.
  void advance_to(std::ptrdiff_t offset) {
    const auto end = std::min(text_.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset)));
    for (; at_ < end; ++at_) line_ += text_[at_] == '\n';
  }

  void fail(const std::string& what) {
    if (!error_) error_ = located(source_, line_, what);
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<XmlElement> elements_;
  std::vector<std::size_t> open_;  ///< the element on each level above
  std::optional<Error> error_;
};

std::size_t line_at(std::string_view text, std::ptrdiff_t offset) {
  const auto before = text.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset)));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

const std::string* XmlElement::find(std::string_view attribute) const {
  for (const auto& [key, value] : attributes)
    if (key == attribute) return &value;
  return nullptr;
}

Result<std::vector<XmlElement>> parse_xml(std::string_view text, const std::string& source) {
  // Before a tree is built: each element has at most two tags, and some comments may stand between them.
  if (static_cast<std::size_t>(std::count(text.begin(), text.end(), '<')) > 4 * max_xml_elements)
    return located(source, 1, "the document has too many elements");
  pugi::xml_document document;
  const auto parsed =
      document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
  if (!parsed) return located(source, line_at(text, parsed.offset), meaning(parsed.status));
  return Flattener(text, source).flatten(document);
}

}  // namespace roomgen::detail
