#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/create/maker.h"
#include "roomgen/create/validate.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/object.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

struct CreateOptions {
  std::optional<Vec3> size;  ///< width, depth, height of the main object, whatever the words say
  std::uint64_t seed = 0;
  Variant variant = Variant::full;
  std::size_t triangles = shape::default_triangles;  ///< at most, where that can be reached
  CancelToken cancel;
};

/// An object that was made.
struct CreatedObject {
  Description description;
  Mount mount = Mount::floor;
  shape::Program program;  ///< the source of truth: everything else follows from it
  shape::Shape shape;
  Soundness soundness;     ///< of the program, after repairs
  bool fell_back = false;  ///< the maker's fallback made it: Maker::fell_back()
  std::vector<std::string> repairs;
  std::vector<std::string> notes;  ///< what was assumed or left out
};

struct Creation {
  Verdict verdict;                     ///< when it does not pass, there are no objects
  std::vector<CreatedObject> objects;  ///< the main one first
};

/// Classifier, decomposer, generator, validator, for each object that the prompt names. A prompt that
/// does not pass is no error: the verdict says why. Equal arguments give equal results.
Result<Creation> create(const std::string& prompt, Maker& maker, const CreateOptions& options = {});

/// One object whose description is known: generator and validator.
Result<CreatedObject> create_described(const Description& description, Maker& maker,
                                       const CreateOptions& options = {});

/// An earlier object's program changed as the wish says.
Result<CreatedObject> refine(const shape::Program& earlier, const std::string& wish, Maker& maker,
                             const CreateOptions& options = {});

}  // namespace roomgen::create
