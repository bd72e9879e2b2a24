#include "coverage.h"

#include <algorithm>
#include <optional>

#include "language/function_word.h"

namespace roomgen::plan {

namespace {

constexpr std::size_t nobody = brief::HeardWords::none;

// Words of style, of people and of what is done steer choices; a room may be only called one.
bool needs_requirement(Heard::As as) {
  return as != Heard::As::style && as != Heard::As::person && as != Heard::As::activity &&
         as != Heard::As::room && as != Heard::As::not_understood;
}

// Who heard each token: the shortest entry of those that are checked, since it says the most.
std::vector<std::size_t> owners(const brief::Brief& brief, const RequirementIds& ids) {
  std::vector<std::size_t> owner(brief.tokens.size(), nobody);
  for (std::size_t i = 0; i < brief.heard.size(); ++i) {
    const brief::HeardWords& words = brief.heard[i];
    if (needs_requirement(words.as) && ids[i].empty()) continue;
    for (auto token = words.tokens.begin; token < words.tokens.end && token < owner.size(); ++token)
      if (owner[token] == nobody ||
          words.tokens.size() < brief.heard[owner[token]].tokens.size())
        owner[token] = i;
  }
  return owner;
}

// What tokens were taken for.
struct Meaning {
  Heard::As as = Heard::As::not_understood;
  std::vector<std::string> requirements;
};

bool is_mark(const language::Token& token) {
  using Kind = language::Token::Kind;
  return token.kind != Kind::word && token.kind != Kind::number && token.kind != Kind::ordinal;
}

// Neighbours that one meaning has in common are one entry; marks part what nobody heard.
std::vector<Heard> runs_of(const std::string& prompt, const std::vector<language::Token>& tokens,
                           const std::vector<std::size_t>& owner,
                           const std::vector<Meaning>& meanings) {
  std::vector<Heard> heard;
  std::optional<std::size_t> last;  // whose the last entry is
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (is_mark(tokens[i]) && owner[i] == nobody) last.reset();
    const bool is_lost = owner[i] != nobody && meanings[owner[i]].as == Heard::As::not_understood;
    if (tokens[i].span.size() == 0) last.reset();  // only meant
    if (tokens[i].span.size() == 0 || (language::is_function_word(tokens[i]) && !is_lost)) continue;
    if (last == owner[i]) {
      heard.back().end = tokens[i].span.end;
      continue;
    }
    const Meaning meaning = owner[i] == nobody ? Meaning() : meanings[owner[i]];
    heard.push_back({tokens[i].span.begin, tokens[i].span.end, "", meaning.as, meaning.requirements});
    last = owner[i];
  }
  for (auto& words : heard) words.text = prompt.substr(words.begin, words.end - words.begin);
  return heard;
}

void add_all(const std::vector<std::string>& ids, std::vector<std::string>& to) {
  for (const auto& id : ids)
    if (std::find(to.begin(), to.end(), id) == to.end()) to.push_back(id);
}

}  // namespace

std::vector<Heard> heard_words(const std::string& prompt, const brief::Brief& brief,
                               const RequirementIds& ids) {
  std::vector<Meaning> meanings;
  for (std::size_t i = 0; i < brief.heard.size(); ++i) {
    meanings.push_back({brief.heard[i].as, {}});
    add_all(ids[i], meanings.back().requirements);
  }
  return runs_of(prompt, brief.tokens, owners(brief, ids), meanings);
}

std::vector<Heard> heard_words(const std::string& prompt, const brief::SaidDwelling& said,
                               const std::vector<Plan>& rooms,
                               const std::map<std::string, std::string>& ids) {
  std::vector<Meaning> meanings;
  std::vector<std::size_t> owner(said.tokens.size(), nobody);
  for (const auto& words : said.heard) {
    const auto id = ids.find(words.word);
    for (auto token = words.tokens.begin; token < words.tokens.end; ++token)
      owner[token] = meanings.size();
    meanings.push_back({words.as, {}});
    if (words.as == Heard::As::room && id != ids.end())
      meanings.back().requirements.push_back(id->second);
  }
  for (std::size_t room = 0; room < said.rooms.size(); ++room)
    for (const auto& words : rooms[room].heard) {
      if (words.as == Heard::As::not_understood) continue;
      for (const auto& own : said.rooms[room].brief.tokens)
        if (words.begin <= own.span.begin && own.span.end <= words.end)
          for (std::size_t token = 0; token < owner.size(); ++token)
            if (said.tokens[token].span == own.span && owner[token] == nobody)
              owner[token] = meanings.size();
      meanings.push_back({words.as, words.requirements});
    }
  return runs_of(prompt, said.tokens, owner, meanings);
}

}  // namespace roomgen::plan
