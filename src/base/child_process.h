#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "descriptor.h"
#include "roomgen/base/result.h"

namespace roomgen::detail {

/// A program that runs beside this one and is spoken to over a single channel, its standard input, in both
/// directions. It has no other file of ours, writes nowhere else, and knows of the environment only where the
/// loader finds libraries. Killed with its owner. (child_process_posix.cpp, child_process_windows.cpp)
class ChildProcess {
 public:
  static Result<ChildProcess> start(const std::filesystem::path& program);
  ChildProcess(ChildProcess&& other) noexcept
      : id_(std::exchange(other.id_, 0)), channel_(std::move(other.channel_)) {}
  ChildProcess& operator=(ChildProcess&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(channel_, other.channel_);
    return *this;
  }
  ~ChildProcess();

  /// How many bytes were taken within `patience`; none if the program reads no more.
  std::optional<std::size_t> send(std::string_view bytes, std::chrono::milliseconds patience) const;
  /// How many bytes came within `patience`, at most `size`; none if there is nobody who could send any.
  std::optional<std::size_t> receive(char* into, std::size_t size, std::chrono::milliseconds patience) const;

  /// What it has used so far.
  std::chrono::nanoseconds processor_time() const;

  /// At most so many bytes of addresses from now on, within what it allowed itself for good.
  void allow_memory(std::size_t bytes) const;

  /// Ends it, once `patience` is over; says how it ended by itself before ("signal 11 (Segmentation
  /// fault)"), empty if it did not.
  std::string end(std::chrono::milliseconds patience = {});

 private:
  ChildProcess(long id, Descriptor channel) : id_(id), channel_(std::move(channel)) {}

  long id_ = 0;  // 0: none
  Descriptor channel_;
};

}  // namespace roomgen::detail
