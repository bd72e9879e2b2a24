// brief.json as it is read: the clauses of the room. Those of things are in form_things.cpp.
#include "brief_form.h"

#include <algorithm>

#include "chat/loose_json.h"
#include "floor_shapes.h"
#include "kinds/noun_kind.h"
#include "language/inflection.h"
#include "prompt_passes.h"
#include "reply_measure.h"
#include "room_type.h"
#include "roomgen/base/text.h"
#include "scene/opening_kind.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t most_clauses = 40, most_quotes = 12, most_problems = 12, most_repairs = 40;
constexpr std::size_t longest_text = 300;    // bytes
constexpr std::uint32_t widest_clause = 16;  // tokens

}  // namespace

FormNode FormNode::operator[](const std::string& key) const {
  const Json* found = json ? member(*json, {key}) : nullptr;
  return {found, pointer + "/" + key};
}

std::vector<FormNode> FormNode::elements(std::size_t most) const {
  std::vector<FormNode> nodes;
  if (!json) return nodes;
  if (!json->is_array()) return {*this};
  for (std::size_t i = 0; i < std::min(most, json->size()); ++i)
    if (!(*json)[i].is_null()) nodes.push_back({&(*json)[i], pointer + "/" + std::to_string(i)});
  return nodes;
}

std::string FormNode::text() const {
  if (!json) return "";
  if (json->is_number()) return json->dump();
  return json->is_string()
             ? shortened(std::string(trim(json->get_ref<const std::string&>())), longest_text)
             : "";
}

std::optional<double> FormNode::number() const {
  if (!json) return std::nullopt;
  if (json->is_number()) return json->get<double>();
  if (const auto measure = single_measure(*json)) return measure->value;
  return std::nullopt;
}

std::vector<double> FormNode::numbers(std::size_t most) const {
  std::vector<double> values;
  for (const auto& node : elements(most))
    if (const auto value = node.number()) values.push_back(*value);
  return values;
}

bool FormNode::flag() const {
  return json && (*json == Json(true) || text() == "true" || text() == "yes");
}

Form::Form(FormNode node, const FormContext& context, BriefReading& reading)
    : root(std::move(node)),
      quotes(context.prompt, reading.brief.tokens),
      kinds(context.kinds),
      table(context.table),
      result(reading),
      brief(reading.brief) {}

bool Form::remark(const FormNode& clause, std::uint32_t near) {
  const auto said = quoted_as_one(clause["words"], near);
  if (said) entry(*said, Heard::As::room, said_remark);
  return said.has_value();
}

void Form::problem(const FormNode& node, const std::string& what) {
  if (result.problems.size() < most_problems) result.problems.push_back(node.pointer + ": " + what);
}

void Form::repair(const std::string& what) {
  if (result.repairs.size() < most_repairs) result.repairs.push_back(what);
}

std::size_t Form::entry(const language::Run& tokens, Heard::As as, const std::string& word) {
  for (std::size_t i = 0; i < brief.heard.size(); ++i)
    if (brief.heard[i].tokens == tokens && brief.heard[i].as == as && brief.heard[i].word == word)
      return i;
  return brief::hear(brief, tokens, as, word);
}

// "a chair … by the desk" quotes twice.
std::vector<std::string> Form::quoted(const FormNode& node) const {
  std::vector<std::string> texts;
  for (const auto& one : node.elements(most_quotes)) {
    std::string text = one.text();
    for (std::size_t at = 0; (at = text.find("…")) != std::string::npos;)
      text.replace(at, 3, "...");
    for (std::size_t at; (at = text.find("...")) != std::string::npos; text.erase(0, at + 3))
      texts.push_back(text.substr(0, at));
    texts.push_back(text);
  }
  std::erase_if(texts, [](const std::string& text) { return trim(text).empty(); });
  return texts;
}

std::vector<std::size_t> Form::hear(const FormNode& node, Heard::As as, const std::string& word,
                                    std::uint32_t near) {
  std::vector<std::size_t> heard;
  for (const auto& quote : quoted(node)) {
    const auto runs = quotes.find(quote, near);
    if (runs.empty()) problem(node, "\"" + quote + "\" is not in the wish; quote its own words");
    for (const auto& run : runs) heard.push_back(entry(run, as, word));
  }
  return heard;
}

std::optional<language::Run> Form::quoted_as_one(const FormNode& words, std::uint32_t near) {
  std::optional<language::Run> all;
  for (const auto& quote : quoted(words)) {
    const auto runs = quotes.find(quote, near);
    if (runs.empty()) problem(words, "\"" + quote + "\" is not in the wish; quote its own words");
    for (const auto& run : runs) {
      if (!all) all = run;
      const language::Run wider{std::min(all->begin, run.begin), std::max(all->end, run.end)};
      if (wider.size() <= widest_clause) all = wider;
    }
  }
  return all;
}

std::size_t Form::hear_as_one(const FormNode& clause, Heard::As usual, std::uint32_t near) {
  const auto all = quoted_as_one(clause["words"], near);
  if (!all) return HeardWords::none;
  return entry(*all, usual, usual == Heard::As::absence ? said_limit : "");
}

std::vector<language::Run> Form::next_words(const FormNode& node) {
  std::vector<language::Run> words;
  for (const auto& quote : quoted(node)) {
    std::uint32_t& from = read_up_to_[quote];
    const auto runs = quotes.find_from(quote, from);
    if (runs.empty())
      problem(node, "\"" + quote + "\" is not in the wish; quote its own words");
    else
      from = runs.back().end;
    words.insert(words.end(), runs.begin(), runs.end());
  }
  return words;
}

FormName name_in_form(const std::string& name, const KindTable& table) {
  const auto tokens = tokenize(name);
  const auto behind = [&](std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < tokens.size(); ++i)
      text += (text.empty() ? "" : " ") +
              (i + 1 < tokens.size() ? tokens[i].text : language::singular(tokens[i].text));
    return text;
  };
  const auto before = [&](std::size_t first) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < first; ++i) words.push_back(tokens[i].text);
    return words;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (KindMention found = mention_at(table, tokens, i);
        found.length > 0 && i + found.length == tokens.size() &&
        (i == 0 || !table.only_resembles(found.name)))
      return {std::move(found), before(i)};
  for (std::size_t i = 0; i < tokens.size(); ++i)
    for (const NounKind& meant : {misspelt_kind(table, behind(i)), inferred_kind(table, behind(i))})
      if (meant.kind)
        return {{meant.kind, tokens.size() - i, false, behind(i), meant.basis, ""}, before(i)};
  return {};
}

language::Measure::Limit bound_in_form(const FormNode& node) {
  using Bound = language::Measure::Limit;
  const std::string text = node.text();
  return text.find("least") != std::string::npos  ? Bound::least
         : text.find("most") != std::string::npos ? Bound::most
                                                  : Bound::exact;
}

namespace {

/// What a form says of the room itself.
class FormRoom {
 public:
  explicit FormRoom(Form& form) : form_(form), brief_(form.brief) {}

  void read() {
    read_type();
    for (const auto& clause : form_.root["room"]["clauses"].elements(most_clauses))
      read_clause(clause);
    for (const auto& opening : form_.root["openings"].elements(most_clauses)) read_opening(opening);
    for (const auto& finish : form_.root["finishes"].elements(most_clauses)) read_finish(finish);
    read_styles("styles", "style", brief_.styles);
    read_styles("palette", "look", brief_.palette);
    const FormNode people = form_.root["people"];
    brief_.people =
        std::clamp(static_cast<int>(std::clamp(people["count"].number().value_or(0.0), 0.0, 1e6)),
                   0, most_people);
    brief_.seated =
        std::clamp(static_cast<int>(std::clamp(people["seats"].number().value_or(0.0), 0.0, 1e6)),
                   0, most_people);
    form_.hear(people["words"], Heard::As::person, "", 0);
    read_remarks(form_.root["remarks"]);
    for (const auto& talk : form_.root["talk"].elements(10 * most_clauses)) read_talk(talk);
  }

 private:
  void read_type() {
    const FormNode room = form_.root["room"];
    brief_.type = lower(room["type"].text());
    const auto heard = form_.hear(room["words"], Heard::As::room, "kind", 0);
    const auto names = room_names(form_.kinds);
    const std::string plain = join(words(brief_.type), " ");
    if (const auto known = names.find(plain); known != names.end()) brief_.type = known->second;
    brief_.type_known = form_.kinds.types.count(brief_.type) > 0;
    // What nobody said is no clause, and only the room of things that usually stand there.
    if (heard.empty() && !brief_.type.empty())
      form_.repair("the wish names no kind of room; taken for a " + brief_.type);
  }

  void read_clause(const FormNode& clause) {
    const std::string is = clause["is"].text(), name = clause["name"].text();
    const auto values = clause["numbers"].numbers(3);
    const auto positive = [&](std::size_t count) {
      return values.size() >= count && std::all_of(values.begin(), values.end(), [](double value) {
               return value > 0.0 && value < 1e4;
             });
    };
    std::string word = is;
    if (is == "size" && positive(2))
      brief_.size = Vec2(values[0], values[1]);
    else if (is == "area" && positive(1))
      brief_.area = values[0];
    else if (is == "height" && positive(1))
      brief_.height = values[0];
    else if (is == "proportion" && positive(2))
      brief_.shape.proportion = Range{values[0], values[1]};
    else if (!read_shape(is, name, word)) {
      if (!form_.remark(clause, 0))
        form_.problem(clause, "neither its numbers and name nor its words say anything of a room");
      return;
    }
    form_.hear(clause["words"], Heard::As::room, word, 0);
  }

  bool read_shape(const std::string& is, const std::string& name, std::string& word) {
    const auto& shapes = built_in_floor_shapes();
    if (!shapes) return false;
    const auto meant = [&](const auto& names, const auto& known) {
      if (known.count(name)) return name;
      for (const std::string& one :
           {lower(name), join(words(name), " "), join(words(name), " ") + " shaped"})
        if (const auto found = names.find(one); found != names.end()) return found->second;
      return std::string();
    };
    if (is == "proportion") {
      const auto found = shapes->proportions.find(lower(name));
      if (found == shapes->proportions.end()) return false;
      brief_.shape.proportion = found->second;
      return true;
    }
    if (is == "shape") {
      const std::string outline = meant(shapes->outline_names, shapes->outlines);
      if (!outline.empty()) brief_.shape.outline = outline;
      return !outline.empty();
    }
    word = is == "feature" ? meant(shapes->feature_names, shapes->features) : "";
    if (!word.empty()) brief_.shape.features.push_back(word);
    return !word.empty();
  }

  static const OpeningKind* opening_called(const std::string& name) {
    const auto& kinds = OpeningKinds::built_in();
    if (!kinds) return nullptr;
    if (const OpeningKind* kind = kinds->find(name)) return kind;
    const auto pieces = words(name);
    return pieces.empty() ? nullptr : kinds->find(pieces.back());
  }
  static std::optional<double> length_in(const FormNode& node) {
    const auto value = node.number();
    return value && *value > 0.0 ? std::optional(std::clamp(*value, 0.3, 15.0)) : std::nullopt;
  }

  void read_opening(const FormNode& node) {
    const std::string name = lower(node["kind"].text());
    const OpeningKind* kind = opening_called(name);
    read_remarks(node["remarks"]);
    if (!kind && form_.remark(node, 0)) return;
    if (!kind) return form_.problem(node["kind"], "\"" + name + "\" is no window, door or passage");
    OpeningWish wish;
    wish.kind = kind->name;
    wish.type = kind->type;
    const auto count = node["count"].number();
    constexpr double some = 2.0;
    wish.count = static_cast<int>(std::clamp(count.value_or(some), 0.0, 12.0));
    wish.counted = count.has_value();
    wish.width = length_in(node["width"]), wish.height = length_in(node["height"]);
    place_opening(node, wish);
    add_opening(node, wish);
  }

  // Windows of which no more is said than how many there are.
  static bool is_plain(const OpeningWish& wish) {
    return wish.kind == "window" && !wish.has_place() && !wish.width && !wish.height;
  }

  void add_opening(const FormNode& node, const OpeningWish& wish) {
    if (is_plain(wish)) return add_windows(node, wish.count);
    if (wish.count == 0) return void(form_.remark(node, 0));
    if (wish.type == OpeningType::window && !brief_.windows) brief_.windows = 0;
    brief_.openings.push_back(wish);
    form_.hear(node["words"], Heard::As::thing, wish.kind, 0);
  }
  void add_windows(const FormNode& node, int count) {
    brief_.windows = count + brief_.windows.value_or(0);
    brief_.wide_windows = brief_.wide_windows || node["large"].flag();
    form_.hear(node["words"], count == 0 ? Heard::As::absence : Heard::As::thing, "window", 0);
  }

  // Sides as a viewer of the plan has them: front, right, back, left.
  static void place_opening(const FormNode& node, OpeningWish& wish) {
    const auto type_named = [](const std::string& text) -> std::optional<OpeningType> {
      for (const auto type : {OpeningType::door, OpeningType::window, OpeningType::passage})
        if (text == name(type)) return type;
      return std::nullopt;
    };
    static const std::map<std::string, int, std::less<>> sides = {
        {"front", 0}, {"south", 0}, {"wall 0", 0}, {"right", 1}, {"east", 1}, {"wall 1", 1},
        {"back", 2},  {"north", 2}, {"wall 2", 2}, {"left", 3},  {"west", 3}, {"wall 3", 3}};
    for (const auto& wall : node["walls"].elements(4))
      if (const auto side = sides.find(join(words(lower(wall.text())), " ")); side != sides.end())
        wish.sides.push_back(side->second);
    if (node["large"].flag()) wish.wide = 1.4;
    wish.opposite = type_named(node["opposite"].text());
    wish.beside = type_named(node["beside"].text());
  }

  void read_remarks(const FormNode& quotes) {
    for (const auto& quote : quotes.elements(most_clauses))
      form_.hear(quote, Heard::As::room, said_remark, 0);
  }

  void read_finish(const FormNode& node) {
    const std::string looks = lower(node["looks"].text());
    std::string part = lower(node["part"].text());
    if (looks.empty()) return form_.problem(node["looks"], "is missing");
    RoomMaterials& materials = brief_.materials;
    if (part == "floor")
      materials.floor = looks;
    else if (part == "walls")
      materials.walls = looks;
    else if (part == "ceiling")
      materials.ceiling = looks;
    else if (part.find("wall") != std::string::npos)
      cover_named(materials, accent_name).finish = looks;
    else if (form_.remark(node, 0))
      return;
    else
      return form_.problem(node["part"], "must be floor, walls, accent wall or ceiling");
    form_.hear(node["words"], Heard::As::attribute, looks, 0);
  }

  void read_styles(const char* list, const char* key, std::vector<std::string>& names) {
    for (const auto& node : form_.root[list].elements(most_clauses)) {
      const std::string name = lower((node.json->is_object() ? node[key] : node).text());
      if (name.empty()) continue;
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      form_.hear(node.json->is_object() ? node["words"] : node, Heard::As::style, name, 0);
    }
  }

  void read_talk(const FormNode& node) {
    const FormNode quotes = node.json->is_object() ? node["words"] : node;
    const std::string as = node.json->is_object() ? node["as"].text() : "talk";
    static const std::map<std::string, std::pair<Heard::As, const char*>, std::less<>> meanings = {
        {"talk", {Heard::As::room, ""}},          {"activity", {Heard::As::activity, ""}},
        {"person", {Heard::As::person, ""}},      {"aim", {Heard::As::activity, said_remark}},
        {"mood", {Heard::As::room, said_remark}}, {"unclear", {Heard::As::not_understood, ""}}};
    const auto meaning = meanings.find(as);
    if (meaning == meanings.end())
      return form_.problem(
          node["as"], "\"" + as + "\" is none of talk, activity, person, aim, mood and unclear");
    form_.hear(quotes, meaning->second.first, meaning->second.second, 0);
  }

  Form& form_;
  Brief& brief_;
};

}  // namespace

BriefReading brief_from_json(const Json& json, std::string_view prompt, const RoomKinds& kinds,
                             const KindTable& table, const std::string& pointer) {
  BriefReading result;
  const auto& words = built_in_vocabulary();
  if (!words) return result;
  result.brief.tokens = language::tokenize(prompt, max_tokens);
  Form form({&json, pointer}, {prompt, kinds, table}, result);
  FormRoom(form).read();
  read_form_things(form, *words);
  result.brief.understood = !result.brief.heard.empty();
  return result;
}

}  // namespace roomgen::brief
