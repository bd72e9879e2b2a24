#include "quotes.h"

#include <algorithm>
#include <charconv>

#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

using language::Run;

constexpr std::size_t longest_quote = 400;  // tokens

bool is_spoken(const language::Token& token) {
  return token.kind == language::Token::Kind::word || token.kind == language::Token::Kind::number ||
         token.kind == language::Token::Kind::ordinal ||
         token.kind == language::Token::Kind::symbol;
}

// "chairs #2": the words, and which time they are said, from 1; 0: not told.
std::pair<std::string_view, std::size_t> numbered(std::string_view quote) {
  quote = trim(quote);
  const auto hash = quote.rfind('#');
  if (hash == std::string_view::npos || hash == 0) return {quote, 0};
  std::size_t number = 0;
  const char* end = quote.data() + quote.size();
  const auto read = std::from_chars(quote.data() + hash + 1, end, number);
  if (read.ec != std::errc() || read.ptr != end || number == 0) return {quote, 0};
  return {trim(quote.substr(0, hash)), number};
}

}  // namespace

Quotes::Quotes(std::string_view prompt, const std::vector<language::Token>& tokens)
    : prompt_(prompt), tokens_(tokens) {
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    if (!is_spoken(tokens[i])) continue;
    spoken_.push_back(i);
    plain_.push_back(tokens[i].text + tokens[i].clitic);
  }
}

std::vector<Quotes::Place> Quotes::places_of(std::string_view words) const {
  std::vector<std::string> wanted;
  for (const auto& token : language::tokenize(words, longest_quote))
    if (is_spoken(token)) wanted.push_back(token.text + token.clitic);
  std::vector<Place> places;
  if (wanted.empty()) return places;
  for (auto at = plain_.begin();; ++at) {
    at = std::search(at, plain_.end(), wanted.begin(), wanted.end());
    if (at == plain_.end()) break;
    const auto first = static_cast<std::size_t>(at - plain_.begin());
    places.push_back({{spoken_[first], spoken_[first + wanted.size() - 1] + 1}});
  }
  return places.empty() ? places_apart(wanted) : places;
}

std::vector<Quotes::Place> Quotes::places_of(std::string_view words, std::size_t number) const {
  const auto all = places_of(words);
  auto same = all;
  std::erase_if(same, [&](const Place& place) {
    const auto begin = tokens_[place.front().begin].span.begin,
               end = tokens_[place.back().end - 1].span.end;
    return prompt_.substr(begin, end - begin) != words;
  });
  return same.size() < std::max<std::size_t>(number, 1) ? all : same;
}

// "round table" of a round oak table.
std::vector<Quotes::Place> Quotes::places_apart(const std::vector<std::string>& wanted) const {
  constexpr std::size_t most_between = 6;
  std::vector<Place> places;
  for (std::size_t first = 0; first < plain_.size() && wanted.size() > 1; ++first) {
    if (plain_[first] != wanted.front()) continue;
    Place place{{spoken_[first], spoken_[first] + 1}};
    std::size_t at = first, next = 1;
    for (std::size_t i = at + 1;
         next < wanted.size() && i < plain_.size() && i <= at + most_between; ++i) {
      if (plain_[i] != wanted[next]) continue;
      if (i == at + 1)
        place.back().end = spoken_[i] + 1;
      else
        place.push_back({spoken_[i], spoken_[i] + 1});
      at = i, ++next;
    }
    if (next == wanted.size()) places.push_back(std::move(place));
  }
  return places;
}

std::vector<Run> Quotes::find(std::string_view quote, std::uint32_t near) const {
  const auto [words, number] = numbered(quote);
  const auto places = places_of(words, number);
  if (number > 0 && number <= places.size()) return places[number - 1];
  const auto distance = [&](const Place& place) {
    return place.front().begin > near ? place.front().begin - near : near - place.front().begin;
  };
  const auto nearest =
      std::min_element(places.begin(), places.end(),
                       [&](const Place& a, const Place& b) { return distance(a) < distance(b); });
  return nearest == places.end() ? Place() : *nearest;
}

std::vector<Run> Quotes::find_from(std::string_view quote, std::uint32_t from) const {
  const auto [words, number] = numbered(quote);
  const auto places = places_of(words, number);
  if (number > 0 && number <= places.size()) return places[number - 1];
  const auto behind = std::find_if(places.begin(), places.end(),
                                   [&](const Place& one) { return one.front().begin >= from; });
  if (behind != places.end()) return *behind;
  return places.empty() ? Place() : places.back();
}

std::string Quotes::quote(const Run& tokens) const {
  if (tokens.begin >= tokens.end || tokens.end > tokens_.size()) return "";
  const auto begin = tokens_[tokens.begin].span.begin, end = tokens_[tokens.end - 1].span.end;
  std::string words(prompt_.substr(begin, end - begin));
  const auto places = places_of(words, 0);
  const auto own = std::find(places.begin(), places.end(), Place{tokens});
  if (own == places.end()) return "";
  if (places.size() > 1) words += " #" + std::to_string(own - places.begin() + 1);
  return words;
}

}  // namespace roomgen::brief
