#include "make_things.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "consult.h"
#include "create/maker_questions.h"
#include "design/asset_text.h"
#include "library/qualifiers.h"
#include "offers.h"
#include "roomgen/base/text.h"
#include "written_thing.h"

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

constexpr int most_looks = 2;  // at what was written, the last only at what is wrong still

/// What a designer makes for one room, from the first answer to what becomes of it.
class Workshop {
 public:
  Workshop(Workplace& place, const std::vector<AssetOffer>& offers)
      : place_(place), request_{place.plan, {}, create::program_schema()}, made_(offers.size()) {
    for (const auto& offer : offers) things_.push_back({offer, "", {}});
    request_.cancel = place.options.cancel;
  }

  std::vector<MadeThing> run() {
    for (std::size_t i = 0; i < things_.size(); ++i) asked_.push_back(i);
    const std::vector<std::size_t> all = asked_;
    const auto is_noted = [&](std::size_t i) { return !things_[i].notes.empty(); };
    const auto is_sound = [&](std::size_t i) { return made_[i].fault.empty(); };
    auto written = ask();
    request_.again = true;
    if (place_.options.renderer) request_.sheets = [&] { return sheets(); };
    for (int look = 1; look <= most_looks && written; ++look) {
      // All are seen once; what was written anew and is not right is seen once more.
      asked_ = look == 1 ? all : *std::move(written);
      if (look > 1) std::erase_if(asked_, is_sound);
      const bool any = std::any_of(asked_.begin(), asked_.end(), is_noted);
      if (!any && (look > 1 || !request_.sheets)) break;
      written = ask();
    }
    return std::move(made_);
  }

 private:
  // Which were written; nothing where there was no answer.
  std::optional<std::vector<std::size_t>> ask() {
    request_.things.clear();
    for (const std::size_t i : asked_) request_.things.push_back(things_[i]);
    auto answer = place_.designer.make(request_);
    if (!account(answer, place_)) return std::nullopt;
    ChoiceRound round;
    std::vector<std::size_t> written;
    for (std::size_t k = 0; k < asked_.size(); ++k) {
      const std::size_t i = asked_[k];
      const auto program = answer->programs.find(k);
      if (program != answer->programs.end()) {
        take(program->second, things_[i], made_[i]);
        written.push_back(i);
      } else if (!request_.again) {
        things_[i].notes = {made_[i].fault = "no program was written for it"};
      }
      round.taken.push_back(made_[i].asset ? asset_key(made_[i].asset->ref) : "");
      round.making.push_back(things_[i]);
    }
    round.answer.consultation = std::move(answer->consultation);
    place_.choices.push_back(std::move(round));
    return written;
  }

  // What was usable before stays until there is something better.
  void take(const std::string& program, ThingToMake& thing, MadeThing& made) const {
    PlanItem item = place_.plan.items[thing.offer.items.front()];
    item.description = thing.offer.words;
    item.size = thing.offer.size;
    thing.program = program;
    auto written = written_thing(place_.library, program, item, place_.options.seed);
    if (written) {
      made = {std::move(written->asset), std::move(written->fault)};
      thing.notes = std::move(written->notes);
    } else {
      thing.notes = {made.fault = "the program cannot be used: " + written.error().message +
                                  (made.asset ? "; the one before stays" : "")};
    }
  }

  Result<std::vector<Image>> sheets() const {
    std::vector<ContactSheet::Row> rows;
    for (const std::size_t i : asked_) {
      if (!made_[i].asset) continue;
      const AssetOffer& offer = things_[i].offer;
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
  std::vector<ThingToMake> things_;
  std::vector<std::size_t> asked_;  ///< of the things, those of the request
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
