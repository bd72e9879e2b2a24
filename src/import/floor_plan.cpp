#include "roomgen/import/floor_plan.h"

#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

namespace {

bool has_ending(const std::filesystem::path& path, std::string_view ending) {
  return lower(path.extension().string()) == ending;
}

}  // namespace

Result<Room> read_floor_plan(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  const std::string_view start = trim(std::string_view(*text).substr(0, 1000));
  const bool svg = start.starts_with('<') || start.starts_with("\xEF\xBB\xBF<");
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
