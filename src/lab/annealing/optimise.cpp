#include "roomgen/lab/optimise.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "anneal.h"
#include "base/threads.h"
#include "bounds.h"
#include "compiled.h"
#include "evaluator.h"
#include "moves.h"
#include "solve/fit_rugs.h"
#include "to_scene.h"

namespace roomgen::lab {

namespace {

using namespace annealing;

/// What all chains share.
struct Task {
  const ConstraintProgram& program;
  const Room& room;
  const Stock& stock;
  const KindTable& kinds;
  const OptimiseOptions& options;
  std::vector<const Kind*> kind_numbers;
  std::vector<Article> articles;
  std::vector<std::vector<int>> articles_of_kind;
  Compiled compiled;
  std::vector<Bound> bounds;
};

void number_articles(Task& task) {
  for (const auto& [name, objects] : task.stock.articles) {
    const Kind* kind = task.kinds.by_name(name);
    if (!kind || objects.empty()) continue;
    const int number = static_cast<int>(task.kind_numbers.size());
    task.kind_numbers.push_back(kind);
    task.articles_of_kind.emplace_back();
    for (const auto& object : objects) {
      task.articles_of_kind.back().push_back(static_cast<int>(task.articles.size()));
      task.articles.push_back({object, kind, number, seats_on(ProgramVocabulary::built_in(), *kind, object.size.x())});
    }
  }
}

Status check_task(const Task& task) {
  for (const auto& finding : check(task.program, task.kinds))
    if (finding.severity == ProgramFinding::Severity::error)
      return Error{Error::Kind::invalid_input,
                   (task.program.source.empty() ? "the program" : task.program.source) +
                       (finding.at.empty() ? "" : ": " + finding.at) + ": " + finding.message};
  if (auto sound = check(task.room); !sound) return sound.error();
  double least = 0.0;
  for (const auto& bound : task.bounds) least = std::max(least, bound.low);
  if (least > most_things)
    return Error{Error::Kind::limit, "the program asks for " + std::to_string(static_cast<long long>(least)) +
                                         " things; a room may hold " + std::to_string(most_things)};
  return {};
}

/// Runs one chain in a world of its own.
AnnealResult run_chain(const Task& task, int chain, std::mutex& telling) {
  Random random = Random(task.options.seed).fork("chain " + std::to_string(chain));
  World world(task.room, task.kinds, task.articles, task.stock.models, task.compiled.language.relations);
  Evaluator evaluator(task.compiled, world);
  Moves moves(world, evaluator, task.bounds, task.articles_of_kind, task.compiled.language, random);
  AnnealOptions options;
  options.steps = task.options.steps;
  options.cluster_moves = task.options.cluster_moves;
  options.object_moves = task.options.object_moves;
  options.cancel = task.options.cancel;
  if (task.options.on_progress)
    options.on_progress = [&, chain](int step, const Worth& best, std::size_t things) {
      const std::lock_guard lock(telling);
      task.options.on_progress({chain, step, best.violation, best.loss, static_cast<int>(things)});
    };
  return anneal(world, evaluator, moves, random, options);
}

std::vector<AnnealResult> run_chains(const Task& task) {
  const int chains = std::max(1, task.options.chains);
  std::vector<AnnealResult> results(static_cast<std::size_t>(chains));
  std::atomic<int> next{0};
  std::mutex telling;
  const auto work = [&](std::size_t) {
    for (int chain = next++; chain < chains; chain = next++)
      results[static_cast<std::size_t>(chain)] = run_chain(task, chain, telling);
  };
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = std::min(chains, task.options.threads > 0 ? task.options.threads : cores);
  on_threads(static_cast<std::size_t>(threads), work);
  return results;
}

bool is_better(const Worth& a, const Worth& b) {
  return a.violation != b.violation ? a.violation < b.violation : a.loss < b.loss;
}

void restore(World& world, const std::vector<Placed>& things) {
  for (const auto& placed : things) world.add_at(placed.slot, placed.article, placed.stance, -1);
}

void collect_sets(const TermNode& node, std::vector<int>& sets) {
  sets.insert(sets.end(), node.sets.begin(), node.sets.end());
  for (const auto& operand : node.operands) collect_sets(operand, sets);
}

ConstraintVerdict verdict_on(const annealing::NamedTerm& constraint, const Task& task, Evaluator& evaluator,
                             const std::map<Slot, std::string>& ids) {
  ConstraintVerdict verdict;
  verdict.name = constraint.name;
  verdict.text = constraint.text;
  verdict.amount = evaluator.violation(constraint.term);
  verdict.held = verdict.amount <= 1e-9;
  std::vector<int> sets;
  collect_sets(constraint.term, sets);
  SlotSet members;
  for (const int set : sets)
    if (task.compiled.sets[static_cast<std::size_t>(set)].is_closed) members |= evaluator.members(set);
  for (const auto& [slot, id] : ids)
    if (members.has(slot)) verdict.objects.push_back(id);
  return verdict;
}

void add_figures(const std::vector<AnnealResult>& chains, std::size_t won, Optimisation& result) {
  for (const auto& chain : chains) {
    for (std::size_t i = 0; i < move_kinds; ++i) {
      result.tried_by_kind[i] += chain.tried[i];
      result.accepted_by_kind[i] += chain.accepted[i];
      result.moves += chain.tried[i];
      result.accepted += chain.accepted[i];
    }
    result.scene.incomplete = result.scene.incomplete || chain.is_cut;
  }
  for (const auto& point : chains[won].curve)
    result.curve.push_back({point.step, point.worth.violation, point.worth.loss});
}

// Rugs are cut and moved so that things stand on them with all their feet or none.
void lay_rugs(const Task& task, Scene& scene) {
  std::vector<RugWish> wishes;
  for (const auto& object : scene.objects)
    if (object.traits.flat) wishes.push_back({object.id, true, false, 0});
  fit_rugs(scene.room, scene.objects, task.stock.models, task.kinds, wishes);
}

}  // namespace

const std::array<std::string, 11>& optimise_move_names() {
  static const auto names = [] {
    std::array<std::string, 11> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = annealing::name(static_cast<MoveKind>(i));
    return all;
  }();
  return names;
}

std::vector<std::string> kinds_to_stock(const ConstraintProgram& program, const KindTable& kinds, std::uint64_t seed) {
  std::vector<std::string> names;
  for (const Kind* kind : kinds_of_bounds(program, kinds, ProgramVocabulary::built_in(), Random(seed).fork("stock")))
    names.push_back(kind->name);
  std::ranges::sort(names);
  return names;
}

Result<Optimisation> optimise(const ConstraintProgram& program, const Room& room, const Stock& stock,
                              const KindTable& kinds, const OptimiseOptions& options) {
  Task task{program, room, stock, kinds, options, {}, {}, {}, {}, {}};
  number_articles(task);
  const auto& vocabulary = ProgramVocabulary::built_in();
  if (auto sound = check_task(task); !sound) return sound.error();
  Compiler compiler(program, task.kind_numbers, kinds, vocabulary, Random(options.seed).fork("parameters"));
  compiler.compile();
  task.bounds = make_bounds(program, compiler, compiler.compiled(), task.kind_numbers, kinds, vocabulary);
  task.compiled = compiler.take();

  const auto chains = run_chains(task);
  std::size_t won = 0;
  for (std::size_t i = 1; i < chains.size(); ++i)
    if (is_better(chains[i].worth, chains[won].worth)) won = i;

  World world(room, kinds, task.articles, stock.models, task.compiled.language.relations);
  restore(world, chains[won].best);
  Evaluator evaluator(task.compiled, world);
  Optimisation result;
  auto [scene, ids] = to_scene(world, kinds);
  for (const auto& constraint : task.compiled.constraints)
    result.constraints.push_back(verdict_on(constraint, task, evaluator, ids));
  for (const auto& verdict : result.constraints) scene.program.push_back({verdict.name, verdict.held, verdict.amount});
  for (const auto& score : task.compiled.scores) {
    const double value = evaluator.value(score.term);
    result.scores[score.name] = value == value ? value : 0.0;
  }
  result.violation = evaluator.worth().violation;
  result.loss = evaluator.worth().loss;
  result.occupancy = evaluator.occupancy();
  result.scene = std::move(scene);
  result.scene.seed = options.seed;
  result.scene.prompt = program.prompt;
  lay_rugs(task, result.scene);
  add_figures(chains, won, result);
  return result;
}

}  // namespace roomgen::lab
