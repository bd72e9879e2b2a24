#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace roomgen::lab::annealing {

/// Counts the poses that things have had. No two poses, of whatever things, share a version.
using Version = std::uint32_t;

/// Remembers what was found about two things for as long as both are as they were: a table with one place for each
/// pair of versions that may be overwritten by another. A move that is taken back gives the old versions back, so that
/// little is forgotten by trying.
template <typename T>
class PairMemo {
 public:
  PairMemo() : entries_(least_size) {}

  /// Makes room for the pairs of so many things.
  void fit(int things) {
    const std::size_t wanted = 8 * static_cast<std::size_t>(things) * static_cast<std::size_t>(things);
    if (entries_.size() >= wanted || entries_.size() >= greatest_size) return;
    std::size_t size = entries_.size();
    while (size < wanted && size < greatest_size) size *= 2;
    entries_.assign(size, {});
  }

  template <typename Find>
  const T& get(Version a, Version b, Find&& find) {
    const std::size_t place = (a * std::size_t{0x9E3779B1} + b * std::size_t{0x85EBCA77}) >> 7;
    Entry& entry = entries_[place & (entries_.size() - 1)];
    if (entry.a != a || entry.b != b) entry = {a, b, find()};
    return entry.value;
  }

 private:
  static constexpr std::size_t least_size = 1 << 10, greatest_size = 1 << 20;
  struct Entry {
    Version a = 0, b = 0;  // nothing has version 0
    T value{};
  };
  std::vector<Entry> entries_;
};

}  // namespace roomgen::lab::annealing
