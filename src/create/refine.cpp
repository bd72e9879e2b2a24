#include <algorithm>

#include "language/number.h"
#include "part_forms.h"
#include "parts.h"
#include "reshape.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/evaluate.h"
#include "rule_steps.h"
#include "shape/color.h"

namespace roomgen::create {

namespace {

constexpr double most_count = 1000;

/// One clause of the wish: what it is about and what shall become of it.
struct Clause {
  std::string label;  ///< empty: the whole
  Vec3 factors = Vec3::Ones();
  std::string material, color, shape;
  std::optional<int> count;
  std::optional<double> lean;
  std::optional<Course> course;
  Strength strength = Strength::moderate;
  bool remove = false, add = false;
};

class WishReader {
 public:
  WishReader(const std::string& wish, const shape::Program& program, const Words& words)
      : program_(program), words_(words), tokens_(language::tokenize(wish)) {
    for (const auto& token : tokens_) texts_.push_back(token.text);
  }

  std::vector<Clause> run() {
    while (at_ < texts_.size()) step_on();
    close();
    return std::move(clauses_);
  }

 private:
  void step_on() {
    const std::string& word = texts_[at_];
    if (word == "and" || word.empty() || word == "," || word == "then") {
      close();
      ++at_;
      return;
    }
    const auto is = [&](std::initializer_list<const char*> list) {
      return std::find(list.begin(), list.end(), word) != list.end();
    };
    if (is({"remove", "without", "drop", "delete"})) clause_.remove = said_ = true;
    else if (is({"add", "give"})) clause_.add = said_ = true;
    else if (const auto found = words_.comparatives.find(word); found != words_.comparatives.end())
      clause_.factors = clause_.factors.cwiseProduct(more_ < 1 ? found->second.cwiseInverse() : found->second), said_ = true;
    else if (is({"less"})) more_ = -1;
    else if (part()) return;
    else if (const auto shape = words_.shapes.find(word); shape != words_.shapes.end())
      clause_.shape = shape->second, said_ = true;
    else if (const auto course = words_.courses.find(word); course != words_.courses.end())
      clause_.course = course->second, said_ = true;
    else if (const auto lean = words_.leans.find(word); lean != words_.leans.end())
      clause_.lean = lean->second, said_ = true;
    else if (const auto material = words_.materials.find(word); material != words_.materials.end())
      clause_.material = word, said_ = true;
    else if (shape::parse_color(word)) clause_.color = word, said_ = true;
    else if (const auto strength = words_.strengths.find(word); strength != words_.strengths.end())
      clause_.strength = strength->second;
    else if (const auto number = language::number_at(tokens_, at_); number && number->value < most_count)
      clause_.count = static_cast<int>(number->value), said_ = true;
    ++at_;
  }

  bool part() {
    for (const std::size_t n : {std::size_t{2}, std::size_t{1}}) {
      if (at_ + n > texts_.size()) continue;
      const std::string phrase = n == 2 ? texts_[at_] + " " + texts_[at_ + 1] : texts_[at_];
      const auto& labels = built_in_parts()->labels;
      const auto found = labels.find(phrase);
      if (found == labels.end()) continue;
      if (!clause_.label.empty() && said_) close();
      clause_.label = meant(found->second);
      at_ += n;
      return true;
    }
    return false;
  }

  // Of several that a word may mean, the one that is there.
  std::string meant(const std::vector<std::string>& labels) const {
    for (const auto& label : labels)
      if (count_parts(program_, label) > 0) return label;
    return labels.front();
  }

  void close() {
    if (said_) clauses_.push_back(clause_);
    const bool goes_on = said_ && clause_.remove;
    clause_ = {};
    clause_.remove = goes_on;  // "remove the arms and the back"
    said_ = false;
    more_ = 1;
  }

  const shape::Program& program_;
  const Words& words_;
  std::vector<language::Token> tokens_;
  std::vector<std::string> texts_;
  std::size_t at_ = 0;
  std::vector<Clause> clauses_;
  Clause clause_;
  bool said_ = false;
  int more_ = 1;
};

void enlarge(shape::Program& program, const Vec3& factors) {
  shape::Group whole{std::move(program.components)};
  shape::Component component;
  component.name = "whole";
  component.scale = factors;
  component.solid = std::move(whole);
  for (auto& [a, b] : program.connections) {
    // Labels stay what they are; names are now inside the group.
    const auto inside = [&](std::string& reference) {
      for (const auto& one : std::get<shape::Group>(component.solid).components)
        if (reference == one.name || reference.rfind(one.name + ".", 0) == 0 ||
            reference.rfind(one.name + "-", 0) == 0) {
          reference = "whole." + reference;
          return;
        }
    };
    inside(a), inside(b);
  }
  program.components = {std::move(component)};
}

PartWish part_of(const Clause& clause) {
  PartWish wish;
  wish.label = clause.label;
  wish.count = clause.count;
  wish.shape = clause.shape;
  return wish;
}

}  // namespace

Refinement refine(const shape::Program& earlier, const std::string& wish, const Words& words) {
  Refinement result{earlier, {}};
  shape::Program& program = result.program;
  const auto clauses = WishReader(wish, earlier, words).run();
  if (clauses.empty())
    result.notes.push_back("nothing was changed: say what part shall become how, as in \"make the back taller\"");
  for (const auto& clause : clauses) {
    const std::string& label = clause.label;
    const int there = label.empty() ? 0 : count_parts(program, label);
    const std::string what = label.empty() ? "the whole" : label;
    if (clause.remove) {
      if (there == 0) result.notes.push_back("there is no " + what + " to remove");
      else set_count(program, label, 0);
      continue;
    }
    if (!label.empty() && there == 0) {
      if (!clause.add || !attach(program, {part_of(clause)}))
        result.notes.push_back("there is no part \"" + what + "\"");
      continue;
    }
    if (clause.count && !label.empty()) {
      const int wanted = clause.add ? there + *clause.count : *clause.count;
      if (!set_count(program, label, clause.add && *clause.count >= there ? *clause.count : wanted))
        result.notes.push_back("it is not known how to have " + std::to_string(wanted) + " of the part \"" + label + "\"");
    }
    if (clause.factors != Vec3::Ones()) {
      if (label.empty()) enlarge(program, clause.factors);
      else scale(program, label, clause.factors);
    }
    if (!clause.shape.empty() && !label.empty()) set_outline(program, label, clause.shape);
    if (clause.lean && !label.empty()) lean(program, label, *clause.lean);
    if (clause.course && !label.empty()) bend(program, label, *clause.course, clause.strength);
    if (!clause.material.empty() || !clause.color.empty()) {
      if (!label.empty()) {
        paint(program, label, clause.material, clause.color, words);
      } else {
        std::vector<std::string> all;
        for (const auto& surface : program.materials) all.push_back(surface.name);
        if (!all.empty()) paint_surfaces(program, {all.front()}, clause.material, clause.color, words);
      }
    }
  }
  prune_connections(program);
  return result;
}

}  // namespace roomgen::create
