#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/create/description.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// The agents that take part, for comparisons (papers: primitives, section 5.1).
enum class Variant {
  full,              ///< all steps
  no_validation,     ///< the same here; whoever validates leaves that out
  no_decomposition,  ///< the program straight from the words
  direct,            ///< triangles instead of a program
};

/// What the classifier says.
struct Verdict {
  bool passes = false;
  std::string reason;  ///< for people: what the thing is, or why it is none that stands in a room
};

/// What the generator makes a program of.
struct MakeRequest {
  Description description;
  std::uint64_t seed = 0;
  /// The nearest recipes' concrete programs, nearest first: examples for a language model.
  std::vector<shape::Program> examples = {};
  /// An earlier program that shall be changed as the description's prompt says; null: a new one.
  const shape::Program* earlier = nullptr;
  CancelToken cancel = {};
};

/// Turns words into shape programs: by knowledge and grammar, or by a language model. The validator
/// (create/validate.h) comes after it and is the same for all.
class Maker {
 public:
  virtual ~Maker() = default;

  /// Is it furniture or something that stands indoors?
  virtual Result<Verdict> classify(const std::string& prompt) = 0;
  /// The objects that a sentence names, each with its parts.
  virtual Result<std::vector<Description>> decompose(const std::string& prompt) = 0;
  /// Does generate() look at the examples? They take time to make.
  virtual bool wants_examples() const { return true; }
  /// May generate() be called again for the sake of millimetres?
  virtual bool is_cheap() const { return true; }
  /// A program; it need not be sound yet.
  virtual Result<shape::Program> generate(const MakeRequest& request) = 0;
  /// Variant::direct: triangles instead of a program, one body for each part, not always closed.
  virtual Result<shape::Shape> generate_mesh(const MakeRequest&) {
    return Error{Error::Kind::invalid_input, "only a language model makes triangles directly"};
  }
  /// Was the last program, or the last triangles, not what this maker is for, but its fallback's?
  virtual bool fell_back() const { return false; }
  /// What was assumed, repaired or left to rules since the last call of this function.
  virtual std::vector<std::string> take_notes() { return {}; }
};

}  // namespace roomgen::create
