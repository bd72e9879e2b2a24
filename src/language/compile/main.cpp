// Compiles the dictionary files of WordNet into the lexicon that the module language uses in place
// (../lexicon_layout.h). A tool of the build: compile_lexicon WORDNET_FOLDER WORD_CLASSES OUTPUT.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "classes.h"
#include "lexicon_layout.h"
#include "wordnet.h"

namespace roomgen::language {

namespace {

using layout::Section;

class Lexicon {
 public:
  Lexicon(const WordNet& net, const std::vector<std::uint32_t>& masks) : net_(net) {
    std::uint32_t number = 0;
    for (const auto& [lemma, senses] : net.lemmas) lemmas_[lemma] = number++;
    to(Section::licence) = net.licence;
    write_lemmas();
    write_classes(masks);
    write_synsets();
    write_irregular();
    for (const auto first : net.first) put(Section::parts, first);
  }

  std::string bytes() const {
    std::string header(layout::magic), body;
    for (const auto& section : sections_) {
      append(header, layout::header_size + body.size(), layout::offset_width);
      body += section;
    }
    append(header, layout::header_size + body.size(), layout::offset_width);
    return header + body;
  }

 private:
  static void append(std::string& to, std::size_t value, std::size_t width) {
    if (value >> (8 * width)) throw std::runtime_error("a number is too large for the lexicon");
    for (std::size_t i = 0; i < width; ++i) to += static_cast<char>(value >> (8 * i) & 0xff);
  }

  std::string& to(Section section) { return sections_[static_cast<std::size_t>(section)]; }
  void put(Section section, std::size_t value) { append(to(section), value, layout::width); }

  void write_lemmas() {
    std::size_t senses = 0;
    for (const auto& [lemma, by_part] : net_.lemmas) {
      put(Section::lemma_starts, to(Section::lemma_text).size());
      put(Section::lemma_senses, senses);
      to(Section::lemma_text) += lemma;
      for (const auto& part : by_part)
        for (const auto& sense : part) {
          put(Section::senses, sense.synset);
          append(to(Section::frequencies),
                 std::lround(layout::frequency_scale * std::log2(1.0 + sense.tagged)), 1);
          ++senses;
        }
    }
    put(Section::lemma_starts, to(Section::lemma_text).size());
    put(Section::lemma_senses, senses);
  }

  void write_classes(const std::vector<std::uint32_t>& masks) {
    std::vector<std::uint32_t> different = masks;
    std::sort(different.begin(), different.end());
    different.erase(std::unique(different.begin(), different.end()), different.end());
    for (const auto mask : different) append(to(Section::masks), mask, 4);
    for (const auto mask : masks)
      append(to(Section::classes),
             std::lower_bound(different.begin(), different.end(), mask) - different.begin(),
             layout::class_width);
  }

  void write_synsets() {
    std::size_t general = 0, members = 0;
    for (const auto& synset : net_.synsets) {
      put(Section::general_starts, general);
      put(Section::member_starts, members);
      for (const auto above : synset.general) put(Section::general, above), ++general;
      for (const auto& member : synset.members)
        if (const auto found = lemmas_.find(member); found != lemmas_.end())
          put(Section::members, found->second), ++members;
    }
    put(Section::general_starts, general);
    put(Section::member_starts, members);
  }

  void write_irregular() {
    auto forms = net_.irregular;
    // Equal forms keep the order of the file: the likeliest lemma first.
    std::stable_sort(forms.begin(), forms.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::pair<std::size_t, std::size_t>> by_base;
    for (const auto& [form, base] : forms) {
      put(Section::irregular_starts, to(Section::irregular_text).size());
      to(Section::irregular_text) += form;
      const std::size_t key = 4 * lemmas_.at(base.first) + static_cast<std::size_t>(base.second);
      put(Section::irregular_bases, key);
      by_base.push_back({key, by_base.size()});
    }
    put(Section::irregular_starts, to(Section::irregular_text).size());
    std::sort(by_base.begin(), by_base.end());
    for (const auto& [key, form] : by_base) put(Section::by_base, form);
  }

  const WordNet& net_;
  std::map<std::string, std::size_t> lemmas_;
  std::array<std::string, layout::section_count> sections_;
};

int compile(const char* folder, const char* classes, const char* output) {
  const WordNet net = read_wordnet(folder);
  const std::string bytes = Lexicon(net, word_classes(net, classes)).bytes();
  std::ofstream stream(output, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error(std::string("cannot write ") + output);
  return 0;
}

}  // namespace

}  // namespace roomgen::language

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: compile_lexicon WORDNET_FOLDER WORD_CLASSES OUTPUT\n");
    return 2;
  }
  try {
    return roomgen::language::compile(argv[1], argv[2], argv[3]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "compile_lexicon: %s\n", problem.what());
    return 1;
  }
}
