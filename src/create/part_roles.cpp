#include "part_roles.h"

#include <algorithm>

#include "roomgen/base/text.h"

namespace roomgen::create::detail {

namespace {

using Words = std::vector<std::string_view>;

std::string last_word(const std::string& label) {
  const auto all = words(label);
  if (all.empty()) return "";
  const std::string word = singular(all.back());
  return word == "feet" ? "foot" : word;
}

bool has(const Words& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

const Words feet = {"leg",     "foot",  "wheel", "castor", "caster",
                    "hairpin", "glide", "sled",  "runner", "rocker"};
const Words bases = {"base", "pedestal", "plinth", "stand", "trestle"};
const Words seats = {"seat", "frame", "body", "base", "platform", "box"};
const Words bodies = {"body", "frame", "carcass", "case", "cabinet", "side", "panel", "box", "top"};

struct Relation {
  Words parts, neighbours;
};

const std::vector<Relation>& relations() {
  static const std::vector<Relation> all = {
      {{"wheel", "castor", "caster", "glide"}, {"leg", "foot", "base", "spoke", "arm", "body"}},
      {{"leg", "foot", "hairpin", "trestle", "sled", "runner", "rocker", "base", "pedestal",
        "plinth", "stand", "column"},
       {"seat", "top", "tabletop", "desktop", "worktop", "apron", "frame", "body", "platform",
        "carcass", "case", "cabinet", "rail", "pole", "leg", "box", "shelf"}},
      {{"seat", "top", "tabletop", "desktop", "worktop", "platform"},
       {"leg", "apron", "frame", "pedestal", "column", "base", "trestle", "body", "carcass", "side",
        "drawer", "rail", "foot"}},
      {{"back", "backrest", "headboard", "footboard", "armrest", "arm"}, seats},
      {{"drawer", "door", "shelf", "divider", "hinge"}, bodies},
      {{"handle", "knob", "pull", "escutcheon"}, {"drawer", "door", "lid", "body"}},
      {{"shade", "lampshade", "diffuser"}, {"pole", "stem", "arm", "support", "socket", "stand"}},
      {{"bulb", "socket"}, {"socket", "shade", "pole", "stem", "arm"}},
      {{"pole", "stem"}, {"base", "stand", "pot", "soil"}},
      {{"cushion", "pillow", "mattress", "pad", "upholstery"}, {"seat", "frame", "base", "back"}},
      {{"rung", "stretcher", "crossbar", "footrest", "rail", "apron"}, {"leg", "post", "side"}},
      {{"post", "spindle", "slat", "baluster"}, {"seat", "rail", "frame", "back"}},
      {{"book", "ornament"}, {"shelf", "book", "top"}},
      {{"leaf", "flower", "branch"}, {"stem", "trunk", "branch", "soil", "pot"}},
  };
  return all;
}

}  // namespace

std::vector<std::string_view> usual_neighbours(const std::string& label) {
  const std::string word = last_word(label);
  for (const auto& relation : relations())
    if (has(relation.parts, word)) return relation.neighbours;
  return {};
}

bool is_one_of(const std::string& label, const std::vector<std::string_view>& list) {
  return has(list, last_word(label));
}

bool is_foot(const std::string& label) {
  return has(feet, last_word(label));
}

bool is_base(const std::string& label) {
  return has(bases, last_word(label));
}

bool is_decorative(const std::string& label) {
  static const Words decorative = {"handle", "knob",  "pull",     "cushion", "pillow", "book",
                                   "bulb",   "leaf",  "flower",   "trim",    "button", "piping",
                                   "glide",  "shade", "ornament", "footrest"};
  return has(decorative, last_word(label));
}

}  // namespace roomgen::create::detail
