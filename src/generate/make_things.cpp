#include "make_things.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "consult.h"
#include "create/maker_questions.h"
#include "design/asset_text.h"
#include "library/qualifiers.h"
#include "offers.h"
#include "roomgen/base/text.h"
#include "roomgen/create/create.h"

namespace roomgen {

namespace {

constexpr std::size_t rows_of_page = 4;
constexpr std::size_t longest_line = 110;  // bytes
constexpr double row_pixels = 420.0;

// By the words themselves, whatever the item is called.
PlanItem named_by(PlanItem item, const std::string& words) {
  const KindPhrase own = own_name("", words);
  const std::string head = own.known ? own.kind : qualify(words).head;
  if (!head.empty()) item.category = head;
  item.description = words;
  return item;
}

/// What a designer makes for one room, from the first answer to what becomes of it.
class Workshop {
 public:
  Workshop(Workplace& place, const std::vector<AssetOffer>& offers)
      : place_(place), request_{place.plan, {}, create::program_schema()}, made_(offers.size()) {
    for (const auto& offer : offers) request_.things.push_back({offer, "", {}});
    request_.cancel = place.options.cancel;
  }

  std::vector<MadeThing> run() {
    if (!ask()) return std::move(made_);
    request_.again = true;
    if (place_.options.renderer) request_.sheets = [&] { return sheets(); };
    const auto is_noted = [](const ThingToMake& thing) { return !thing.notes.empty(); };
    if (request_.sheets || std::any_of(request_.things.begin(), request_.things.end(), is_noted))
      ask();
    return std::move(made_);
  }

 private:
  // False where there was no answer.
  bool ask() {
    auto answer = place_.designer.make(request_);
    if (!account(answer, place_)) return false;
    ChoiceRound round;
    for (std::size_t i = 0; i < made_.size(); ++i) {
      const auto program = answer->programs.find(i);
      if (program != answer->programs.end())
        take(program->second, request_.things[i], made_[i]);
      else if (!request_.again)
        request_.things[i].notes = {made_[i].fault = "no program was written for it"};
      round.taken.push_back(made_[i].asset ? asset_key(made_[i].asset->ref) : "");
    }
    round.making = request_.things;
    round.answer.consultation = std::move(answer->consultation);
    place_.choices.push_back(std::move(round));
    return true;
  }

  // What was usable before stays until there is something better.
  void take(const std::string& program, ThingToMake& thing, MadeThing& made) const {
    thing.program = program;
    thing.notes.clear();
    auto asset = asset_of(thing, made.fault);
    if (asset)
      made.asset = *std::move(asset);
    else
      thing.notes = {made.fault = "the program cannot be used: " + asset.error().message +
                                  (made.asset ? "; the one before stays" : "")};
  }

  // The program is the asset.
  Result<AssetInfo> asset_of(ThingToMake& thing, std::string& fault) const {
    const AssetOffer& offer = thing.offer;
    const PlanItem& item = place_.plan.items[offer.items.front()];
    create::Description description;
    description.noun = item.category;
    description.prompt = offer.words;
    description.size = offer.size;
    create::CreateOptions options;
    options.seed = place_.options.seed;
    auto object = create::create_written(thing.program, description, item.mount, options);
    if (!object) return object.error();
    if (object->soundness.sound()) object->soundness.problems.clear();  // only of words
    fault = join(object->soundness.problems, ", ");
    for (const auto* told : {&object->notes, &object->repairs, &object->soundness.problems})
      thing.notes.insert(thing.notes.end(), told->begin(), told->end());
    AssetRef ref;
    ref.procedural = {"program", json_line(shape::write_program(object->program)), 0};
    auto asset = place_.library.find(asset_key(ref));
    if (asset) asset->mount = item.mount;
    return asset;
  }

  Result<std::vector<Image>> sheets() const {
    std::vector<ContactSheet::Row> rows;
    for (std::size_t i = 0; i < request_.things.size(); ++i) {
      if (!made_[i].asset) continue;
      const AssetOffer& offer = request_.things[i].offer;
      Object object;
      object.asset = made_[i].asset->ref;
      object.size = made_[i].asset->size;
      const std::string size = size_text(object.size);
      rows.push_back({shortened(design::offer_title(place_.plan, offer), longest_line),
                      {{object, offer.id, size}}});
      object.yaw = pi;
      rows.back().things.push_back({object, offer.id + " from behind", size});
    }
    return pages_of(place_, rows, rows_of_page, row_pixels);
  }

  Workplace& place_;
  MakingRequest request_;
  std::vector<MadeThing> made_;
};

}  // namespace

Result<std::optional<AssetInfo>> made_by_rules(const Workplace& place, const PlanItem& item,
                                               const std::string& words, const Vec3& size) {
  return made_of(place, named_by(item, words), size);
}

std::vector<MadeThing> make_things(Workplace& place, const std::vector<AssetOffer>& offers) {
  return Workshop(place, offers).run();
}

}  // namespace roomgen
