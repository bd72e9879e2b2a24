#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "roomgen/base/json.h"

namespace roomgen::detail {

/// Builds a value from the events of nlohmann's parser in a time that grows with the text: its own way looks
/// through all earlier keys of an object for each new one. Of a key that comes twice the last value counts, as there.
class JsonBuilder : public nlohmann::json_sax<Json> {
 public:
  enum class Fault { none, syntax, range, too_many };

  /// Of a whole document, containers included: 64 MB of "[[],[],…]" would take more than 2 GB.
  static constexpr std::size_t most_values = 4'000'000;

  Fault fault() const { return fault_; }
  std::size_t fault_byte() const { return fault_byte_; }
  Json take() { return std::move(values_.back().second); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& text) override;
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& value) override { return add(std::move(value)); }
  bool start_object(std::size_t size) override;
  bool key(string_t& name) override;
  bool end_object() override;
  bool start_array(std::size_t size) override;
  bool end_array() override;
  bool parse_error(std::size_t byte, const std::string& token, const nlohmann::detail::exception& error) override;

 private:
  bool add(Json value);
  /// Ends the innermost container; where its values begin.
  std::size_t close();

  // What is not yet part of a closed container, and where each open one begins in it.
  std::vector<std::pair<std::string, Json>> values_;
  std::vector<std::size_t> opened_;
  std::string key_;
  std::vector<std::string> outer_keys_;
  std::size_t count_ = 0;
  Fault fault_ = Fault::none;
  std::size_t fault_byte_ = 0;
};

}  // namespace roomgen::detail
