// Times the pictures of a furnished room: the first one, and marks images as the step loop asks for them.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "roomgen/assets/catalogue.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/render/pictures.h"

namespace {

using namespace roomgen;

double milliseconds(Renderer& renderer, const Scene& scene, const ModelTable& models,
                    const View& view) {
  const auto start = std::chrono::steady_clock::now();
  const auto image = renderer.render(scene, models, view);
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  return image ? elapsed.count() : -1.0;
}

}  // namespace

int main() {
  auto library = assets::open_catalogue({});
  auto renderer = make_osmesa_renderer();
  auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = "a large living room";
  request.seed = 3;  // 15 objects or more
  auto plan = designer->plan(request);
  if (!library || !renderer || !plan) return std::puts("(no furniture or no OSMesa)"), 0;
  auto room = generate(*plan, *designer, **library, KindTable::built_in());
  if (!room) return 1;

  View marks;
  marks.marks = true;
  const double first = milliseconds(**renderer, room->scene, room->models, marks);
  // As in the step loop: one object more each time.
  Scene partial = room->scene;
  std::vector<double> steps;
  for (std::size_t count = 0; count <= room->scene.objects.size(); ++count) {
    partial.objects.assign(room->scene.objects.begin(),
                           room->scene.objects.begin() + static_cast<std::ptrdiff_t>(count));
    steps.push_back(milliseconds(**renderer, partial, room->models, marks));
  }
  std::vector<double> again;
  for (int i = 0; i < 9; ++i)
    again.push_back(milliseconds(**renderer, room->scene, room->models, marks));
  std::sort(again.begin(), again.end());
  std::sort(steps.begin(), steps.end());
  std::printf("| marks image, %zu objects, 1024 px | ms |\n|---|---|\n", room->scene.objects.size());
  std::printf("| the first | %.0f |\n| the same room again | %.0f |\n", first, again[again.size() / 2]);
  std::printf("| step by step, one object more each time: median | %.0f |\n| worst | %.0f |\n",
              steps[steps.size() / 2], steps.back());
}
