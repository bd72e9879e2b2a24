#include "inventory.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "brief/mention_shape.h"
#include "brief/table_size.h"
#include "printed.h"

namespace roomgen::plan {

namespace {

constexpr double fullest = 0.45;      ///< share of the floor beyond which nothing is added
constexpr double core_excess = 1.15;  ///< the core may take a little more than the usual share
constexpr int max_added = 12;         ///< of one kind, unless the kind of room says more
constexpr double widest = 0.75;       ///< of the room's longer side that one thing may take

/// The state of a completion.
class Completion {
 public:
  Completion(std::vector<Draft>& drafts, const brief::Brief& brief, const brief::RoomKinds& kinds,
             const brief::RoomKind& kind, const Vec2& room, const KindTable& table,
             const Looks& looks, Random random)
      : drafts_(drafts),
        brief_(brief),
        kinds_(kinds),
        kind_(kind),
        room_(room),
        table_(table),
        looks_(looks),
        random_(random) {
    for (const auto& word : brief.styles)
      if (const brief::Style* style = kinds.style(word)) styles_.push_back(style);
    meaning_ = style_named(kinds, brief.styles);
  }

  void run() {
    if (brief_.bare) return;
    const double area = room_.prod();
    in_core_ = true;
    for (const auto& piece : kind_.core)
      if (random_.chance(piece.chance)) add(piece, core_excess * kind_.share.high * area);
    add_what_makes_it();
    in_core_ = false;
    // A desk that is asked for gets its chair as well.
    for (const auto& piece : kind_.extras)
      if (asked(piece.any.front().first, piece.high > 1)) add_companions(piece, fullest * area);
    const int wanted = wanted_objects();
    const double share =
        random_.uniform(0.6 * kind_.share.low + 0.4 * kind_.share.high, kind_.share.high);
    add_extras(wanted, share * area * fullness());
    // What is still missing is made up of whatever fits.
    add_extras(fewest_things, fullest * area);
    for (const auto& piece : kind_.details)
      if (random_.chance(piece.chance)) add(piece, 1e9);
    seat_people_at_table();
  }

 private:
  double fullness() const {
    double factor = 1.0;
    for (const brief::Style* style : styles_) factor *= style->fullness;
    return factor;
  }

  int wanted_objects() {
    const double usual = random_.integer(kind_.objects_low, kind_.objects_high);
    return static_cast<int>(std::lround(usual * fullness()));
  }

  bool on_floor(const Draft& draft) const { return draft.item.mount == Mount::floor; }

  int floor_count() const {
    int count = 0;
    for (const auto& draft : drafts_)
      if (on_floor(draft)) count += draft.item.quantity;
    return count;
  }

  int count_of(const std::string& category) const {
    int count = 0;
    for (const auto& draft : drafts_)
      if (table_.is_a(draft.item.category, category)) count += draft.item.quantity;
    return count;
  }

  bool excluded(const std::string& category) const {
    return table_.is_any_of(category, brief_.excluded) ||
           std::any_of(brief_.limits.begin(), brief_.limits.end(),
                       [&](const brief::Limit& limit) { return is_barred(category, limit); });
  }
  // "no other chairs", "nothing else on the desk", "nothing on the walls": where small things would stand nobody knows yet.
  bool is_barred(const std::string& category, const brief::Limit& limit) const {
    if (!limit.category.empty()) return table_.is_a(category, limit.category);
    const Mount mount = table_.get(category).mount;
    return limit.mount ? mount == *limit.mount
                       : limit.on != brief::no_mention && mount == Mount::surface;
  }

  // The prompt's own things of this kind, of a kind in which it is, or of its name: who asks for one
  // swivel chair wants no armchair besides. What is somebody's own is none of several.
  bool asked(const std::string& category, bool is_one_of_several) const {
    return std::any_of(drafts_.begin(), drafts_.end(), [&](const Draft& draft) {
      return draft.item.asked && !(is_one_of_several && !brief_.mentions[draft.mention].owner.empty()) &&
             (table_.is_a(draft.item.category, category) ||
              table_.is_a(category, draft.item.category) ||
              shares_name(category, brief_.mentions[draft.mention].noun));
    });
  }

  static bool shares_name(const std::string& category, const std::string& noun) {
    return category.ends_with(noun) || (noun.ends_with("chair") && category.ends_with("chair"));
  }

  bool pointless(const brief::Piece& piece) const {
    if (room_.prod() < piece.area) return true;
    if (!piece.needs.empty() && count_of(piece.needs) == 0) return true;
    if (!piece.serves.empty() && excluded(piece.serves)) return true;
    return std::any_of(piece.unless.begin(), piece.unless.end(),
                       [&](const std::string& other) { return count_of(other) > 0; });
  }

  std::string draw_category(const brief::Piece& piece) {
    std::vector<double> weights;
    for (const auto& [category, weight] : piece.any) {
      const double factor = excluded(category) ? 0.0 : taste(category);
      weights.push_back(weight * factor);
    }
    if (std::none_of(weights.begin(), weights.end(), [](double w) { return w > 0; })) return "";
    return piece.any[random_.weighted(weights)].first;
  }

  // Styles make some kinds more and others less likely.
  double taste(const std::string& category) const {
    constexpr double liked = 4.0, disliked = 0.1;  // by judgement
    double factor = 1.0;
    for (const brief::Style* style : styles_) {
      if (table_.is_any_of(category, style->more)) factor *= liked;
      if (table_.is_any_of(category, style->fewer)) factor *= disliked;
    }
    if (meaning_ && table_.is_any_of(category, meaning_->more)) factor *= liked;
    if (meaning_ && table_.is_any_of(category, meaning_->fewer)) factor *= disliked;
    return factor;
  }

  std::string draw_variant(const brief::Piece& piece) {
    if (piece.of.empty()) return "";
    std::vector<double> weights;
    for (const auto& [variant, weight] : piece.of) weights.push_back(weight);
    return piece.of[random_.weighted(weights)].first;
  }

  int draw_count(const brief::Piece& piece) {
    int count = random_.integer(piece.low, piece.high);
    // People sit in pairs: rather four chairs or six than five.
    if (piece.high >= 4 && count % 2 == 1) count += 1;
    if (piece.people && brief_.people > 0) count = brief_.people;
    if (const int said = seats_said_at(piece.each); said > 0) return said;
    if (!piece.each.empty()) {
      const int served = count_of(piece.each);
      count = piece.shared && served > 1 ? served : count * served;
    }
    return piece.each.empty() ? std::min(count, std::max(max_added, piece.high)) : count;
  }

  // "six tables for two": twelve chairs.
  int seats_said_at(const std::string& kind) const {
    int seats = 0;
    for (const auto& draft : drafts_)
      if (!kind.empty() && table_.is_a(draft.item.category, kind)) seats += draft.seats * draft.item.quantity;
    return seats;
  }

  Vec3 size_of(const brief::Piece& piece, const std::string& category,
               const std::string& variant) const {
    if (piece.size) return *piece.size;
    Vec3 size = table_.get(category).size;
    if (const auto found = kinds_.variants.find(variant); found != kinds_.variants.end()) {
      if (found->second.size) size = *found->second.size;
      size = size.cwiseProduct(found->second.scale);
    }
    return size;
  }

  // A rug is cut to the room.
  void cut(Vec3& size) const {
    const Vec2 most = 0.7 * Vec2(room_.maxCoeff(), room_.minCoeff());
    size.x() = std::min(size.x(), most.x());
    size.y() = std::min(size.y(), most.y());
  }

  bool fits(const PlanItem& item, double budget) const {
    if (item.mount != Mount::floor) return true;
    const Vec3& size = *item.size;
    const double longer = std::max(size.x(), size.y()), shorter = std::min(size.x(), size.y());
    if (longer > widest * room_.maxCoeff() || shorter > widest * room_.minCoeff()) return false;
    const Kind& category = table_.get(item.category);
    if (category.traits.flat) return true;
    return floor_area(drafts_, table_) + item.quantity * size.x() * size.y() <= budget;
  }

  // "a table for six", in a room that usually has none.
  void seat_people_at_table() {
    const auto at = std::find_if(drafts_.begin(), drafts_.end(), [&](const Draft& draft) { return draft.seats > 0; });
    const bool is_seated = count_of("chair") + count_of("stool") + count_of("bench") > 0;
    if (at == drafts_.end() || is_seated || excluded("chair")) return;
    brief::Demand around{.kind = RelationKind::around, .mention = at->mention};
    Draft seats = drafted(brief::Piece{}, "dining chair", "", at->seats * at->item.quantity);
    seats.demands.push_back(around);
    drafts_.push_back(std::move(seats));
  }

  void add_companions(const brief::Piece& piece, double budget) {
    for (const auto& companion : piece.then)
      if (random_.chance(companion.chance)) add(companion, budget);
  }

  bool add(const brief::Piece& piece, double budget) {
    if (pointless(piece)) return false;
    for (const auto& [category, weight] : piece.any)
      if (asked(category, piece.high > 1)) {
        add_companions(piece, budget);
        return false;
      }
    const std::string category = draw_category(piece);
    if (category.empty()) return false;
    const std::string drawn = draw_variant(piece);
    const int count = draw_count(piece);
    for (const auto& variant : variants_from(drawn, piece, category))
      if (add_if_it_fits(piece, category, variant, count, budget)) return true;
    return false;
  }

  // The one that was drawn; where the room has no floor for it, the others, the largest first: a single bed is better
  // than none.
  std::vector<std::string> variants_from(const std::string& drawn, const brief::Piece& piece,
                                         const std::string& category) const {
    std::vector<std::string> others;
    for (const auto& [variant, weight] : piece.of)
      if (variant != drawn) others.push_back(variant);
    const auto area = [&](const std::string& variant) { return size_of(piece, category, variant).head<2>().prod(); };
    std::stable_sort(others.begin(), others.end(), [&](const auto& a, const auto& b) { return area(a) > area(b); });
    others.insert(others.begin(), drawn);
    return others;
  }

  // The smallest thing that makes the room what it is, where its share of the floor has room for none: whether it
  // finds a place is seen when the plan is tried.
  void add_what_makes_it() {
    if (std::any_of(drafts_.begin(), drafts_.end(),
                    [&](const Draft& draft) { return makes_it(draft.item.category); }))
      return;
    const brief::Piece* least = nullptr;
    std::string category, variant;
    const auto area = [&](const brief::Piece& piece, const std::string& kind,
                          const std::string& of) {
      return size_of(piece, kind, of).head<2>().prod();
    };
    for (const auto& piece : kind_.core)
      for (const auto& [kind, weight] : piece.any) {
        if (!makes_it(kind) || excluded(kind) || pointless(piece)) continue;
        for (const auto& of : variants_from(draw_variant(piece), piece, kind))
          if (!least || area(piece, kind, of) < area(*least, category, variant))
            least = &piece, category = kind, variant = of;
      }
    if (least) drafts_.push_back(drafted(*least, category, variant, 1));
  }

  bool makes_it(const std::string& category) const {
    return table_.is_any_of(category, kind_.made_by);
  }

  Draft drafted(const brief::Piece& piece, const std::string& category, const std::string& variant,
                int count) {
    Draft draft;
    draft.core = in_core_;
    PlanItem& item = draft.item;
    item.category = category;
    item.quantity = count;
    item.mount = table_.get(category).mount;
    item.description = looks_.describe(category, variant);
    Vec3 size = size_of(piece, category, variant);
    if (table_.get(category).traits.flat) cut(size);
    item.size = size;
    const int seats = seats_with(piece);
    if (seats > 0) item.size = brief::table_for(size, table_.get(category).traits.round, seats);
    return draft;
  }

  bool add_if_it_fits(const brief::Piece& piece, const std::string& category,
                      const std::string& variant, int count, double budget) {
    Draft draft = drafted(piece, category, variant, count);
    PlanItem& item = draft.item;
    while (item.quantity > 1 && !fits(item, budget)) --item.quantity;
    if (item.quantity < 1 || !fits(item, budget)) return false;
    drafts_.push_back(std::move(draft));
    add_companions(piece, budget);
    return true;
  }

  // How many will sit at this table, if it is one for which seats come along.
  int seats_with(const brief::Piece& piece) const {
    if (piece.then.empty() || !piece.then.front().people || brief_.people == 0) return 0;
    return brief_.people;
  }

  void add_extras(int objects, double budget) {
    std::vector<const brief::Piece*> left;
    std::vector<double> weights;
    for (const auto& piece : kind_.extras) {
      if (count_of(piece.any.front().first) > 0 || used_.count(&piece)) continue;
      left.push_back(&piece);
      weights.push_back(piece.weight * taste(piece.any.front().first));
    }
    while (!left.empty() && floor_count() < objects) {
      if (std::none_of(weights.begin(), weights.end(), [](double w) { return w > 0; })) return;
      const std::size_t i = random_.weighted(weights);
      if (add(*left[i], budget)) used_.insert(left[i]);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      weights.erase(weights.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  std::vector<Draft>& drafts_;
  const brief::Brief& brief_;
  const brief::RoomKinds& kinds_;
  const brief::RoomKind& kind_;
  Vec2 room_;
  const KindTable& table_;
  const Looks& looks_;
  Random random_;
  std::vector<const brief::Style*> styles_;
  const StyleMeaning* meaning_ = nullptr;  ///< of the style that is named first
  std::set<const brief::Piece*> used_;
  bool in_core_ = false;
};

}  // namespace

std::vector<Draft> asked_items(const brief::Brief& brief, const KindTable& table) {
  std::vector<Draft> drafts;
  for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
    const brief::Mention& mention = brief.mentions[i];
    if (mention.contradicts) continue;
    Draft draft;
    draft.mention = i;
    draft.part_of = mention.part_of;
    draft.demands = mention.demands;
    draft.formation = mention.formation;
    draft.seats = mention.seats;
    draft.sized = mention.sized;
    draft.item.category = mention.category;
    draft.item.description = described_with_print(brief, mention, table);
    draft.item.size = mention.size;
    draft.item.quantity = mention.quantity;
    // Posters of which nothing is said show each something else.
    draft.item.varied = mention.varied || are_pictures_of_anything(mention, table);
    draft.item.mount = mention.mount;
    draft.item.height = brief::hanging_height(mention);
    draft.item.asked = true;
    drafts.push_back(std::move(draft));
  }
  fit_tables(drafts, brief, table);
  return drafts;
}

void one_for_each_window(std::vector<Draft>& drafts, const brief::Brief& brief, const Room& room,
                         const KindTable& table) {
  const auto windows = static_cast<int>(
      std::count_if(room.openings.begin(), room.openings.end(),
                    [](const Opening& opening) { return !opening.is_entrance(); }));
  for (auto& draft : drafts) {
    if (draft.mention == brief::Demand::none || draft.item.location ||
        !table.get(draft.item.category).covers_window)
      continue;
    const bool is_of_design = draft.mention >= brief.mentions.size();
    if (is_of_design || brief.mentions[draft.mention].open)
      draft.item.quantity = std::max(1, windows);
  }
}

double floor_area(const PlanItem& item, const KindTable& table) {
  if (item.mount != Mount::floor || table.get(item.category).traits.flat || !item.size) return 0.0;
  const double foot = table.get(item.category).foot;
  return item.quantity * (foot > 0.0 ? foot * foot : item.size->x() * item.size->y());
}

double floor_area(const std::vector<Draft>& drafts, const KindTable& table) {
  double area = 0.0;
  for (const auto& draft : drafts) area += floor_area(draft.item, table);
  return area;
}

void complete(std::vector<Draft>& drafts, const brief::Brief& brief, const brief::RoomKinds& kinds,
              const brief::RoomKind& kind, const Vec2& room, const KindTable& table,
              const Looks& looks, Random random) {
  Completion(drafts, brief, kinds, kind, room, table, looks, random).run();
}

}  // namespace roomgen::plan
