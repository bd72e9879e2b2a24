#include "classes.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "word_class.h"

namespace roomgen::language {

namespace {

std::uint32_t class_number(const std::string& name) {
  const auto found = std::find(word_class_names.begin(), word_class_names.end(), name);
  if (found == word_class_names.end()) throw std::runtime_error("no word class: " + name);
  return static_cast<std::uint32_t>(found - word_class_names.begin());
}

// "dining_table.n.1": the first sense of the noun.
std::uint32_t synset_named(const WordNet& net, const std::string& name) {
  const auto last = name.rfind('.');
  if (last == std::string::npos || last < 2)
    throw std::runtime_error("no name of a sense: " + name);
  std::string lemma = name.substr(0, last - 2);
  std::replace(lemma.begin(), lemma.end(), '_', ' ');
  const auto part = std::string("nvar").find(name[last - 1]);
  const auto rank = static_cast<std::size_t>(std::stoul(name.substr(last + 1)));
  const auto found = net.lemmas.find(lemma);
  if (part > 3 || found == net.lemmas.end() || rank < 1 || rank > found->second[part].size())
    throw std::runtime_error("WordNet has no " + name);
  return found->second[part][rank - 1].synset;
}

// Whether the nearest tops above are of the class: 1 or 0; what is being asked for is 2, so that no
// circle is walked twice.
class Closure {
 public:
  Closure(const WordNet& net, const std::vector<std::int8_t>& tops)
      : net_(net), tops_(tops), known_(net.synsets.size(), -1) {}

  bool holds(std::uint32_t synset) {
    if (known_[synset] >= 0) return known_[synset] == 1;
    if (tops_[synset] != 0) return (known_[synset] = tops_[synset] > 0 ? 1 : 0) == 1;
    known_[synset] = 2;
    bool any = false;
    for (const auto above : net_.synsets[synset].general) any = holds(above) || any;
    known_[synset] = any ? 1 : 0;
    return any;
  }

 private:
  const WordNet& net_;
  const std::vector<std::int8_t>& tops_;
  std::vector<std::int8_t> known_;
};

}  // namespace

std::vector<std::uint32_t> word_classes(const WordNet& net, const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::vector<std::uint32_t> masks(net.synsets.size(), 0);
  for (std::string line; std::getline(stream, line);) {
    const auto colon = line.find(':');
    if (line.starts_with('#') || colon == std::string::npos) continue;
    std::vector<std::int8_t> tops(net.synsets.size(), 0);
    std::istringstream names(line.substr(colon + 1));
    for (std::string name; names >> name;) {
      const bool excepted = name.starts_with('-');
      tops[synset_named(net, excepted ? name.substr(1) : name)] = excepted ? -1 : 1;
    }
    Closure closure(net, tops);
    const std::uint32_t bit = 1u << class_number(line.substr(0, colon));
    for (std::uint32_t id = 0; id < masks.size(); ++id)
      if (closure.holds(id)) masks[id] |= bit;
  }
  return masks;
}

}  // namespace roomgen::language
