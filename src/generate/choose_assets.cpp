#include "choose_assets.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "consult.h"
#include "create/finish_look.h"
#include "design/asset_text.h"
#include "library/asset_object.h"
#include "make_things.h"
#include "offers.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double same_size = 0.02;

void show(const Workplace& place, BuildEvent::Kind kind, const std::string& text) {
  if (!place.options.on_event) return;
  BuildEvent event{kind, 0, planned_objects(place.plan).size()};
  event.text = text;
  place.options.on_event(event);
}

/// Writes choices into the plan; what is searched again waits for the next round, what the designer
/// makes for the end.
class Chooser {
 public:
  explicit Chooser(Workplace& place) : place_(place) {}

  // What other words shall be searched for, as the offers of a next round.
  std::vector<AssetOffer> take(ChoiceRound& round) {
    std::vector<AssetOffer> again;
    round.taken.resize(round.offers.size());
    for (const auto& choice : round.answer.choices) {
      const AssetOffer& offer = round.offers[choice.offer];
      std::string& taken = round.taken[choice.offer];
      if (choice.kind == AssetChoice::Kind::leave_out) leave_out(offer, choice.reason, round);
      if (choice.kind == AssetChoice::Kind::asset) taken = take_asset(offer, choice, round);
      if (choice.kind == AssetChoice::Kind::make) taken = make(offer, choice, round);
      if (choice.kind != AssetChoice::Kind::search) continue;
      if (auto other = searched_again(place_, offer, choice.words))
        again.push_back(*std::move(other));
      else
        tell(round, offer, "searching again failed: " + other.error().message);
    }
    return again;
  }

  // What was ordered, all at once. It has its colours by itself.
  void make_all() {
    if (offers_.empty()) return;
    show(place_, BuildEvent::Kind::making, "making " + std::to_string(offers_.size()) + " things");
    const auto made = make_things(place_, offers_);
    ChoiceRound told;
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (!made[i].fault.empty()) tell(told, offers_[i], made[i].fault);
      if (!made[i].asset) {
        tell(told, offers_[i], "rules make it");
        make_by_rules(offers_[i], choices_[i], told);
      } else {
        choices_[i].paint.clear();
        give(offers_[i], choices_[i], *made[i].asset, told);
      }
    }
    for (const auto& note : told.notes) {
      place_.plan.notes.push_back(note);
      if (!place_.choices.empty()) place_.choices.back().notes.push_back(note);
    }
  }

 private:
  static void tell(ChoiceRound& round, const AssetOffer& offer, const std::string& what) {
    round.notes.push_back(offer.id + ". " + what);
  }

  void leave_out(const AssetOffer& offer, const std::string& reason, ChoiceRound& round) {
    const std::string why =
        "the designer left it out: " + (reason.empty() ? "nothing offered would do" : reason);
    for (const std::size_t i : offer.items) place_.plan.items[i].left_out = why;
    tell(round, offer, place_.plan.items[offer.items.front()].category + ": " + why);
  }

  // What was made from words is made of any size.
  std::string take_asset(const AssetOffer& offer, const AssetChoice& choice, ChoiceRound& round) {
    AssetInfo asset = offer.assets[choice.asset].asset;
    PlanItem item = place_.plan.items[offer.items.front()];
    item.description = offer.words;
    if (asset.ref.procedural && choice.size)
      if (auto made = made_of(place_, item, *choice.size); made && *made) asset = **std::move(made);
    return give(offer, choice, std::move(asset), round);
  }

  std::string make(const AssetOffer& offer, const AssetChoice& choice, ChoiceRound& round) {
    AssetOffer wanted = offer;
    if (!choice.words.empty()) wanted.words = choice.words;
    wanted.size = choice.size.value_or(offer.size);
    if (!place_.designer.makes()) return make_by_rules(wanted, choice, round);
    if (!choice.paint.empty()) wanted.words += "; colours and materials: " + choice.paint;
    offers_.push_back(std::move(wanted));
    choices_.push_back(choice);
    return {};
  }

  std::string make_by_rules(const AssetOffer& offer, const AssetChoice& choice,
                            ChoiceRound& round) {
    const PlanItem& item = place_.plan.items[offer.items.front()];
    auto made = made_by_rules(place_, item, offer.words, offer.size);
    if (!made) tell(round, offer, made.error().message);
    if (made && *made) return give(offer, choice, **made, round);
    tell(round, offer, "\"" + offer.words + "\" cannot be made; the library decides");
    return {};
  }

  // The key of what the items are now.
  std::string give(const AssetOffer& offer, const AssetChoice& choice, AssetInfo asset,
                   ChoiceRound& round) {
    if (!choice.paint.empty()) paint(offer, choice.paint, asset, round);
    const PlanItem& item = place_.plan.items[offer.items.front()];
    const Vec3 wanted = choice.size.value_or(offer.size);
    const Vec3 size = fitted_size(asset, place_.categories.get(item.category).size, wanted);
    if (choice.size && !size.isApprox(wanted, same_size))
      tell(round, offer, "it is " + size_text(size) + " m, for it cannot be " + size_text(wanted));
    for (const std::size_t i : offer.items) {
      PlanItem& own = place_.plan.items[i];
      own.asset = asset_key(asset.ref);
      own.description = design::told_looks(asset);
      own.size = size;
    }
    const std::string key = asset_key(asset.ref);
    place_.chosen[key] = std::move(asset);
    return key;
  }

  void paint(const AssetOffer& offer, const std::string& words, AssetInfo& asset,
             ChoiceRound& round) {
    const auto before = asset.ref.finish;
    for (auto& [stuff, looks] : create::wanted_finish(words, asset.category))
      asset.ref.finish[stuff] = looks;
    const bool is_new = asset.ref.finish != before;
    auto painted = is_new ? place_.library.find(asset_key(asset.ref)) : Result<AssetInfo>(Error{});
    if (painted) return;
    asset.ref.finish = before;
    tell(round, offer, "\"" + words + "\" cannot be painted; it stays as it is");
  }

  Workplace& place_;
  std::vector<AssetOffer> offers_;  ///< what is to be made, with the words and the size
  std::vector<AssetChoice> choices_;
};

// Asks, and writes down what was said; false where that was the end.
bool ask(Workplace& place, ChoiceRound& round, bool again) {
  ChoiceRequest request{place.plan, round.offers, again};
  request.cancel = place.options.cancel;
  if (place.options.renderer) request.sheets = [&] { return sheets_of(place, round.offers); };
  std::size_t things = 0;
  for (const auto& offer : round.offers) things += static_cast<std::size_t>(offer.count);
  show(place, BuildEvent::Kind::choosing,
       "choosing: " + std::to_string(things) + " things, " + std::to_string(round.offers.size()) +
           " offers");
  auto answer = place.designer.choose(request);
  if (!account(answer, place)) return false;
  round.answer = *std::move(answer);
  return true;
}

}  // namespace

Status check_assets(Plan& plan, const AssetLibrary& library) {
  for (auto& item : plan.items) {
    if (item.asset.empty()) continue;
    const auto asset = library.find(item.asset);
    if (asset) continue;
    if (asset.error().kind != Error::Kind::not_found) return asset.error();
    plan.notes.push_back("no library has the asset \"" + shortened(item.asset, 100) + "\" of the " +
                         item.category + "; its words decide");
    item.asset.clear();
  }
  return {};
}

void choose_assets(Workplace& place) {
  if (!place.designer.chooses() || place.options.cancel.cancelled()) return;
  std::size_t surplus = 0;
  auto offers = offers_of(place, surplus);
  if (!offers)
    return place.plan.notes.push_back("no assets could be offered: " + offers.error().message);
  if (surplus > 0)
    place.plan.notes.push_back(std::to_string(surplus) +
                               " more things were not offered; the library decides");
  Chooser chooser(place);
  for (bool again : {false, true}) {
    if (offers->empty()) break;
    ChoiceRound round;
    round.offers = *std::move(offers);
    if (!ask(place, round, again)) break;
    offers = chooser.take(round);
    for (const auto& note : round.notes) place.plan.notes.push_back(note);
    place.choices.push_back(std::move(round));
  }
  chooser.make_all();
}

}  // namespace roomgen
