#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "item_kind.h"
#include "plan_answers.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "scene/written_asset.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_items = 120;
constexpr int max_objects = 200;
constexpr int max_quantity = 50;
constexpr int max_nesting = 4;                ///< of things on things
constexpr std::size_t max_words = 60;         ///< bytes of a name
constexpr std::size_t max_description = 300;  ///< bytes
constexpr double least_side = 0.02;
constexpr double greatest_side = 10.0;
constexpr double most_lean = 60.0;            ///< degrees

const std::vector<std::string> name_keys = {"name", "category", "object", "item",
                                            "type", "label",    "kind"};
const std::vector<std::string> description_keys = {"description", "desc", "details", "style"};
const std::vector<std::string> size_keys = {"size cm",    "size",         "dimensions cm",
                                            "dimensions", "size m",       "dimensions m",
                                            "size in cm", "bounding box", "dims"};
const std::vector<std::string> quantity_keys = {"quantity", "count", "number", "amount", "qty"};
const std::vector<std::string> variance_keys = {"variance", "variation", "varied"};
const std::vector<std::string> spot_keys = {"place", "placement", "location",
                                             "mount", "where",     "on"};
const std::vector<std::string> group_thing_keys = {"things", "members", "objects", "parts"};
const std::vector<std::string> on_top_keys = {"on top", "objects on top", "items on top",
                                              "children", "on it"};

struct PlaceWord {
  std::string_view word;
  Mount mount;
};
constexpr PlaceWord place_words[] = {{"floor", Mount::floor},     {"ground", Mount::floor},
                                     {"wall", Mount::wall},       {"walls", Mount::wall},
                                     {"ceiling", Mount::ceiling}, {"hanging", Mount::ceiling}};

// A name that says more than the kind stands with what is said of it: "pie case, chrome".
std::string told_with_name(const std::string& name, const std::string& description,
                           const std::string& category) {
  if (description.empty() || name == category) return description.empty() ? name : description;
  const bool has_name = lower(description).find(lower(name)) != std::string::npos;
  return has_name ? description : name + ", " + description;
}

double unlikeness(double sum_of_logs, const Vec3& usual) {
  return std::abs(sum_of_logs - std::log(usual.x() * usual.y()));
}

// Models forget in which unit they were asked to answer; the usual size of the kind tells.
double unit_of(const Vec3& sides, const Kind* kind) {
  const double greatest = std::max(sides.x(), sides.y());
  if (!kind) return greatest < 10.0 ? 1.0 : brief::centimetre;
  const double logs = std::log(std::max(1e-6, sides.x() * sides.y()));
  const double shift = 2.0 * std::log(brief::centimetre);
  return unlikeness(logs, kind->size) < unlikeness(logs + shift, kind->size) ? 1.0
                                                                             : brief::centimetre;
}

/// Reads objects and what stands on them, up to the bounds.
class ItemReader {
 public:
  ItemReader(const ItemLexicon& lexicon, std::vector<std::string>& repairs)
      : lexicon_(lexicon), repairs_(repairs) {}

  // `carrier` is a draft, or Demand::none.
  void read_list(const Json& objects, std::size_t carrier, int nesting) {
    if (nesting > max_nesting) return;
    if (objects.is_string()) return read_item("", objects, carrier, nesting);
    if (!objects.is_structured()) return;
    // An object alone instead of a list.
    if (objects.is_object() && member(objects, name_keys) &&
        !member(objects, name_keys)->is_structured())
      return read_item("", objects, carrier, nesting);
    for (const auto& [key, value] : objects.items())
      read_item(objects.is_object() ? key : "", value, carrier, nesting);
  }

  // The things of groups: how many there are and how large they are say their compositions, unless told.
  void read_groups(const Json& groups) {
    for (std::size_t g = 0; groups.is_array() && g < groups.size(); ++g) {
      const Json* things = groups[g].is_object() ? member(groups[g], group_thing_keys) : nullptr;
      if (!things) continue;
      group_ = reply_group_id(groups[g], g);
      read_list(*things, brief::Demand::none, 0);
    }
    group_.clear();
  }

  std::vector<plan::Draft> take() {
    for (std::size_t i = 0; i < carriers_.size(); ++i) resolve_carrier(i);
    return std::move(drafts_);
  }

 private:
  void note(const std::string& what) {
    if (std::find(repairs_.begin(), repairs_.end(), what) == repairs_.end())
      repairs_.push_back(what);
  }

  void read_item(const std::string& key, const Json& value, std::size_t carrier, int nesting) {
    if (drafts_.size() >= max_items || objects_ >= max_objects)
      return note("only the first " + std::to_string(drafts_.size()) + " items were kept");
    const Json* name_value = value.is_string() ? &value : member(value, name_keys);
    const std::string description = text_in(member(value, description_keys));
    std::string name = text_in(name_value);
    if (name.empty()) name = key.empty() ? description : key;
    if (plain_name(name).empty()) return note("an object without a name was left out");

    plan::Draft draft;
    PlanItem& item = draft.item;
    item.category = category_of({name, description});
    const bool is_sized = read_size(value, item);
    const auto mount = said_mount(value);
    // Now that it is known how large it is and where.
    if (is_sized || mount)
      item.category = category_of({name, description, is_sized ? item.size : std::nullopt, mount});
    // A name is what people say in such a room; a kind is that kind.
    if (const Kind* kind = lexicon_.table.by_name(text_in(member(value, {"kind"}))))
      item.category = kind->name;
    if (!lexicon_.table.find(item.category))
      note("\"" + item.category + "\" is no known kind of thing");
    item.description = shortened(told_with_name(plain_name(name), description, item.category), max_description);
    item.quantity = quantity_of(value, item.category);
    const Json* variance = member(value, variance_keys);
    item.varied = variance && (*variance == Json(true) || text_in(variance).starts_with("var") ||
                               text_in(variance).starts_with("diff"));
    std::string on = group_.empty() ? read_mount(value, item) : usual_mount(item);
    read_height(value, item);
    read_asset(value, item);
    if (!group_.empty()) {
      item.group = group_, item.part = reply_part_name(value);
      if (!member(value, size_keys)) item.size.reset();
      read_spare(value, item);
    } else {
      read_place(value, item);
    }
    draft.mention = drafts_.size();
    if (carrier != brief::Demand::none) {
      item.mount = Mount::surface;
      carry(draft, carrier, is_inside(words(text_in(member(value, spot_keys)))));
      on.clear();
    }
    objects_ += item.quantity;
    drafts_.push_back(std::move(draft));
    carriers_.push_back(std::move(on));
    insides_.push_back(is_inside(words(text_in(member(value, spot_keys)))));
    names_.push_back(plain_name(name));
    const std::size_t self = drafts_.size() - 1;
    const Json* top = member(value, on_top_keys);
    if (!top) return;
    const std::string group =
        std::exchange(group_, "");  // what says nothing of where it is in the group
    read_list(*top, self, nesting + 1);
    group_ = group;
  }

  int quantity_of(const Json& value, const std::string& category) {
    const Json* given = member(value, quantity_keys);
    const auto count = given ? brief::count_in(*given) : std::optional(1);
    if (!count) note("the quantity of the " + category + " is no number; one is taken");
    const int wanted = count.value_or(1);
    const int kept = std::clamp(wanted, 1, std::min(max_quantity, max_objects - objects_));
    if (kept != wanted)
      note("instead of " + std::to_string(wanted) + " of the " + category + " " +
           std::to_string(kept) + " are taken");
    return kept;
  }

  std::string category_of(const SaidThing& thing) const {
    const std::string kind = kind_of(thing, lexicon_);
    return kind.empty() ? plain_name(thing.name) : kind;
  }

  // Where its place is said to be, unless that is another thing.
  static std::optional<Mount> said_mount(const Json& value) {
    for (const auto& piece : words(text_in(member(value, spot_keys))))
      for (const auto& known : place_words)
        if (piece == known.word) return known.mount;
    return std::nullopt;
  }

  // "in the cabinet"
  static bool is_inside(const std::vector<std::string>& place) {
    return !place.empty() && (place.front() == "in" || place.front() == "inside");
  }

  // Whether it is said.
  bool read_size(const Json& value, PlanItem& item) {
    const Kind* kind = lexicon_.table.spelled(item.category);
    if (kind) item.size = kind->size;
    const Json* given = member(value, size_keys);
    auto measures = brief::measures_in(given ? *given : value);
    // {"name": "bed", "width": 160, …}
    if (!given) std::erase_if(measures, [](const auto& one) { return !brief::names_side(one); });
    const auto [said, has_units] = brief::sides_in(measures);
    Vec3 sides = said;
    if (std::isnan(sides.x() + sides.y())) {
      if (given) note("the size of the " + item.category + " is not three numbers");
      if (!item.size) item.size = lexicon_.table.get(item.category).size;
      return false;
    }
    if (!has_units) sides *= unit_of(sides, kind);
    if (std::isnan(sides.z())) sides.z() = lexicon_.table.get(item.category).size.z();
    const Vec3 bounded = sides.cwiseMax(least_side).cwiseMin(greatest_side);
    if (bounded != sides) note("the size of the " + item.category + " was bounded");
    item.size = bounded;
    return true;
  }

  // How high the lower edge of what hangs is; by how much what stands leans against a wall.
  void read_height(const Json& value, PlanItem& item) const {
    const auto amount = [&](const std::vector<std::string>& keys) {
      const Json* given = member(value, keys);
      const auto measure = given ? brief::single_measure(*given) : std::nullopt;
      return measure ? std::clamp(measure->value, 0.0, greatest_side) : 0.0;
    };
    const double bottom = amount({"bottom m", "bottom"});
    const bool hangs = item.mount == Mount::wall || item.mount == Mount::ceiling;
    if ((hangs || !group_.empty()) && bottom > 0.0) item.bottom = bottom;
    const double lean = radians(std::min(amount({"lean deg", "lean"}), most_lean));
    if (lean <= 0.0) return;
    item.mount = Mount::floor;
    item.tilt = {-lean, 0.0};
    item.relations.push_back({RelationKind::edge, ""});
  }

  // Where it stands, if the answer tells that at once.
  static void read_place(const Json& value, PlanItem& item) {
    const ReplyStands stands = read_reply_stands(value);
    item.location = stands.location, item.facing = stands.facing;
    if (stands.at_wall && item.mount == Mount::floor)
      item.relations.push_back({RelationKind::edge, ""});
    read_spare(value, item);
  }

  static void read_spare(const Json& value, PlanItem& item) {
    if (const Json* spare = member(value, {"spare"}); spare && spare->is_number())
      item.spare = std::clamp(spare->get<int>(), 0, 99);
  }

  // What it shall be: the key of an asset, or a shape program.
  static void read_asset(const Json& value, PlanItem& item) {
    const Json* asset = member(value, {"asset"});
    if (asset && asset->is_string()) item.asset = asset->get<std::string>();
    const Json* program = member(value, {"program"});
    if (!program || !program->is_object()) return;
    AssetRef written;
    written.procedural = {program_recipe, json_line(*program), 0};
    item.asset = asset_key(written);
  }

  // Of a thing of a group: where it is says its pattern.
  std::string usual_mount(PlanItem& item) const {
    item.mount = lexicon_.table.get(item.category).mount;
    return "";
  }

  // Sets the mount; the answer is the name of what carries it.
  std::string read_mount(const Json& value, PlanItem& item) {
    const auto mount = said_mount(value);
    item.mount = mount.value_or(lexicon_.table.get(item.category).mount);
    const auto pieces = words(text_in(member(value, spot_keys)));
    if (mount || pieces.empty()) return "";
    const bool on = is_inside(pieces) || pieces.front() == "on" || member(value, {"on"});
    if (!on) {
      note("the place \"" + shortened(join(pieces, " "), max_words) + "\" is not known");
      return "";
    }
    std::size_t skipped = 0;
    while (skipped < pieces.size() &&
           (pieces[skipped] == "on" || pieces[skipped] == "in" || pieces[skipped] == "inside" ||
            pieces[skipped] == "the" || pieces[skipped] == "top" || pieces[skipped] == "of" ||
            pieces[skipped] == "a"))
      ++skipped;
    return join({pieces.begin() + static_cast<std::ptrdiff_t>(skipped), pieces.end()}, " ");
  }

  void carry(plan::Draft& draft, std::size_t carrier, bool is_inside = false) const {
    draft.item.on = drafts_[carrier].item.category;
    draft.demands.push_back({RelationKind::on, carrier, "", false});
    if (is_inside) draft.demands.push_back({RelationKind::inside, carrier, "", false});
  }

  // "on desk": of the things in the list the first desk.
  void resolve_carrier(std::size_t i) {
    const std::string name = plain_name(carriers_[i]);
    if (name.empty()) return;
    const std::string kind = kind_of({name}, lexicon_);
    for (const bool by_name : {true, false})
      for (std::size_t j = 0; j < drafts_.size(); ++j) {
        const std::string& other = drafts_[j].item.category;
        const bool is_kind = other == name || (!kind.empty() && lexicon_.table.is_a(other, kind));
        if (j == i || !(by_name ? names_[j] == name : is_kind)) continue;
        drafts_[i].item.mount = Mount::surface;
        return carry(drafts_[i], j, insides_[i]);
      }
    note("\"" + name + "\", which shall carry the " + drafts_[i].item.category +
         ", is not among the objects");
  }

  const ItemLexicon& lexicon_;
  std::vector<std::string>& repairs_;
  std::vector<plan::Draft> drafts_;
  std::vector<std::string> carriers_;  ///< by name, of the drafts
  std::vector<bool> insides_;          ///< whether it is in its carrier, of the drafts
  std::vector<std::string> names_;     ///< as said, of the drafts
  std::string group_;                  ///< whose things are read
  int objects_ = 0;
};

}  // namespace

std::string reply_group_id(const Json& group, std::size_t number) {
  const std::string said = group.is_object() ? text_in(member(group, {"id", "name", "group"})) : "";
  const std::string name = join(words(said), "-");
  return (name.empty() ? "group" : shortened(name, max_words)) + "-" + std::to_string(number);
}

std::string reply_part_name(const Json& thing) {
  const std::string part = thing.is_object() ? text_in(member(thing, {"part", "role"})) : "";
  const std::string name = part.empty() ? text_in(thing.is_string() ? &thing : member(thing, name_keys)) : part;
  return shortened(lower(name), max_words);
}

std::vector<plan::Draft> read_reply_items(const Json& objects, const Json& groups,
                                          const ItemLexicon& lexicon,
                                          std::vector<std::string>& repairs) {
  ItemReader reader(lexicon, repairs);
  reader.read_groups(groups);
  reader.read_list(objects, brief::Demand::none, 0);
  return reader.take();
}

}  // namespace roomgen::design
