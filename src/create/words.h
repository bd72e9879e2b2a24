#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"

namespace roomgen {
class JsonReader;
}

namespace roomgen::create {

template <typename T>
using WordMap = std::map<std::string, T, std::less<>>;

using WordSet = std::set<std::string, std::less<>>;

/// What says where the part before it or the part after it is.
struct Placement {
  std::vector<std::string> words;
  std::optional<Place> before, after;
  bool below = false;  ///< the part after it is under what was named before
  bool gone = false;   ///< the part after it is not there
  int each = 1;        ///< so many times as many as were said
  Series series;       ///< of the part before it

  bool opens() const { return after || below || gone; }
};

/// The words of data/create/words.json.
struct Words {
  WordMap<std::string> shapes, constructions, styles;
  WordMap<double> leans;
  WordMap<Course> courses;
  WordMap<Strength> strengths;
  WordMap<Vec3> scales;
  WordMap<shape::Surface> materials;
  WordMap<Vec3> comparatives;  ///< "taller": factors against what it was
  WordSet directions, far_things, beings, no_objects;
  WordSet owners;       ///< "with", "has": what joins parts to their thing
  WordSet purposes;     ///< "for": behind them stands what the thing is for
  WordSet comparisons;  ///< "than": what is compared with is not there
  WordSet absences;     ///< "missing", "leave out": what is not there
  WordSet fillers;      ///< nouns that say nothing by themselves: "set"
  WordSet orders;      ///< verbs with which no description begins
  WordSet rooms, distances;
  /// "around it": how what was named before stands to the first thing; the longest of several first.
  std::vector<std::pair<std::vector<std::string>, std::string>> relations;
  std::vector<Placement> placements;                ///< the longest of several first
  WordSet makings;      ///< "sculpture": of what parts it is, is said
  WordSet likenesses;   ///< "model": of what stands in no room
  WordMap<Place> arrangements;                      ///< "a ring of stones"
  std::vector<std::vector<std::string>> similes;    ///< "shaped like": names no thing that is there
};

const Result<Words>& built_in_words();

/// How a substance looks, as data/create/words.json and data/finishes.json write it.
shape::Surface read_substance(const std::string& name, const JsonReader& json);

}  // namespace roomgen::create
