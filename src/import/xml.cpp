#include "xml.h"

#include <algorithm>
#include <array>
#include <optional>

#include "drawing.h"

namespace roomgen::detail {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == ':' || c == '-' || c == '.' || static_cast<unsigned char>(c) > 127;
}

class XmlParser {
 public:
  XmlParser(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  Result<std::vector<XmlElement>> run() {
    while (!error_ && at_ < text_.size()) {
      if (text_[at_] != '<') {
        step();
      } else if (starts("<!--")) {
        skip_to("-->", "a comment");
      } else if (starts("<![CDATA[")) {
        skip_to("]]>", "a CDATA section");
      } else if (starts("<?")) {
        skip_to("?>", "a processing instruction");
      } else if (starts("<!")) {
        skip_doctype();
      } else if (starts("</")) {
        close();
      } else {
        open();
      }
    }
    if (!error_ && !stack_.empty())
      fail("\"" + elements_[stack_.back()].name + "\" of line " +
           std::to_string(elements_[stack_.back()].line) + " is not closed");
    if (!error_ && elements_.empty()) fail("is no XML document: it has no element");
    if (error_) return *error_;
    return std::move(elements_);
  }

 private:
  bool starts(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) step();
  }

  void fail(const std::string& what) {
    if (!error_) error_ = located(source_, line_, what);
  }

  void skip_to(std::string_view end, const std::string& what) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) return fail(what + " has no end");
    while (at_ < found + end.size()) step();
  }

  // Without an inner subset: what that declares is not understood.
  void skip_doctype() {
    const std::size_t end = text_.find('>', at_), subset = text_.find('[', at_);
    if (subset < end) return fail("a document type with declarations is not read; leave it out");
    skip_to(">", "a declaration");
  }

  std::string name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_name(text_[at_])) ++at_;
    if (at_ == start) fail("expected a name");
    return std::string(text_.substr(start, at_ - start));
  }

  void open() {
    if (elements_.size() >= max_xml_elements) return fail("the document has too many elements");
    if (stack_.size() >= max_xml_depth) return fail("elements are nested too deeply");
    XmlElement element;
    element.line = line_;
    ++at_;
    element.name = name();
    element.parent = stack_.empty() ? XmlElement::none : stack_.back();
    while (!error_) {
      skip_spaces();
      if (at_ >= text_.size()) return fail("a tag has no end");
      if (starts("/>") || starts(">")) break;
      attribute(element);
    }
    if (error_) return;
    const bool empty = starts("/>");
    at_ += empty ? 2 : 1;
    elements_.push_back(std::move(element));
    if (!empty) stack_.push_back(elements_.size() - 1);
  }

  void attribute(XmlElement& element) {
    const std::string key = name();
    skip_spaces();
    if (error_ || at_ >= text_.size() || text_[at_] != '=')
      return fail("attribute \"" + key + "\" has no value");
    ++at_;
    skip_spaces();
    if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\''))
      return fail("the value of \"" + key + "\" is not quoted");
    const char quote = text_[at_++];
    const std::size_t end = text_.find(quote, at_);
    if (end == std::string_view::npos) return fail("the value of \"" + key + "\" has no end");
    if (element.find(key)) return fail("attribute \"" + key + "\" is there twice");
    std::string value = plain(text_.substr(at_, end - at_));
    while (at_ <= end) step();
    element.attributes.emplace_back(key, std::move(value));
  }

  // Entities that are not known stay as they are written.
  static std::string plain(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, char>, 5> known = {
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      const auto entity = std::find_if(known.begin(), known.end(), [&](const auto& e) {
        return text.substr(i).starts_with(e.first);
      });
      result += entity == known.end() ? text[i] : entity->second;
      i += entity == known.end() ? 1 : entity->first.size();
    }
    return result;
  }

  void close() {
    at_ += 2;
    const std::string closed = name();
    skip_spaces();
    if (error_ || !starts(">")) return fail("a closing tag has no end");
    ++at_;
    if (stack_.empty() || elements_[stack_.back()].name != closed)
      return fail("\"</" + closed + ">\" closes nothing that is open");
    stack_.pop_back();
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<XmlElement> elements_;
  std::vector<std::size_t> stack_;
  std::optional<Error> error_;
};

}  // namespace

const std::string* XmlElement::find(std::string_view attribute) const {
  for (const auto& [key, value] : attributes)
    if (key == attribute) return &value;
  return nullptr;
}

Result<std::vector<XmlElement>> parse_xml(std::string_view text, const std::string& source) {
  return XmlParser(text, source).run();
}

}  // namespace roomgen::detail
