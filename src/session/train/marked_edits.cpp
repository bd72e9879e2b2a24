#include "train/marked_edits.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edit_words.h"

namespace roomgen {

namespace {

using nlohmann::json;

constexpr std::string_view order_prefix = "do:";

template <typename Names>
std::optional<std::size_t> number_of(const Names& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

struct Mark {
  EditRole role = EditRole::idle;
  std::optional<EditDeed> deed;
  std::size_t end = 0;  ///< bytes
};

Mark read_mark(const std::string& name) {
  const bool is_order = name.starts_with(order_prefix);
  const auto role = number_of(edit_role_names, is_order ? "do" : std::string_view(name));
  const auto deed = is_order ? number_of(deed_names, std::string_view(name).substr(order_prefix.size())) : std::nullopt;
  if (!role || (is_order && !deed)) throw std::runtime_error("no role: " + name);
  return {static_cast<EditRole>(*role), deed ? std::optional(static_cast<EditDeed>(*deed)) : std::nullopt};
}

// The marks cover the sentence but for white space between them.
std::vector<Mark> read_marks(const json& line, const std::string& sentence) {
  std::vector<Mark> marks;
  std::size_t at = 0;
  for (const auto& mark : line.at("marks")) {
    marks.push_back(read_mark(mark.at(1)));
    for (const char c : mark.at(0).get<std::string>()) {
      if (std::isspace(static_cast<unsigned char>(c))) continue;
      while (at < sentence.size() && std::isspace(static_cast<unsigned char>(sentence[at]))) ++at;
      if (at >= sentence.size() || sentence[at] != c) throw std::runtime_error("the marks do not cover: " + sentence);
      ++at;
    }
    marks.back().end = at;
  }
  if (marks.empty()) throw std::runtime_error("no marks: " + sentence);
  return marks;
}

const Mark& mark_at(const std::vector<Mark>& marks, std::size_t byte) {
  for (const auto& mark : marks)
    if (byte < mark.end) return mark;
  return marks.back();
}

// Where no words order, what is meant says what for; where nothing is meant either, the order before.
std::optional<EditDeed> deed_meant(const json& line, std::size_t order) {
  const auto& meaning = line.at("meaning");
  if (!meaning.is_array() || meaning.size() <= order || !meaning[order].at("op").is_string()) return std::nullopt;
  const auto number = number_of(deed_names, meaning[order].at("op").get<std::string>());
  return number ? std::optional(static_cast<EditDeed>(*number)) : std::nullopt;
}

// Only where each order means one thing is it clear which is whose.
std::optional<std::size_t> place_meant(const json& line, std::size_t orders, std::size_t order) {
  const auto& meaning = line.at("meaning");
  if (!meaning.is_array() || meaning.size() != orders || !meaning[order].at("relation").is_string()) return std::nullopt;
  const std::string relation = meaning[order].at("relation");
  return number_of(place_names, relation == "closer to" ? std::string("towards") : relation);
}

void read_orders(const json& line, const std::vector<Mark>& marks, MarkedEdit& edit) {
  const auto orders = orders_of(edit.text, stretches_of(edit.roles));
  std::string previous;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    std::optional<EditDeed> deed;
    for (const auto& part : orders[i].parts)
      if (part.role == EditRole::order && !deed) deed = mark_at(marks, edit.text.raw[part.begin].span.begin).deed;
    if (!deed) deed = deed_meant(line, i);
    if (!deed && !previous.empty()) deed = static_cast<EditDeed>(*number_of(deed_names, previous));
    if (!deed) continue;
    edit.orders.push_back({orders[i], *deed, previous, place_meant(line, orders.size(), i)});
    previous = deed_names[static_cast<std::size_t>(*deed)];
  }
}

// Nothing for a sentence of which no word is read, whatever it says.
std::optional<MarkedEdit> read_line(const json& line, const MarkedScenes& scenes) {
  const std::string sentence = line.at("sentence");
  const auto scene = scenes.find(line.at("scene").get<std::string>());
  if (scene == scenes.end()) throw std::runtime_error("no such scene");
  auto text = written_edit(sentence, scene->second, KindTable::built_in(), {});
  if (!text) return std::nullopt;
  MarkedEdit edit{*std::move(text), {}, {}, {}};
  const auto marks = read_marks(line, sentence);
  for (const auto& token : edit.text.raw) edit.roles.push_back(mark_at(marks, token.span.begin).role);
  edit.signs = signs_of(edit.text);
  read_orders(line, marks, edit);
  return edit;
}

Object thing_of(const std::string& category, std::size_t number) {
  Object object;
  object.id = category + "-" + std::to_string(number);
  object.category = object.description = category;
  return object;
}

}  // namespace

MarkedScenes read_marked_scenes(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path);
  MarkedScenes scenes;
  const json document = json::parse(stream);
  for (const auto& [id, things] : document.items()) {
    Scene& scene = scenes[id];
    scene.room.polygon.points = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    for (const auto& category : things) scene.objects.push_back(thing_of(category, scene.objects.size()));
  }
  return scenes;
}

std::vector<MarkedEdit> read_marked_edits(const std::string& path, const MarkedScenes& scenes) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path);
  std::vector<MarkedEdit> all;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    try {
      if (auto edit = read_line(json::parse(line), scenes)) all.push_back(*std::move(edit));
    } catch (const std::exception& problem) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": " + problem.what());
    }
  }
  return all;
}

}  // namespace roomgen
