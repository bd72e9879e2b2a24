#include <algorithm>

#include "compose_steps.h"
#include "evaluate/attributes.h"
#include "evaluate/ledger.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/compose.h"
#include "roomgen/design/designer.h"

namespace roomgen::lab {

namespace {

constexpr std::size_t most_explained = 40;  // constraints, each of them a short search

/// Goes on from round to round.
class Composer {
 public:
  Composer(const ComposeRequest& request, const ProgramAuthor& author, const AssetLibrary& library,
           const KindTable& kinds, const ComposeOptions& options)
      : request_(request), author_(author), library_(library), kinds_(kinds), options_(options) {}

  Result<Composition> run() {
    if (auto status = refuse_dwelling(); !status) return status.error();
    auto written = author_.write(request_);
    if (!written) return written.error();
    ComposeRound first;
    first.written = *std::move(written);
    if (auto done = play(std::move(first)); !done) return done.error();
    while (static_cast<int>(composition_.rounds.size()) < options_.rounds && !last().report.is_met() &&
           !options_.optimise.cancel.cancelled()) {
      auto next = author_.revise(composition_.rounds);
      if (!next) {
        if (next.error().kind == Error::Kind::cancelled) break;
        composition_.notes.push_back("no further round: " + next.error().message);
        break;
      }
      if (!*next) break;
      ComposeRound round;
      round.written = std::move((*next)->written);
      round.reason = std::move((*next)->reason);
      round.patch = std::move((*next)->patch);
      round.rule = (*next)->rule;
      if (auto done = play(std::move(round)); !done) {
        composition_.notes.push_back("a revision could not be used: " + done.error().message);
        break;
      }
    }
    composition_.best = best_of(composition_.rounds);
    return std::move(composition_);
  }

 private:
  Status refuse_dwelling() const {
    const auto dwelling = plan_dwelling(request_.plan, *make_rule_designer());
    if (!dwelling || !*dwelling) return {};
    std::vector<std::string> rooms;
    for (const auto& plan : (*dwelling)->rooms) rooms.push_back(plan.room.type);
    return Error{Error::Kind::invalid_input, "a program furnishes one room, and the prompt asks for " +
                                                 std::to_string(rooms.size()) + " (" + join(rooms, ", ") +
                                                 "); generate makes dwellings, or say one room at a time"};
  }

  const ComposeRound& last() const { return composition_.rounds.back(); }

  Status play(ComposeRound round) {
    if (auto loaded = load(round.written.stock); !loaded) return loaded.error();
    auto result = optimise(round.written.program, round.written.plan.room, stock_, kinds_, options_.optimise);
    if (!result) return result.error();
    round.result = *std::move(result);
    for (const auto& kind : stock_.missing)
      round.written.notes.push_back("the libraries have no " + kind);
    round.models = stock_.models;
    round.report = error_report(round.result, round.written.asked, round.models, kinds_);
    keep_ledger(round);
    look_for_conflict(round);
    if (options_.picture)
      if (auto picture = options_.picture(round.result.scene, round.models)) round.picture = *std::move(picture);
    composition_.rounds.push_back(std::move(round));
    if (options_.on_round) options_.on_round(last());
    return {};
  }

  void look_for_conflict(ComposeRound& round) const {
    const bool is_worth_it = author_.wants_conflict && !round.report.unmet.empty() &&
                             round.written.program.constraints.size() <= most_explained;
    if (!is_worth_it || options_.optimise.cancel.cancelled()) return;
    auto names = conflict(round.written.program, round.written.plan.room, stock_, kinds_, options_.optimise);
    if (names) round.report.conflict = *std::move(names);
  }

  // Most revisions want the meshes that are there.
  Status load(const std::vector<StockWish>& wishes) {
    if (wishes_ == wishes) return {};
    auto stock = load_stock(wishes, library_, kinds_, options_.assets_each);
    if (!stock) return stock.error();
    stock_ = *std::move(stock);
    wishes_ = wishes;
    return {};
  }

  // Every clause of the prompt, met or not, and what its words were taken for.
  void keep_ledger(ComposeRound& round) const {
    Scene& scene = round.result.scene;
    scene.requirements = check_requirements(
        round.written.plan.requirements, scene, kinds_,
        [&](const Object& object, const std::string& word) {
          return judge_attribute(known_looks(object, round.models), word);
        },
        [](const Object&) { return 1.0; });
    scene.heard = round.written.plan.heard;
    compose::hear_measures(scene, request_.plan.prompt, round.report.measures);
  }

  const ComposeRequest& request_;
  const ProgramAuthor& author_;
  const AssetLibrary& library_;
  const KindTable& kinds_;
  const ComposeOptions& options_;
  std::optional<std::vector<StockWish>> wishes_;  ///< for which the stock was loaded
  Stock stock_;
  Composition composition_;
};

}  // namespace

// What is asked for comes before what is liked.
std::size_t best_of(std::span<const ComposeRound> rounds) {
  constexpr double same = 1e-9;
  std::size_t best = 0;
  for (std::size_t i = 1; i < rounds.size(); ++i)
    if (rounds[i].report.missed_in_all() < rounds[best].report.missed_in_all() - same) best = i;
  return best;
}

ProgramAuthor rule_author() {
  return {"rules", [](const ComposeRequest& request) { return write_program(request); },
          [](const std::vector<ComposeRound>& rounds) -> Result<std::optional<Revision>> {
            return revise(rounds.back().written, rounds.back().report, rounds.back().rule);
          }};
}

Result<Composition> compose_room(const ComposeRequest& request, const ProgramAuthor& author,
                                 const AssetLibrary& library, const KindTable& kinds, const ComposeOptions& options) {
  return Composer(request, author, library, kinds, options).run();
}

}  // namespace roomgen::lab
