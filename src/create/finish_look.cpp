#include "finish_look.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "shape/color.h"

namespace roomgen::create {

namespace {

constexpr std::size_t longest_look = 3;  // words of a phrase

/// One phrase of a description, and what it is.
struct LookPhrase {
  enum class Kind { tone, shade, gloss, pattern, substance, part, joint, other };
  Kind kind = Kind::other;
  std::string text;
};

LookPhrase::Kind kind_of_phrase(const std::string& text, const FinishTable& table) {
  using Kind = LookPhrase::Kind;
  if (table.gloss.count(text)) return Kind::gloss;
  if (table.patterns.count(text)) return Kind::pattern;
  if (table.stuffs.count(text)) return Kind::substance;
  if (table.tones.count(text)) return Kind::tone;
  if (table.shades.count(text)) return Kind::shade;
  if (table.parts.count(singular(text))) return Kind::part;
  return text == "with" || text == "on" ? Kind::joint : Kind::other;
}

// The longest phrases that are known, and single words between them.
std::vector<LookPhrase> look_phrases(std::string_view text, const FinishTable& table) {
  const auto all = words(text);
  std::vector<LookPhrase> result;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t count = std::min(longest_look, all.size() - i);
    const auto phrase = [&] {
      const auto from = all.begin() + static_cast<std::ptrdiff_t>(i);
      return join({from, from + static_cast<std::ptrdiff_t>(count)}, " ");
    };
    while (count > 1 && kind_of_phrase(phrase(), table) == LookPhrase::Kind::other) --count;
    result.push_back({kind_of_phrase(phrase(), table), phrase()});
    i += count;
  }
  return result;
}

// "wooden oak": the more special one counts.
bool is_more_special(const shape::Surface& substance, const std::string& stuff, const PartLook& than) {
  return !than.substance || (than.substance->name.starts_with(stuff) && substance.name != than.substance->name);
}

// Groups of words, each for one stuff.
class FinishReading {
 public:
  FinishReading(std::string_view kind, const FinishTable& table) : main_(table.main_stuff(kind)), table_(table) {}

  std::map<std::string, std::string> read(std::string_view description) {
    if (main_.empty()) return {};
    for (const auto& phrase : look_phrases(description, table_)) take(phrase);
    end_group();
    return std::move(finish_);
  }

 private:
  void take(const LookPhrase& phrase) {
    using Kind = LookPhrase::Kind;
    switch (phrase.kind) {
      case Kind::other:
        return;
      case Kind::joint:
        end_group();
        in_parts_ = true;
        return;
      case Kind::part:
        if (in_parts_) say(table_.parts.at(singular(phrase.text)));
        return;
      case Kind::substance:
        pending_.push_back(phrase.text);
        if (!in_parts_) say(table_.stuffs.at(phrase.text));
        return;
      default:
        pending_.push_back(phrase.text);
    }
  }

  // Tones behind a substance, or without any.
  void end_group() {
    if (!pending_.empty() && !in_parts_) say(main_);
    pending_.clear();
  }

  void say(const std::string& stuff) {
    std::string& words = finish_[stuff];
    // What was said of the whole goes before what is said of its parts.
    if (!in_parts_ || words.empty()) words += (words.empty() ? "" : " ") + join(pending_, " ");
    if (words.empty()) finish_.erase(stuff);
    pending_.clear();
  }

  const std::string& main_;
  const FinishTable& table_;
  std::map<std::string, std::string> finish_;
  std::vector<std::string> pending_;
  bool in_parts_ = false;
};

}  // namespace

Tone in_shades(Tone tone, const std::vector<Shade>& shades) {
  for (const auto& shade : shades) tone += static_cast<float>(shade.by) * (shade.towards - tone);
  return tone;
}

std::optional<Tone> PartLook::tone() const {
  if (!tones.empty()) return tones.front();
  if (pattern && pattern->first) return pattern->first;
  if (!substance) return std::nullopt;
  const auto color = shape::parse_color(substance->color).value_or(shape::Rgb{200, 200, 200});
  return in_shades(Tone(color[0], color[1], color[2]), shades);
}

PartLook read_look(std::string_view text, const FinishTable& table) {
  using Kind = LookPhrase::Kind;
  PartLook look;
  for (const auto& phrase : look_phrases(text, table)) {
    const std::string& name = phrase.text;
    if (phrase.kind == Kind::shade) look.shades.push_back(table.shades.at(name));
    if (phrase.kind == Kind::tone) look.tones.push_back(table.tones.at(name));
    if (phrase.kind == Kind::gloss) look.gloss = table.gloss.at(name);
    if (phrase.kind == Kind::pattern) look.pattern = &table.patterns.at(name);
    if (phrase.kind == Kind::substance) {
      const auto& substance = table.substances.at(name);
      const auto& stuff = table.stuffs.at(name);
      if (is_more_special(substance, stuff, look)) look.substance = &substance, look.stuff = stuff;
    }
    if (phrase.kind < Kind::part) look.said.push_back(name);
  }
  for (auto& tone : look.tones) tone = in_shades(tone, look.shades);
  return look;
}

std::map<std::string, std::string> wanted_finish(std::string_view description, std::string_view kind,
                                                 const FinishTable& table) {
  return FinishReading(kind, table).read(description);
}

}  // namespace roomgen::create
