// Changes asked for by strangers, of a small room.
#include <nlohmann/json.hpp>

#include "bytes.h"
#include "roomgen/scene/scene.h"
#include "edit_reader/edit_words.h"

namespace {

roomgen::Scene small_room() {
  roomgen::Scene scene;
  scene.room.type = "bedroom";
  scene.room.polygon.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  int x = 0;
  for (const char* kind : {"bed", "desk", "chair", "chair", "floor lamp", "rug"}) {
    roomgen::Object object;
    object.category = kind;
    object.id = std::string(kind) + "-" + std::to_string(x);
    object.size = {0.6, 0.6, 0.6};
    object.position = {0.4 + 0.6 * x++, 1.0, 0.0};
    scene.objects.push_back(object);
  }
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const roomgen::Scene scene = small_room();
  const auto understood = roomgen::read_edit(FuzzedBytes{data, size}.text(), scene,
                                             roomgen::KindTable::built_in(), {});
  if (!understood) must(!understood.error().message.empty());
  return 0;
}
