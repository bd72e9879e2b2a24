#include "picture_text.h"

#include <algorithm>

#include "quotes.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

constexpr std::string_view mark = "Image ";

// Of all words that a clause quotes; 0 where the text of the wish has some of them.
int picture_of_clause(const Json& clause, std::string_view wish,
                      const std::vector<language::Token>& tokens, const Quotes& quotes) {
  int picture = 0;
  for (const auto& quote : clause["words"])
    for (const auto& run : quotes.find(quote.get<std::string>(), 0)) {
      picture = picture_of(wish, tokens[run.begin].span.begin);
      if (picture == 0) return 0;
    }
  return picture;
}

}  // namespace

std::string with_pictures(std::string_view text, const std::vector<std::string>& shown) {
  std::string wish(trim(text));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    std::string line(trim(shown[i]));
    std::replace(line.begin(), line.end(), '\n', ' ');
    wish += (wish.empty() ? "" : "\n") + std::string(mark) + std::to_string(i + 1) + ": " + line;
  }
  return wish;
}

int picture_of(std::string_view wish, std::size_t byte) {
  const auto end = wish.rfind('\n', byte);
  const std::string_view line = end == wish.npos ? wish : wish.substr(end + 1);
  const bool is_marked = line.starts_with(mark) && line.size() > mark.size() + 1 &&
                         line[mark.size() + 1] == ':';
  const char digit = is_marked ? line[mark.size()] : '0';
  return digit > '0' && digit <= '9' ? digit - '0' : 0;
}

void name_pictures(Json& form, std::string_view wish,
                   const std::vector<language::Token>& tokens) {
  const Quotes quotes(wish, tokens);
  const auto name = [&](Json& clause) {
    if (const int picture = picture_of_clause(clause, wish, tokens, quotes); picture > 0)
      clause["source"] = "image " + std::to_string(picture);
  };
  name(form["room"]);
  for (const char* list :
       {"openings", "finishes", "styles", "palette", "things", "absences", "limits"})
    for (auto& clause : form[list]) name(clause);
  if (form.contains("rooms"))
    for (auto& room : form["rooms"]) name_pictures(room, wish, tokens);
}

}  // namespace roomgen::brief
