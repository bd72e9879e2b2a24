#include "edit_words.h"

#include <algorithm>

#include "wording.h"

namespace roomgen {

namespace {

constexpr std::size_t most_bytes = 4000, most_words = 400;

bool says_in_remark(const Understanding& understood, const std::string& words) {
  return std::any_of(understood.remarks.begin(), understood.remarks.end(),
                     [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

// What was taken back counts for nothing.
Result<Understanding> read_text(const EditText& text) {
  const auto correction = correction_in(text);
  if (!correction) return read_clauses(text);
  const std::string instead = text.words_from(correction->end, correction->end + 2);
  for (const auto& shorter : corrected(text, *correction)) {
    auto understood = read_clauses(shorter);
    if (understood && !says_in_remark(*understood, instead)) return understood;
  }
  return not_understood("it is not clear what \"" + text.words_from(correction->begin, correction->end) +
                        "\" takes back");
}

// "20 %", "90°"
void spell_out(language::Token& token) {
  const std::pair<const char*, const char*> symbols[] = {
      {"%", "percent"}, {"°", "degrees"}, {"º", "degrees"}, {"&", "and"}};
  for (const auto& [symbol, word] : symbols)
    if (token.text == symbol) token.text = word, token.kind = language::Token::Kind::word;
}

// "lamp -> corner"
void write_arrows(std::vector<language::Token>& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool is_drawn = i + 1 < tokens.size() && tokens[i].text == "-" && tokens[i + 1].text == ">";
    if (!is_drawn && tokens[i].text != "\u2192") continue;
    tokens[i].text = "to", tokens[i].kind = language::Token::Kind::word;
    if (is_drawn) tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
}

// "-3 m wide"; not "chair-2", and not "2 - 3 m".
bool has_measure_below_zero(const std::vector<language::Token>& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool is_minus = tokens[i].text == "-" || tokens[i].text == "\u2212";
    const bool is_bound = tokens[i + 1].kind == language::Token::Kind::number &&
                          tokens[i].span.end == tokens[i + 1].span.begin;
    const bool is_free = i == 0 || (tokens[i - 1].span.end < tokens[i].span.begin &&
                                    tokens[i - 1].kind != language::Token::Kind::number);
    if (is_minus && is_bound && is_free) return true;
  }
  return false;
}

}  // namespace

Result<Understanding> read_edit(std::string_view sentence, const Scene& scene, const KindTable& kinds,
                                const Recall& recall) {
  const auto& edits = edit_vocabulary();
  if (!edits) return edits.error();
  const auto& words = brief::built_in_vocabulary();
  if (!words) return words.error();
  if (sentence.size() > most_bytes)
    return Error{Error::Kind::limit, "an edit has " + std::to_string(most_bytes) + " bytes at most"};
  auto raw = language::tokenize(sentence, most_words);
  if (has_measure_below_zero(raw)) return not_understood("a number below 0 is no measure of things");
  for (auto& token : raw) spell_out(token);
  write_arrows(raw);
  std::erase_if(raw, [](const language::Token& token) {
    return token.kind == language::Token::Kind::quote || token.kind == language::Token::Kind::symbol;
  });
  auto tokens = brief::plain_tokens(raw);
  EditText text{scene, kinds, *edits, *words, std::move(raw), std::move(tokens), {}, {}, {}, {}, recall, 0};
  word_plainly(text);
  correct_spelling(text);
  return read_text(text);
}

}  // namespace roomgen
