#include "phrase.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomgen/base/text.h"
#include "roomgen/design/prompt_words.h"
#include "roomgen/design/tokens.h"
#include "roomgen/shape/color.h"

namespace roomgen::create {

namespace {

using design::Token;

constexpr std::size_t most_parts = 24;
constexpr std::size_t most_objects = 8;
constexpr int most_count = 50;
constexpr int usual_some = 3;  // of things named in the plural without a number

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool negates(std::string_view word) {
  return is_one_of(word, {"without", "no", "lacking", "minus", "lacks"});
}

// Words that end a noun phrase; what was said before them belongs to the noun before.
bool is_boundary(std::string_view word) {
  return is_one_of(word, {"with",  "and",     "that",    "which",      "having",   "has",
                          "have",  "featuring", "plus",  "but",        "for",      "in",
                          "on",    "around",  "of",      "made",       "from",     "under",
                          "beside", "next",   "by",      "its",        "whose",    "where",
                          "to",    "supported", "resting", "standing", "mounted",  "topped",
                          "at",    "above",   "below",   "underneath", "including", "attached",
                          "is",    "are",     "it",      "each",       "surrounded", "between"});
}

// Words that say nothing by themselves.
bool is_filler(std::string_view word) {
  return is_one_of(word, {"the",   "a",     "an",       "some",   "also",  "style", "styled", "color",
                          "colored", "coloured", "colour", "finish", "finished", "looking", "shaped",
                          "piece", "very",  "quite",    "nice",   "beautiful", "made", "please",
                          "create", "build", "make",    "me",     "design", "generate", "i", "want",
                          "need",  "us",    "out",      "legged", "sort",  "kind", "type", "something", "object", "thing",
                          "item",  "furniture", "set", "shape", "one", "there", "s", "as", "like", "so",
                          "his", "her", "their", "my", "your", "be", "should", "can", "will", "would", "just", "give",
                          "only", "it", "about", "single"});
}

/// What adjectives say before their noun is known.
struct Attributes {
  std::optional<int> count;
  std::string shape, construction, material, color, style, direction;
  std::optional<double> lean;
  std::optional<Course> course;
  std::optional<Strength> strength;
  Vec3 scale = Vec3::Ones();
  bool article = false;  ///< "a", "the", a number: a noun is to come
  bool any = false;      ///< something beside an article was said
};

void apply(const Attributes& from, PartWish& part) {
  const auto take = [](const std::string& said, std::string& to) {
    if (!said.empty()) to = said;
  };
  take(from.shape, part.shape);
  take(from.construction, part.construction);
  take(from.material, part.material);
  take(from.color, part.color);
  take(from.direction, part.direction);
  if (from.count && !part.count) part.count = from.count;
  if (from.lean) part.lean = from.lean;
  if (from.course) part.course = from.course;
  if (from.strength) part.strength = *from.strength;
  part.scale = part.scale.cwiseProduct(from.scale);
}

// The whole thing: what is said of its shape is said of what shows most of it.
void apply(const Attributes& from, Description& object) {
  if (!from.material.empty()) object.material = from.material;
  if (!from.color.empty()) object.color = from.color;
  if (!from.style.empty()) object.style = from.style;
  object.scale = object.scale.cwiseProduct(from.scale);
  if (from.shape.empty() && from.construction.empty() && !from.course && !from.lean) return;
  const bool known = std::any_of(object.parts.begin(), object.parts.end(),
                                 [](const PartWish& part) { return part.label.empty(); });
  if (!known) object.parts.insert(object.parts.begin(), PartWish());
  Attributes rest = from;
  rest.count.reset();
  rest.material.clear(), rest.color.clear();
  rest.scale = Vec3::Ones();
  apply(rest, object.parts.front());
}

class PhraseReader {
 public:
  PhraseReader(const std::string& prompt, const Words& words, const ShapeKinds& kinds)
      : prompt_(prompt), words_(words), kinds_(kinds), tokens_(design::tokenize(prompt)) {
    for (const auto& token : tokens_)
      texts_.push_back(token.kind == Token::Kind::word || token.kind == Token::Kind::number
                           ? token.text
                           : std::string(1, ','));
  }

  std::vector<Description> run() {
    while (at_ < tokens_.size()) step();
    flush();
    name_unknown();
    if (measured_ && !objects_.empty()) take_measures(objects_.front());
    return std::move(objects_);
  }

 private:
  void step() {
    const std::string& word = texts_[at_];
    if (word == ",") return boundary(false);
    if (word == "for" || word == "when" || word == "while" || word == "because") {
      boundary(false);
      return skip_purpose();
    }
    if (negates(word) || (word == "not" && at_ + 1 < texts_.size() &&
                          is_one_of(texts_[at_ + 1], {"a", "any", "one"}))) {
      boundary(false);
      negated_ = true;
      return;
    }
    // "the mattress is missing", "leave the armrests out"
    if (is_one_of(word, {"missing", "absent"}) || (word == "out" && leaves_out_)) {
      take_away_last();
      ++at_;
      return;
    }
    if (is_one_of(word, {"leave", "leaving"})) leaves_out_ = true;
    if (measure() || relation() || attribute() || noun()) return;
    if (is_boundary(word)) return boundary(word == "and" && (pending_.article || objects_.empty()));
    if (!is_filler(word)) unknown_.push_back(word);
    if (is_one_of(word, {"a", "an", "the"})) pending_.article = true;
    ++at_;
  }

  void take_away_last() {
    if (!objects_.empty() && part_ < objects_.front().parts.size())
      objects_.front().parts[part_].count = 0;
    leaves_out_ = false;
  }

  // "for four people", "for books": up to what says something about the thing again.
  void skip_purpose() {
    while (at_ < texts_.size() && texts_[at_] != "," && !negates(texts_[at_]) &&
           !is_one_of(texts_[at_], {"with", "made", "that", "which", "having", "on"}))
      ++at_;
  }

  // What was said since the last noun belongs to it; "a tall and narrow back" goes on.
  void boundary(bool goes_on) {
    if (!goes_on) last_boundary_ = texts_[at_];
    ++at_;
    if (goes_on) return;
    flush();
    negated_ = false;
  }

  void flush() {
    if (!unknown_.empty()) unknown_noun();
    if (pending_.any && !objects_.empty()) {
      Description& object = objects_.back();
      if (part_ < object.parts.size()) apply(pending_, object.parts[part_]);
      else apply(pending_, object);
    }
    if (!objects_.empty() || !pending_.any) pending_ = {};
    pending_.article = false;
  }

  // A number at this place, in figures or as a word.
  std::optional<double> number_at(std::size_t at) const {
    if (at >= tokens_.size()) return std::nullopt;
    if (tokens_[at].kind == Token::Kind::number) return tokens_[at].value;
    const auto& vocabulary = *design::built_in_vocabulary();
    const auto found = vocabulary.numbers.find(tokens_[at].text);
    if (found == vocabulary.numbers.end() || vocabulary.vague.count(tokens_[at].text))
      return std::nullopt;
    return found->second;
  }

  // "80 cm tall", "six feet long", "120 x 60 x 75 cm", "2 m by 1.4 m".
  bool measure() {
    const auto& units = design::built_in_vocabulary()->units;
    std::vector<double> numbers;
    double unit = 0.0;
    const std::size_t begin = at_;
    std::size_t at = at_, end = at_;
    while (numbers.size() < 3) {
      const auto number = number_at(at);
      if (!number) break;
      numbers.push_back(*number);
      end = ++at;
      if (at < texts_.size())
        if (const auto found = units.find(texts_[at]); found != units.end())
          unit = found->second, end = ++at;
      if (at + 1 >= texts_.size() || !is_one_of(texts_[at], {"x", "by"})) break;
      ++at;
    }
    if (numbers.empty() || unit == 0.0) return false;
    at_ = end;
    int axis = 0;
    if (at_ < texts_.size()) {
      const std::string& next = texts_[at_];
      if (is_one_of(next, {"wide", "width", "long", "length", "diameter", "across"})) axis = 0, ++at_;
      else if (is_one_of(next, {"deep", "depth"})) axis = 1, ++at_;
      else if (is_one_of(next, {"tall", "high", "height"})) axis = 2, ++at_;
    }
    // Of a part, not of the whole: "a top 2 cm thick".
    if (part_ != none || (at_ < texts_.size() && is_one_of(texts_[at_], {"thick", "thickness"}))) return true;
    // "height 50 cm"
    if (numbers.size() == 1 && at_ == end && begin > 0) {
      if (texts_[begin - 1] == "height") axis = 2;
      if (texts_[begin - 1] == "depth") axis = 1;
    }
    if (!measured_) measured_ = Vec3::Constant(std::nan(""));
    for (std::size_t i = 0; i < numbers.size() && axis + i < 3; ++i)
      (*measured_)[axis + static_cast<Eigen::Index>(i)] = numbers[i] * unit;
    if (!objects_.empty()) take_measures(objects_.back());
    return true;
  }

  // Sides that were said earlier stay.
  void take_measures(Description& object) {
    if (!object.size) object.size = Vec3::Constant(std::nan(""));
    for (int axis = 0; axis < 3; ++axis) {
      const double said = (*measured_)[axis];
      if (std::isnan(said)) continue;
      double& side = (*object.size)[axis];
      if (!std::isnan(side) && std::abs(side - said) > 1e-6) object.contradicted = true;
      side = said;
    }
    measured_.reset();
  }

  // "cups on it", "four chairs around it", "next to it", "with a lamp on top".
  bool relation() {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 12> phrases = {{
        {"on top of it", "on"}, {"on it", "on"}, {"on top", "on"}, {"around it", "around"},
        {"next to it", "side of"}, {"beside it", "side of"}, {"in front of it", "in front of"},
        {"behind it", "behind"}, {"under it", "under"}, {"underneath it", "under"},
        {"on each side", "side of"}, {"by its side", "side of"}}};
    for (const auto& [phrase, meaning] : phrases) {
      const auto pieces = split(phrase, ' ');
      if (at_ + pieces.size() > texts_.size()) continue;
      if (!std::equal(pieces.begin(), pieces.end(),
                      texts_.begin() + static_cast<std::ptrdiff_t>(at_)))
        continue;
      flush();
      if (objects_.size() > 1) objects_.back().relation = meaning;
      at_ += pieces.size();
      return true;
    }
    return false;
  }

  template <typename T>
  const T* longest(const WordMap<T>& map, std::size_t& length) const {
    std::string phrase;
    const T* found = nullptr;
    for (std::size_t n = 0; n < 3 && at_ + n < texts_.size(); ++n) {
      phrase += (n ? " " : "") + texts_[at_ + n];
      if (const auto entry = map.find(phrase); entry != map.end())
        found = &entry->second, length = n + 1;
    }
    return found;
  }

  // Whether a noun begins here, of which the word is a part: "mesh" is, "square" is not.
  std::size_t kind_here(const ShapeKind** kind = nullptr) const {
    return kinds_.match(texts_, at_, kind);
  }

  bool attribute() {
    const std::string& word = texts_[at_];
    std::size_t length = 1;
    // The name of a kind goes before its first word's other meanings: "wine rack", "round table".
    if (kind_here() > 1 && !words_.shapes.count(word) && !words_.styles.count(word)) return false;
    const auto said = [&] {
      pending_.any = true;
      at_ += length;
      return true;
    };
    if (word == "half" && at_ + 1 < texts_.size()) {
      std::size_t dozen = at_ + 1;
      if (texts_[dozen] == "a" && dozen + 1 < texts_.size()) ++dozen;
      if (texts_[dozen] == "dozen") {
        pending_.count = 6;
        pending_.article = pending_.any = true;
        at_ = dozen + 1;
        return true;
      }
    }
    if (const auto count = count_here()) {
      pending_.count = *count;
      pending_.article = true;
      if (!is_one_of(word, {"a", "an"})) pending_.any = true;
      ++at_;
      if (at_ < texts_.size() && texts_[at_] == "of") ++at_;
      return true;
    }
    if (const auto* strength = longest(words_.strengths, length))
      return pending_.strength = *strength, said();
    if (const auto* style = longest(words_.styles, length)) return pending_.style = *style, said();
    const auto* construction = longest(words_.constructions, length);
    const auto* lean = longest(words_.leans, length);
    const auto* course = longest(words_.courses, length);
    const auto* shape = longest(words_.shapes, length);
    if (construction) pending_.construction = *construction;
    if (lean) pending_.lean = *lean;
    if (course) pending_.course = *course;
    if (shape) pending_.shape = *shape;
    if (construction || lean || course || shape) return said();
    if (const auto* material = longest(words_.materials, length)) {
      pending_.material = material->name;
      return said();
    }
    if (const auto* factors = longest(words_.scales, length); factors && part_here(nullptr) == 0)
      return pending_.scale = pending_.scale.cwiseProduct(*factors), said();
    if (words_.directions.count(word)) return pending_.direction = word, said();
    return color_here();
  }

  // "dark blue" is "darkblue".
  bool color_here() {
    for (const std::size_t n : {std::size_t{2}, std::size_t{1}}) {
      if (at_ + n > texts_.size()) continue;
      const std::string name = n == 2 ? texts_[at_] + texts_[at_ + 1] : texts_[at_];
      if (!shape::parse_color(name) || kind_here() > 0) continue;
      pending_.color = name;
      pending_.any = true;
      at_ += n;
      return true;
    }
    return false;
  }

  std::optional<int> count_here() const {
    const Token& token = tokens_[at_];
    if (token.kind == Token::Kind::number && token.value == std::floor(token.value) &&
        token.value <= most_count)
      return static_cast<int>(token.value);
    const auto& vocabulary = *design::built_in_vocabulary();
    const auto found = vocabulary.numbers.find(token.text);
    if (found == vocabulary.numbers.end() || vocabulary.vague.count(token.text)) return std::nullopt;
    if (is_one_of(token.text, {"a", "an", "single", "another"})) return std::nullopt;
    return found->second;
  }

  // How many words from here name a part, and its label.
  std::size_t part_here(std::string* label) const {
    std::string phrase;
    std::size_t length = 0;
    for (std::size_t n = 0; n < 3 && at_ + n < texts_.size(); ++n) {
      phrase += (n ? " " : "") + texts_[at_ + n];
      if (const auto found = words_.parts.find(phrase); found != words_.parts.end()) {
        length = n + 1;
        if (label) *label = found->second;
      }
    }
    // "three-legged"
    if (length == 0 && texts_[at_].size() > 4 && texts_[at_].ends_with("ed")) {
      std::string stem = texts_[at_].substr(0, texts_[at_].size() - 2);
      if (stem.size() > 2 && stem[stem.size() - 1] == stem[stem.size() - 2]) stem.pop_back();
      if (const auto found = words_.parts.find(stem); found != words_.parts.end()) {
        length = 1;
        if (label) *label = found->second;
      }
    }
    return length;
  }

  bool noun() {
    const ShapeKind* kind = nullptr;
    const std::size_t kind_length = kind_here(&kind);
    std::string label;
    std::size_t part_length = part_here(&label);
    // "an open shelf": the longer name of a kind ends with what is a part here.
    if (!objects_.empty() && kind_length > part_length)
      if (const auto ending = words_.parts.find(texts_[at_ + kind_length - 1]);
          ending != words_.parts.end() && head_has(ending->second))
        label = ending->second, part_length = kind_length;
    if (kind_length == 0 && part_length == 0) return false;
    if (is_part(kind_length, part_length, label)) return add_part(label, part_length);
    if (kind_length == 0) return false;
    return add_object(*kind, kind_length);
  }

  bool is_part(std::size_t kind_length, std::size_t part_length, const std::string& label) const {
    if (part_length == 0 || kind_length > part_length) return false;
    if (kind_length == 0) return true;
    // "seat stool": a part before the thing that it is a part of.
    const std::size_t after = at_ + part_length;
    if (objects_.empty()) return after < texts_.size() && kinds_.match(texts_, after, nullptr) > 0;
    const ShapeKind* head = kinds_.find(objects_.front().kind);
    return !head || kinds_.labels(head->recipe).count(label) || !has_relation(after);
  }

  bool head_has(const std::string& label) const {
    const ShapeKind* head = kinds_.find(objects_.front().kind);
    return head && kinds_.labels(head->recipe).count(label) > 0;
  }

  // Does what follows the noun put it somewhere: "four chairs around it"?
  bool has_relation(std::size_t from) const {
    for (std::size_t at = from; at < std::min(from + 2, texts_.size()); ++at)
      if (is_one_of(texts_[at], {"around", "on", "next", "beside", "under", "underneath", "behind"}))
        return true;
    return from + 2 < texts_.size() && texts_[from] == "in" && texts_[from + 1] == "front";
  }

  bool add_part(const std::string& label, std::size_t length) {
    at_ += length;
    // "a two-drawer nightstand": the thing is still to come.
    std::vector<PartWish>& parts = objects_.empty() ? early_ : objects_.front().parts;
    unknown_.clear();
    auto known = std::find_if(parts.begin(), parts.end(),
                              [&](const PartWish& part) { return part.label == label; });
    if (known == parts.end()) {
      if (parts.size() >= most_parts) return true;
      parts.push_back({});
      known = parts.end() - 1;
      known->label = label;
    }
    if (known->count && !objects_.empty() &&
        ((pending_.count && *pending_.count != *known->count) || (negated_ != (*known->count == 0))))
      objects_.front().contradicted = true;
    apply(pending_, *known);
    if (negated_) known->count = 0;
    part_ = objects_.empty() ? none : static_cast<std::size_t>(known - parts.begin());
    pending_ = {};
    return true;
  }

  bool add_object(const ShapeKind& kind, std::size_t length) {
    std::string noun;
    for (std::size_t i = 0; i < length; ++i) noun += (i ? " " : "") + texts_[at_ + i];
    at_ += length;
    // "a chair that looks like a chair", "a rack for bottles": no other thing beside the first.
    const bool beside = is_one_of(last_boundary_, {"with", "and", "plus", ",", ""}) || has_relation(at_);
    if (!objects_.empty() && (kind.name == objects_.front().kind || negated_ || !beside ||
                              objects_.size() >= most_objects)) {
      pending_ = {};
      return true;
    }
    unknown_.clear();
    Description object;
    object.prompt = prompt_;
    object.noun = noun;
    object.kind = kind.name;
    // "cups on it": some of them.
    const bool some = !objects_.empty() && singular(texts_[at_ - 1]) != texts_[at_ - 1];
    object.count = std::clamp(pending_.count.value_or(some ? usual_some : 1), 0, most_count);
    object.parts = std::move(early_);
    early_.clear();
    if (measured_) object.size = measured_, measured_.reset();
    pending_.count.reset();
    apply(pending_, object);
    pending_ = {};
    objects_.push_back(std::move(object));
    part_ = none;
    return true;
  }

  // Words of place, number and purpose are no parts: "down the right side".
  static bool says_nothing(const std::string& word) {
    const auto& vocabulary = *design::built_in_vocabulary();
    return vocabulary.no_things.count(word) || vocabulary.people_words.count(word) ||
           vocabulary.stops.count(word);
  }

  // A noun phrase of which no word is known: the thing itself, or a part of it.
  void unknown_noun() {
    if (objects_.empty()) {
      start_unknown();
    } else if (pending_.article && objects_.front().parts.size() < most_parts &&
               is_one_of(last_boundary_, {"with", "and", "plus", "having", "has", "have", "without"}) &&
               !says_nothing(unknown_.back())) {
      PartWish part;
      part.label = singular(unknown_.back());
      if (negated_) part.count = 0;
      apply(pending_, part);
      objects_.front().parts.push_back(std::move(part));
      part_ = objects_.front().parts.size() - 1;
      pending_ = {};
    }
    unknown_.clear();
  }

  // A thing of no known kind: the nearest one stands for it, if any is near.
  void start_unknown() {
    Description object;
    object.prompt = prompt_;
    object.noun = join(unknown_, " ");
    object.approximate = true;
    if (const ShapeKind* kind = kinds_.nearest(object.noun);
        kind && ends_alike(object.noun, *kind))
      object.kind = kind->name;
    object.parts = std::move(early_);
    early_.clear();
    if (measured_) object.size = measured_, measured_.reset();
    object.count = std::clamp(pending_.count.value_or(1), 0, most_count);
    pending_.count.reset();
    apply(pending_, object);
    pending_ = {};
    objects_.push_back(std::move(object));
    part_ = none;
  }

  // The last words say what a thing is.
  static bool ends_alike(const std::string& noun, const ShapeKind& kind) {
    const auto wanted = words(noun);
    if (wanted.empty()) return false;
    const auto ends = [&](const std::string& name) {
      const auto pieces = words(name);
      return !pieces.empty() && singular(pieces.back()) == singular(wanted.back());
    };
    return ends(kind.name) || std::any_of(kind.names.begin(), kind.names.end(), ends);
  }

  // Only parts were named, or nothing.
  void name_unknown() {
    if (objects_.empty()) start_unknown();
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const std::string& prompt_;
  const Words& words_;
  const ShapeKinds& kinds_;
  std::vector<Token> tokens_;
  std::vector<std::string> texts_;
  std::size_t at_ = 0;
  std::vector<Description> objects_;
  std::vector<PartWish> early_;  ///< parts named before their object
  Attributes pending_;
  std::vector<std::string> unknown_;
  std::string last_boundary_;
  std::optional<Vec3> measured_;
  std::size_t part_ = none;  ///< of the first object, what was named last
  bool negated_ = false, leaves_out_ = false;
};

}  // namespace

std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds) {
  return PhraseReader(prompt, words, kinds).run();
}

}  // namespace roomgen::create
