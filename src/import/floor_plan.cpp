#include "roomgen/import/import.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

using namespace std::string_view_literals;

// As UTF-8, without and with a byte order mark, and as UTF-16.
constexpr std::array xml_beginnings = {"<"sv, "\xEF\xBB\xBF<"sv, "\xFF\xFE<"sv, "\xFE\xFF\0<"sv};

bool has_ending(const std::filesystem::path& path, std::string_view ending) {
  return lower(path.extension().string()) == ending;
}

}  // namespace

Result<Room> read_floor_plan(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  const std::string_view start = trim(std::string_view(*text).substr(0, 1000));
  const bool svg = std::any_of(xml_beginnings.begin(), xml_beginnings.end(),
                               [&](std::string_view mark) { return start.starts_with(mark); });
  // A DXF begins with the number of a group, which is also a JSON document.
  const bool dxf = !svg && (has_ending(path, ".dxf") || start.starts_with("AutoCAD Binary DXF") ||
                            start.starts_with("0") || start.starts_with("999"));
  if (!svg && !dxf) return read_room_file(path);
  if (text->size() > max_drawing_bytes)
    return Error{Error::Kind::limit, path.string() + ": the drawing has more than " +
                                         std::to_string(max_drawing_bytes >> 20) +
                                         " MB; export the outline of the room alone"};
  return svg ? room_from_svg(*text, path.string()) : room_from_dxf(*text, path.string());
}

}  // namespace roomgen
