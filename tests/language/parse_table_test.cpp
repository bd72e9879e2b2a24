// How much of varied English is understood: the tables of tests/data/language, written before what
// reads them.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

#include "catch.h"
#include "language/parse.h"
#include "roomgen/base/text.h"

using namespace roomgen;
using namespace roomgen::language;

namespace {

struct Sentence {
  std::string text;
  std::multiset<std::string> phrases, attachments;
};

std::vector<Sentence> read_table(const std::string& file) {
  std::ifstream stream(std::string(ROOMGEN_TEST_DATA) + "/language/" + file);
  std::vector<Sentence> table;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    Sentence sentence;
    const auto first = line.find(" => "), second = line.find(" =>", first + 3);
    REQUIRE(second != std::string::npos);
    sentence.text = line.substr(0, first);
    for (auto& phrase : split(line.substr(first + 4, second - first - 4), ';'))
      sentence.phrases.insert(phrase);
    for (auto& attachment : split(line.substr(second + 3), ';'))
      if (!attachment.empty()) sentence.attachments.insert(attachment);
    table.push_back(sentence);
  }
  return table;
}

std::string head(const Parse& parse, std::int32_t phrase) {
  return parse.head_of(parse.phrases[static_cast<std::size_t>(phrase)]);
}

// The table leaves out who speaks and "each" that stands alone.
bool is_left_out(const std::string& head) {
  return head == "i" || head == "we" || head == "you" || head == "each";
}

// In the notation of the table.
std::multiset<std::string> phrases_of(const Parse& parse) {
  std::multiset<std::string> result;
  for (std::size_t i = 0; i < parse.phrases.size(); ++i) {
    const NounPhrase& phrase = parse.phrases[i];
    std::vector<std::string> modifiers;
    for (auto k = phrase.modifiers.begin; k < phrase.modifiers.end; ++k)
      modifiers.push_back(parse.text_of(parse.modifiers[k]));
    for (const auto& verb : parse.verbs)
      if (verb.subject == static_cast<std::int32_t>(i))
        for (auto k = verb.complement.begin; k < verb.complement.end; ++k)
          modifiers.push_back(parse.text_of(parse.modifiers[k]));
    if (phrase.is_pronoun && is_left_out(parse.head_of(phrase))) continue;
    const bool counts = phrase.count > 0 && !phrase.is_pronoun;
    result.insert(std::string(phrase.is_denied ? "!" : "") + parse.head_of(phrase) + "/" +
                  (counts ? format_number(phrase.count) : "") + "/" + join(modifiers, ","));
  }
  return result;
}

std::multiset<std::string> attachments_of(const Parse& parse) {
  std::multiset<std::string> result;
  for (const auto& attachment : parse.attachments) {
    const auto from = static_cast<std::uint32_t>(attachment.from);
    const auto all =
        attachment.is_of_list ? parse.with_list(from) : std::vector<std::uint32_t>{from};
    for (const auto phrase : all)
      if (!is_left_out(parse.head_of(parse.phrases[phrase])))
        result.insert(parse.head_of(parse.phrases[phrase]) + " " + attachment.relation + " " +
                      head(parse, attachment.to));
  }
  return result;
}

struct Score {
  std::size_t right = 0, expected = 0, found = 0, whole = 0, sentences = 0;

  bool add(const std::multiset<std::string>& wanted, const std::multiset<std::string>& got) {
    std::vector<std::string> both;
    std::set_intersection(wanted.begin(), wanted.end(), got.begin(), got.end(),
                          std::back_inserter(both));
    right += both.size();
    expected += wanted.size();
    found += got.size();
    return wanted == got;
  }
  double f1() const {
    return 2.0 * right / std::max<double>(1.0, static_cast<double>(expected + found));
  }
};

struct Half {
  Score phrases, attachments;
  int whole = 0, sentences = 0;
};

void print(const char* name, const Half& half) {
  std::cout << name << ": " << half.sentences << " sentences, phrases F1 "
            << format_number(100 * half.phrases.f1(), 1) << " %, attachments F1 "
            << format_number(100 * half.attachments.f1(), 1) << " %, all right " << half.whole
            << "\n";
}

void show(const std::string& what, const std::multiset<std::string>& all,
          const std::multiset<std::string>& others) {
  for (const auto& one : all)
    if (all.count(one) != others.count(one)) std::cout << "  " << what << " " << one << "\n";
}

}  // namespace

TEST_CASE("Varied sentences are understood, those that were looked at and those that were not") {
  // ROOMGEN_SHOW_SENTENCES prints what is wrong in the half that may be looked at.
  const bool shows = std::getenv("ROOMGEN_SHOW_SENTENCES") != nullptr;
  const std::string file = GENERATE(as<std::string>(), "sentences.txt", "descriptions.txt");
  const auto table = read_table(file);
  REQUIRE(table.size() >= 140);
  Half halves[2];
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Parse parsed = parse(table[i].text);
    const auto phrases = phrases_of(parsed), attachments = attachments_of(parsed);
    Half& half = halves[i % 2];
    const bool right = half.phrases.add(table[i].phrases, phrases) &
                       half.attachments.add(table[i].attachments, attachments);
    half.whole += right;
    ++half.sentences;
    if (!shows || right || i % 2 == 1) continue;
    std::cout << table[i].text << "\n";
    show("missing", table[i].phrases, phrases);
    show("wrong  ", phrases, table[i].phrases);
    show("missing", table[i].attachments, attachments);
    show("wrong  ", attachments, table[i].attachments);
  }
  print((file + ", looked at").c_str(), halves[0]);
  print((file + ", not looked at").c_str(), halves[1]);
  for (const Half& half : halves) {
    CHECK(half.phrases.f1() > 0.95);
    CHECK(half.attachments.f1() > 0.82);
  }
}
