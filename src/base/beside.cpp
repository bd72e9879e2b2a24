#include "beside.h"

#include <cstdint>
#include <cstdio>
#include <random>
#include <string>

namespace roomgen::detail {

namespace fs = std::filesystem;

namespace {

constexpr const char* ending = ".part";
constexpr std::size_t digits = 16;

std::string beginning(const fs::path& path) { return "." + path.filename().string() + "."; }

}  // namespace

fs::path name_beside(const fs::path& path) {
  std::random_device device;
  const auto number = (static_cast<std::uint64_t>(device()) << 32) | device();
  char text[digits + 1];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return path.parent_path() / (beginning(path) + text + ending);
}

bool is_beside(const fs::path& path, const fs::path& name) {
  const std::string text = name.filename().string(), start = beginning(path);
  return text.size() == start.size() + digits + std::string_view(ending).size() &&
         text.starts_with(start) && text.ends_with(ending);
}

bool is_beside_something(const fs::path& name) {
  const std::string text = name.filename().string();
  const std::size_t tail = 1 + digits + std::string_view(ending).size();
  if (text.size() <= tail + 1 || text.front() != '.' || !text.ends_with(ending)) return false;
  const std::string_view number = std::string_view(text).substr(text.size() - tail, 1 + digits);
  return number.front() == '.' && number.find_first_not_of("0123456789abcdef", 1) == std::string_view::npos;
}

}  // namespace roomgen::detail
