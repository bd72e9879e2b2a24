// What a designer would be offered for the rooms of some prompts, and how long that takes: seconds
// for the offers, for the sheets while their meshes are read from the libraries, and once more with
// all of them in memory.
//
//     bench_choice_sheets FOLDER [PROMPT ...]
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "roomgen/create/create.h"
#include "roomgen/generate/room_builder.h"
#include "roomgen/render/pictures.h"
#include "warm_library.h"

namespace {

using namespace roomgen;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Plans by rules, looks at what is offered, and takes the first of all.
class Onlooker final : public Designer {
 public:
  explicit Onlooker(std::filesystem::path stem) : stem_(std::move(stem)) {}

  Result<Plan> plan(const PlanRequest& request) override { return rules_->plan(request); }
  Result<PlaceAdvice> place(const PlaceRequest& request) override { return rules_->place(request); }
  bool chooses() const override { return true; }
  Result<AssetChoices> choose(const ChoiceRequest& request) override {
    std::vector<Image> pages;
    for (double* seconds : {&cold, &warm})
      *seconds = seconds_of([&] {
        auto drawn = request.sheets();
        if (drawn) pages = *std::move(drawn);
      });
    for (const auto& offer : request.offers) assets += offer.assets.size();
    offers = request.offers.size();
    for (std::size_t i = 0; i < pages.size(); ++i)
      (void)write_png(stem_.string() + "-" + std::to_string(i + 1) + ".png", pages[i]);
    return AssetChoices{};
  }

  double cold = 0.0, warm = 0.0;
  std::size_t offers = 0, assets = 0;

 private:
  std::filesystem::path stem_;
  std::unique_ptr<Designer> rules_ = make_rule_designer();
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::puts("bench_choice_sheets FOLDER [PROMPT ...]"), 2;
  std::vector<std::string> prompts(argv + 2, argv + argc);
  if (prompts.empty())
    prompts = {"a living room for a family of four", "a kitchen with an island",
               "a teenager's bedroom"};
  if (!make_folder(argv[1])) return 1;
  auto catalogue = assets::open_catalogue({});
  auto renderer = make_osmesa_renderer();
  if (!catalogue || !renderer) return std::puts("(no furniture, or nothing that draws)"), 1;
  const auto library =
      make_first_of({create::make_finishing_library(*std::move(catalogue)),
                     create::make_finishing_library(create::make_created_library())});
  for (const auto& prompt : prompts) {
    Onlooker designer(std::filesystem::path(argv[1]) / folder_name(prompt));
    PlanRequest request;
    request.prompt = prompt;
    BuildOptions options;
    options.renderer = renderer->get();
    const double all = seconds_of([&] {
      (void)RoomBuilder::begin(request, designer, *library, KindTable::built_in(), options);
    });
    std::printf("%s: %zu items, %zu assets; offers and plan %.2f s, sheets %.2f s, again %.2f s\n",
                prompt.c_str(), designer.offers, designer.assets,
                all - designer.cold - designer.warm, designer.cold, designer.warm);
  }
  return 0;
}
