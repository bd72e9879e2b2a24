// The tagger on sentences tagged by hand that nobody looked at: tests/data/language/tagged.txt.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

#include "catch.h"
#include "language/tag_model.h"
#include "language/train/corpus.h"
#include "language/train/perceptron.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "support/temporary_folder.h"

using namespace roomgen;
using namespace roomgen::language;

TEST_CASE("Words of unseen sentences get the tags that a reader gives them") {
  int right = 0, all = 0;
  for (const auto& sentence : read_corpus(std::string(ROOMGEN_TEST_DATA) + "/language/tagged.txt")) {
    const auto tags = tag_words(sentence.units, sentence.facts, tag_model());
    for (std::size_t i = 0; i < tags.size(); ++i) {
      if (given_tag(sentence.units[i])) continue;
      ++all;
      right += tags[i] == sentence.tags[i];
    }
  }
  std::cout << "tags: " << format_number(100.0 * right / all, 1) << " % of " << all << "\n";
  REQUIRE(all > 2000);
  CHECK(right > 0.96 * all);
}

TEST_CASE("The model that is built in is what the corpus gives") {
  std::vector<TaggedSentence> sentences;
  std::set<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(ROOMGEN_DATA) + "/language/tagged"))
    if (entry.path().extension() == ".txt") files.insert(entry.path().string());
  for (const auto& file : files)
    for (auto& sentence : read_corpus(file)) sentences.push_back(std::move(sentence));
  const auto bytes = read_file(std::string(ROOMGEN_DATA) + "/language/tagger.bin");
  REQUIRE(bytes);
  CHECK(train(sentences) == *bytes);
}

TEST_CASE("A corpus with a word that has no tag is refused with its line") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "corpus.txt";
  std::ofstream(file) << "a/D table\n";
  CHECK_THROWS_WITH(read_corpus(file.string()), Catch::Contains(":1:") && Catch::Contains("table"));
}
