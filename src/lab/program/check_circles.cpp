#include <map>

#include "check_names.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;

class CircleSearch {
 public:
  CircleSearch(const ConstraintProgram& program, ProgramFindings& findings) : findings_(findings) {
    for (const auto& [name, set] : program.sets) sets_.emplace(name, &set);
  }

  void run() {
    for (const auto& [name, set] : sets_) visit(name);
  }

 private:
  enum class State { unknown, on_the_way, done };

  void visit(const std::string& name) {
    const auto found = sets_.find(name);
    if (found == sets_.end() || states_[name] == State::done) return;
    if (states_[name] == State::on_the_way) return report(name);
    states_[name] = State::on_the_way;
    way_.push_back(name);
    look_into(*found->second);
    way_.pop_back();
    states_[name] = State::done;
  }

  void look_into(const ProgramSet& set) {
    if (set.source == Source::named) visit(set.name);
    for (const auto& from : set.from) look_into(from);
    for (const auto& relation : set.relations)
      for (const auto& target : relation.target) look_into(target);
  }

  void report(const std::string& name) {
    std::vector<std::string> circle;
    for (auto it = way_.rbegin(); it != way_.rend(); ++it) {
      circle.insert(circle.begin(), *it);
      if (*it == name) break;
    }
    circle.push_back(name);
    findings_.error("/sets/" + name, "sets name each other in a circle: " + join(circle, ", "));
  }

  ProgramFindings& findings_;
  std::map<std::string, const ProgramSet*> sets_;
  std::map<std::string, State> states_;
  std::vector<std::string> way_;
};

}  // namespace

void check_circles(const ConstraintProgram& program, ProgramFindings& findings) {
  CircleSearch(program, findings).run();
}

}  // namespace roomgen::lab
