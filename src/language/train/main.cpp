// Trains the tagger of the module language: train_tagger OUTPUT CORPUS... writes the model;
// train_tagger --test MODEL CORPUS... says how many tags of a corpus a model gets right, and which
// not.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "perceptron.h"
#include "tag_model.h"

namespace roomgen::language {

namespace {

std::vector<TaggedSentence> read_all(int argc, char** argv, int first) {
  std::vector<TaggedSentence> all;
  for (int i = first; i < argc; ++i)
    for (auto& sentence : read_corpus(argv[i])) all.push_back(std::move(sentence));
  return all;
}

void write(const char* path, const std::string& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error(std::string("cannot write ") + path);
}

void test(const char* path, const std::vector<TaggedSentence>& sentences) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const TagModel model(bytes);
  int right = 0, all = 0;
  for (const auto& sentence : sentences) {
    const auto tags = tag_words(sentence.units, sentence.facts, model);
    for (std::size_t i = 0; i < tags.size(); ++i) {
      if (given_tag(sentence.units[i])) continue;
      ++all;
      if (tags[i] == sentence.tags[i]) {
        ++right;
        continue;
      }
      std::printf("%s: %c, said %c: %s\n", sentence.facts[i].word.c_str(),
                  word_tag_letters[static_cast<std::size_t>(sentence.tags[i])],
                  word_tag_letters[static_cast<std::size_t>(tags[i])], sentence.text.c_str());
    }
  }
  std::printf("%d of %d right: %.2f %%\n", right, all, 100.0 * right / all);
}

int run(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: train_tagger [--test] MODEL CORPUS...\n");
    return 2;
  }
  if (std::string_view(argv[1]) == "--test")
    test(argv[2], read_all(argc, argv, 3));
  else
    write(argv[1], train(read_all(argc, argv, 2)));
  return 0;
}

}  // namespace

}  // namespace roomgen::language

int main(int argc, char** argv) {
  try {
    return roomgen::language::run(argc, argv);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "train_tagger: %s\n", problem.what());
    return 1;
  }
}
