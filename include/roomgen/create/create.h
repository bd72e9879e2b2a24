#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/create/maker.h"
#include "roomgen/geometry/model.h"
#include "roomgen/library/library.h"
#include "roomgen/scene/object.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

struct CreateOptions {
  std::optional<Vec3> size;  ///< width, depth, height of the main object, whatever the words say
  std::uint64_t seed = 0;
  Variant variant = Variant::full;
  std::size_t triangles = shape::default_triangles;  ///< at most, where that can be reached
  CancelToken cancel;
};

/// What holds of a shape, measured on its meshes.
struct Soundness {
  int bodies = 0;
  int pieces = 0;            ///< connected groups of bodies (touching within 2 mm)
  bool grounded = false;     ///< the lowest point is at z = 0 within 1 mm
  bool stable = false;       ///< the centre of mass is over the hull of what touches the ground
  double stability = 0.0;    ///< metres from the centre of mass to the hull's edge; negative outside
  bool supported = false;    ///< everything rests on something below it or is fixed to what does
  bool congruent = false;    ///< copies of a part have one size
  std::vector<std::string> open_connections;  ///< "leg-2 and seat: 14 mm apart"
  std::vector<std::string> problems;          ///< all that is wrong, for people

  bool sound() const { return pieces == 1 && grounded && stable; }
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

/// An object whose program somebody wrote (docs/shapes.md): read, its spelling mended where it is
/// clear what is meant, drawn as it is, and scaled to the description's size as far as that shows
/// on nothing. No part is moved; soundness says what is clearly apart from the rest (12 mm) or tips
/// over. It bears the description's noun, and its words as `about`. An error has the JSON pointer;
/// notes say what is not as it was described.
Result<CreatedObject> create_written(const std::string& program, const Description& description,
                                     Mount mount, const CreateOptions& options = {});

/// An earlier object's program changed as the wish says.
Result<CreatedObject> refine(const shape::Program& earlier, const std::string& wish, Maker& maker,
                             const CreateOptions& options = {});

/// A library that has nothing in stock and builds what is asked for from words, by rules: for every
/// kind that a recipe makes (docs/objects.md) one match of low score, in the wanted size as far as
/// people would believe it, in the colours and materials that the description names. A thing of
/// another kind that somebody asked for (AssetQuery::asked) is put together from its words, if they
/// say enough, and marked approximate; else it is a plain stand-in of its size (docs/kinds.md),
/// marked so; of what is no thing there is nothing.
///
/// AssetRef::procedural carries all that is needed to build it again: recipe "words", the params
/// kind, description, size in metres, approximate and stand_in, and the seed, which follows from
/// the words; or recipe "program", whose params are a concrete shape program: what a Maker made.
///
/// What was built is kept in memory; for use by several threads at once.
std::unique_ptr<AssetLibrary> make_created_library();

/// Another library whose things get the looks that are asked for: where the words of a query
/// (AssetQuery::description) name colours, substances, patterns or a gloss that an asset is not known to
/// have, it is offered with an AssetRef::finish, and no longer contradicts the query by them. load()
/// paints the parts of its mesh anew (docs/finishes.md). Glass is never made of what is none.
///
/// Looks are given to what somebody asked for and to what is added to it alike, so that a room's things go
/// together as they are described. What was painted is kept in memory; for use by several threads at once.
std::unique_ptr<AssetLibrary> make_finishing_library(std::shared_ptr<const AssetLibrary> library);

/// The programs of objects that were made and kept: a folder of JSON files, whose "name" says what
/// they are; a query finds those that it calls by their whole name. Licence CC0. A folder that is
/// not there is empty; files that are no programs are left out.
std::unique_ptr<AssetLibrary> make_kept_library(const std::filesystem::path& folder);
/// Keeps a program in the folder, under a name of its own ("bar-stool-3f2a91.json"), which is
/// returned. The folder is made if need be.
Result<std::string> keep_program(const shape::Program& program, const std::filesystem::path& folder);

}  // namespace roomgen::create
