#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json_reader.h"
#include "numbers.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape::detail {

/// Reads the components of one document. With a scope it folds formulas, drops what `when` says and
/// writes out copies that differ; `use` makes a group of another recipe.
class ComponentReader {
 public:
  /// Null in concrete programs. Gets the whole component; reports its own problems.
  using Use = std::function<Group(const JsonReader& component, const Numbers& numbers)>;

  /// `materials`: what the document's names of materials are called in the program.
  ComponentReader(const Numbers& numbers, std::map<std::string, std::string> materials, Use use)
      : numbers_(numbers), materials_(std::move(materials)), use_(std::move(use)) {}

  std::vector<Component> read(const JsonReader& list);

  /// The program's name of a material; reports one that the document does not have.
  std::string material(const JsonReader& name) const;

 private:
  bool spend(const JsonReader& json);
  void bound_copies(const JsonReader& json, const std::vector<Component>& made) const;
  void read_into(std::vector<Component>& list, const JsonReader& json);
  void read_copied(std::vector<Component>& list, const JsonReader& json, std::size_t operation,
                   int count);
  void read_copies(std::vector<Component>& list, const JsonReader& json, std::size_t operation,
                   int count);
  std::optional<Component> read_one(const JsonReader& json,
                                    std::optional<std::size_t> left_out = std::nullopt);
  std::optional<Component> read_copy(const JsonReader& json, std::size_t operation, int index,
                                     int count);
  void allow_keys(const JsonReader& json) const;
  Solid solid(const JsonReader& json);
  std::string name(const JsonReader& json) const;

  Numbers numbers_;
  std::map<std::string, std::string> materials_;
  Use use_;
};

/// The turn of copy `index` of `count`.
double copy_angle(const Radial& radial, int index, int count);

}  // namespace roomgen::shape::detail
