#include "roomgen/create/create.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kinds.h"
#include "maker_replies.h"
#include "relative_size.h"
#include "roomgen/base/json.h"
#include "validate.h"

namespace roomgen::create {

namespace {

constexpr std::size_t examples_shown = 2;
constexpr double most_growth = 1.4;  // of the longest side, by repairs
// Sides that differ by more than this from what was asked are made again.
constexpr double aim_tolerance = 0.004;
constexpr int size_rounds = 3;
constexpr double most_excess = 1.3;
// Beyond the factor that fits all, what was written at another size is stretched at most by this.
constexpr double most_stretch = 1.25, unseen_factor = 0.004;
// Metres; beads and rivets that float by less look as if they touched.
constexpr double clear_gap = 0.012;

const ShapeKind* kind_of(const Description& description) {
  const auto& kinds = ShapeKinds::built_in();
  return kinds && !description.kind.empty() ? kinds->find(description.kind) : nullptr;
}

// Lengths to aim at: those that were said, and the kind's least and most where what came out is a
// little beyond them. What is far beyond has grown by parts that were asked for, and may.
Vec3 aim_of(const Description& description, const std::optional<Vec3>& said, const Vec3& size,
            const ShapeKind* kind) {
  Vec3 aim = said.value_or(Vec3::Constant(std::nan("")));
  const auto& parts = description.parts;
  if (!kind || std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.size.has_value(); }))
    return aim;
  for (int axis = 0; axis < 3; ++axis)
    if (aim[axis] < kind->least[axis] || aim[axis] > kind->most[axis]) return aim;
  // A round thing whose width was said is as deep.
  const bool outline_is_said = !std::isnan(aim.x()) || !std::isnan(aim.y());
  for (int axis = outline_is_said ? 2 : 0; axis < 3; ++axis) {
    const double nearest = std::clamp(size[axis], kind->least[axis], kind->most[axis]);
    const double excess = std::max(size[axis] / nearest, nearest / size[axis]);
    if (std::isnan(aim[axis]) && std::abs(size[axis] - nearest) > aim_tolerance && excess < most_excess)
      aim[axis] = nearest;
  }
  return aim;
}

Footing footing_of(Mount mount) {
  if (mount == Mount::wall) return Footing::wall;
  return mount == Mount::ceiling ? Footing::ceiling : Footing::ground;
}

// The nearest recipes, as they are unless told otherwise.
std::vector<shape::Program> nearest_examples(const Description& description) {
  std::vector<shape::Program> programs;
  const auto& kinds = ShapeKinds::built_in();
  if (!kinds) return programs;
  for (const ShapeKind* kind : kinds->nearest(description.noun, examples_shown)) {
    const Json* recipe = kinds->recipe(kind->recipe);
    if (!recipe) continue;
    auto parameters = shape::describe_parameters(*recipe);
    if (!parameters) continue;
    auto program = shape::instantiate(*recipe, shape::clamped(*parameters, kind->set), 0,
                                      kinds->recipes(), kind->recipe);
    if (program) programs.push_back(*std::move(program));
  }
  return programs;
}

bool grown(const shape::Program& before, const shape::Program& after) {
  const shape::EvaluateOptions& measuring = shape::for_measuring;
  const auto old_shape = shape::evaluate(before, measuring),
             new_shape = shape::evaluate(after, measuring);
  if (!old_shape || !new_shape || old_shape->bodies.empty()) return false;
  const Vec3 old_size = bounds(*old_shape).size(), new_size = bounds(*new_shape).size();
  return new_size.maxCoeff() > most_growth * old_size.maxCoeff();
}

Status draw(shape::Program program, const CreateOptions& options, CreatedObject& object) {
  auto shape = shape::evaluate_within(program, options.triangles);
  if (!shape) return shape.error();
  if (shape->bodies.empty())
    return Error{Error::Kind::invalid_input, "the program makes nothing at all"};
  object.program = std::move(program);
  object.shape = *std::move(shape);
  return {};
}

// As it is, judged by what is clearly apart and tips over: what labels would have touch is a guess.
Status finish_as_drawn(shape::Program program, const CreateOptions& options,
                       CreatedObject& object) {
  ValidateOptions measuring{footing_of(object.mount), clear_gap};
  measuring.as_drawn = true;
  auto soundness = inspect(program, measuring);
  if (!soundness) return soundness.error();
  object.soundness = *std::move(soundness);
  return draw(std::move(program), options, object);
}

// Validates and evaluates.
Status finish(shape::Program program, const CreateOptions& options, CreatedObject& object) {
  ValidateOptions validation;
  validation.footing = footing_of(object.mount);
  if (options.variant == Variant::no_validation) {
    auto soundness = inspect(program, validation);
    if (!soundness) return soundness.error();
    object.soundness = *std::move(soundness);
    return draw(std::move(program), options, object);
  }
  auto validated = validate(program, validation);
  if (!validated) return validated.error();
  // A repair that makes another thing of it is none.
  if (!validated->repairs.empty() && grown(program, validated->program)) {
    object.notes.push_back("what is loose could not be joined without making it much larger");
    validated->program = std::move(program);
    validated->repairs.clear();
    validated->after = validated->before;
  }
  object.repairs = std::move(validated->repairs);
  object.soundness = std::move(validated->after);
  return draw(std::move(validated->program), options, object);
}

Vec3 factors_to(const Vec3& wanted, const Vec3& size) {
  const Vec3 factors = wanted.cwiseQuotient(size.cwiseMax(1e-4));
  return factors.cwiseMin(most_stretch * factors.minCoeff());
}

// As one group. What its connections named is joined by now.
shape::Program scaled(shape::Program program, const Vec3& factors) {
  shape::Component whole;
  whole.name = "whole";
  whole.solid = shape::Group{std::move(program.components)};
  whole.scale = factors;
  program.components = {std::move(whole)};
  program.connections.clear();
  return program;
}

class Creator {
 public:
  Creator(Maker& maker, const CreateOptions& options) : maker_(maker), options_(options) {}

  Result<CreatedObject> make(Description description) {
    CreatedObject object;
    const ShapeKind* kind = kind_of(description);
    object.mount = kind ? kind->mount : Mount::floor;
    MakeRequest request;
    request.seed = options_.seed;
    if (maker_.wants_examples()) request.examples = nearest_examples(description);
    request.cancel = options_.cancel;
    const std::optional<Vec3> in_numbers = description.size, said = said_size(description, kind);
    description.size = said;
    if (options_.variant == Variant::direct) return directly(std::move(request), description);
    Vec3 last = Vec3::Zero();
    for (int round = 0; round < size_rounds; ++round) {
      request.description = description;
      auto program = maker_.generate(request);
      if (!program) return program.error();
      object.fell_back = maker_.fell_back();
      object.notes = maker_.take_notes();
      object.repairs.clear();
      if (auto status = finish(*std::move(program), options_, object); !status) return status.error();
      if (!maker_.is_cheap()) break;
      const Vec3 size = bounds(object.shape).size();
      // What another aim did not change will not change.
      if ((size - last).norm() < aim_tolerance || !correct_size(aim_of(description, said, size, kind), size, description))
        break;
      last = size;
    }
    object.description = std::move(request.description);
    object.description.size = in_numbers;
    return object;
  }

 private:
  // Triangles as they come: there is no program to validate or to keep.
  Result<CreatedObject> directly(MakeRequest request, const Description& description) {
    CreatedObject object;
    object.description = request.description = description;
    if (const ShapeKind* kind = kind_of(description)) object.mount = kind->mount;
    auto shape = maker_.generate_mesh(request);
    if (!shape) return shape.error();
    object.shape = *std::move(shape);
    object.fell_back = maker_.fell_back();
    object.program.name = description.noun;
    object.notes = maker_.take_notes();
    return object;
  }

  // What was added or repaired may have changed the box: the next round aims beside it. False if it
  // is as wanted.
  static bool correct_size(const Vec3& wanted, const Vec3& size, Description& description) {
    bool off = false;
    for (int axis = 0; axis < 3; ++axis) {
      const double error = wanted[axis] - size[axis];
      if (std::isnan(error) || std::abs(error) <= aim_tolerance) continue;
      off = true;
      if (!description.size) description.size = Vec3::Constant(std::nan(""));
      double& side = (*description.size)[axis];
      side = std::max(0.01, std::isnan(side) ? wanted[axis] : side + error);
    }
    return off;
  }

  Maker& maker_;
  const CreateOptions& options_;
};

}  // namespace

Result<Creation> create(const std::string& prompt, Maker& maker, const CreateOptions& options) {
  Creation creation;
  auto verdict = maker.classify(prompt);
  if (!verdict) return verdict.error();
  creation.verdict = *std::move(verdict);
  if (!creation.verdict.passes) return creation;
  std::vector<Description> descriptions;
  if (options.variant == Variant::no_decomposition) {
    Description whole;
    whole.prompt = prompt;
    whole.noun = prompt;
    descriptions = {whole};
  } else {
    auto read = maker.decompose(prompt);
    if (!read) return read.error();
    descriptions = *std::move(read);
  }
  auto early_notes = maker.take_notes();
  Creator creator(maker, options);
  for (auto& description : descriptions) {
    if (options.cancel.cancelled()) return Error{Error::Kind::cancelled, "cancelled"};
    if (creation.objects.empty() && options.size) description.size = options.size;
    auto object = creator.make(std::move(description));
    if (!object) return object.error();
    object->notes.insert(object->notes.begin(), early_notes.begin(), early_notes.end());
    early_notes.clear();
    creation.objects.push_back(*std::move(object));
  }
  return creation;
}

Result<CreatedObject> create_described(const Description& description, Maker& maker,
                                       const CreateOptions& options) {
  return Creator(maker, options).make(description);
}

Result<CreatedObject> refine(const shape::Program& earlier, const std::string& wish, Maker& maker,
                             const CreateOptions& options) {
  MakeRequest request;
  request.description.prompt = wish;
  request.description.noun = earlier.name;
  request.seed = options.seed;
  request.earlier = &earlier;
  request.cancel = options.cancel;
  auto program = maker.generate(request);
  if (!program) return program.error();
  CreatedObject object;
  object.description = request.description;
  if (const auto& kinds = ShapeKinds::built_in(); kinds)
    if (const ShapeKind* kind = kinds->find(earlier.name)) object.mount = kind->mount;
  object.fell_back = maker.fell_back();
  object.notes = maker.take_notes();
  if (auto status = finish(*std::move(program), options, object); !status) return status.error();
  return object;
}

Result<CreatedObject> create_written(const std::string& program, const Description& description,
                                     Mount mount, const CreateOptions& options) {
  auto reading = read_program_reply(program, description, options.seed);
  if (!reading) return reading.error();
  CreatedObject object;
  object.description = description;
  object.mount = mount;
  object.notes = std::move(reading->repairs);
  if (!reading->complaint.empty()) object.notes.push_back(std::move(reading->complaint));
  if (auto status = finish_as_drawn(std::move(reading->value), options, object); !status)
    return status.error();
  object.program.name = description.noun;
  object.program.about = description.prompt;
  if (!description.size) return object;
  const Vec3 factors = factors_to(*description.size, bounds(object.shape).size());
  if (factors.isApprox(Vec3::Ones(), unseen_factor)) return object;
  object.program = scaled(std::move(object.program), factors);
  if (auto status = draw(std::move(object.program), options, object); !status)
    return status.error();
  return object;
}

}  // namespace roomgen::create
