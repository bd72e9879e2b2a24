#include "scene_patch.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/json_values.h"

namespace roomgen {

namespace {

constexpr const char* lists_with_ids[] = {"objects", "unplaced", "requirements"};
// No scene has as many, and no list of one is as long.
constexpr std::size_t most_members = 50, longest_list = 20'000;

Error misfit(const std::string& what) {
  return {Error::Kind::invalid_input, "the change does not fit the scene: " + what};
}

std::string id_of(const Json& element) {
  if (!element.is_object() || !element.contains("id") || !element["id"].is_string()) return "";
  return element["id"].get<std::string>();
}

// The ids in order; empty if they do not tell the elements apart.
std::vector<std::string> ids_in(const Json& list) {
  std::vector<std::string> ids;
  std::set<std::string> seen;
  for (const auto& element : list) {
    ids.push_back(id_of(element));
    if (ids.back().empty() || !seen.insert(ids.back()).second) return {};
  }
  return ids;
}

bool have_same_keys(const Json& a, const Json& b) {
  return a.size() == b.size() && std::equal(a.items().begin(), a.items().end(), b.items().begin(),
                                            [](const auto& x, const auto& y) { return x.key() == y.key(); });
}

// An element that changed: the members that did, or all of it if it has other members now.
Json element_change(const std::string& id, const Json& before, const Json& after) {
  Json change = {{"id", id}};
  if (!have_same_keys(before, after)) return change["before"] = before, change["after"] = after, change;
  for (const auto& [key, value] : before.items())
    if (value != after[key]) change["before"][key] = value, change["after"][key] = after[key];
  return change;
}

// The changes from one list to the other; nothing if elements that stayed changed places.
std::optional<Json> list_patch(const Json& before, const Json& after) {
  const auto old_ids = ids_in(before), new_ids = ids_in(after);
  if ((old_ids.empty() && !before.empty()) || (new_ids.empty() && !after.empty())) return std::nullopt;
  std::map<std::string, std::size_t> old_at, new_at;
  for (std::size_t i = 0; i < old_ids.size(); ++i) old_at[old_ids[i]] = i;
  for (std::size_t i = 0; i < new_ids.size(); ++i) new_at[new_ids[i]] = i;
  std::vector<std::string> stayed_before, stayed_after;
  Json changes = Json::array();
  for (std::size_t i = 0; i < old_ids.size(); ++i) {
    if (!new_at.count(old_ids[i])) {
      changes.push_back({{"at", i}, {"before", before[i]}});
      continue;
    }
    stayed_before.push_back(old_ids[i]);
    if (const Json& now = after[new_at[old_ids[i]]]; now != before[i])
      changes.push_back(element_change(old_ids[i], before[i], now));
  }
  for (std::size_t i = 0; i < new_ids.size(); ++i)
    if (old_at.count(new_ids[i])) stayed_after.push_back(new_ids[i]);
    else changes.push_back({{"at", i}, {"after", after[i]}});
  if (stayed_before != stayed_after) return std::nullopt;
  return changes;
}

bool is_list_with_ids(const std::string& key) {
  return std::find(std::begin(lists_with_ids), std::end(lists_with_ids), key) != std::end(lists_with_ids);
}

/// Where in a list the elements are that have ids.
using Places = std::unordered_map<std::string, std::size_t>;

Places places_in(const Json& list) {
  Places places;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (std::string id = id_of(list[i]); !id.empty()) places.emplace(std::move(id), i);
  return places;
}

Status change_element(Json& element, const std::string& id, const Json& before, const Json& after) {
  if (element == before) return element = after, Status();
  for (const auto& [key, value] : before.items()) {
    if (!element.contains(key) || element[key] != value || !after.contains(key))
      return misfit("\"" + key + "\" of " + id + " is another");
    element[key] = after[key];
  }
  return {};
}

// Went first, at its own place; what came goes in by rising places.
Status patch_list(Json& list, const Json& changes) {
  std::vector<std::pair<std::size_t, const Json*>> gone, come;
  const Places places = places_in(list);
  for (const auto& change : changes) {
    const Json &before = member_of(change, "before"), &after = member_of(change, "after");
    if (!member_of(change, "at").is_number_unsigned()) {
      if (!before.is_object() || !after.is_object() || id_of(change).empty()) return misfit("it is not whole");
      const auto place = places.find(id_of(change));
      if (place == places.end()) return misfit("there is no " + id_of(change));
      if (auto status = change_element(list[place->second], place->first, before, after); !status) return status;
      continue;
    }
    const auto at = change["at"].get<std::size_t>();
    (after.is_null() ? gone : come).emplace_back(at, after.is_null() ? &before : &after);
  }
  const auto by_place = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(gone.begin(), gone.end(), by_place);
  std::sort(come.begin(), come.end(), by_place);
  for (auto one = gone.rbegin(); one != gone.rend(); ++one) {
    if (one->first >= list.size() || list[one->first] != *one->second)
      return misfit("there is no " + id_of(*one->second));
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(one->first));
  }
  for (const auto& [at, element] : come) {
    if (at > list.size() || at >= longest_list) return misfit("there is no place " + std::to_string(at));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), *element);
  }
  return {};
}

// The members in the order in which scenes are written, whatever came or went.
Json in_order(Json document) {
  static const char* const order[] = {"format", "version", "units", "up", "front", "prompt", "seed", "incomplete",
                                      "room", "rooms", "objects", "unplaced", "requirements", "heard"};
  Json sorted = Json::object();
  for (const auto* key : order)
    if (const auto found = document.find(key); found != document.end()) sorted[key] = std::move(*found);
  for (auto& [key, value] : document.items())
    if (!sorted.contains(key)) sorted[key] = std::move(value);
  return sorted;
}

}  // namespace

Json scene_patch(const Json& before, const Json& after) {
  Json patch = Json::object();
  std::set<std::string> keys;
  for (const auto& [key, value] : before.items()) keys.insert(key);
  for (const auto& [key, value] : after.items()) keys.insert(key);
  for (const auto& key : keys) {
    const Json &old = member_of(before, key), &now = member_of(after, key);
    if (old == now) continue;
    const bool by_element = is_list_with_ids(key) && old.is_array() && now.is_array();
    if (auto changes = by_element ? list_patch(old, now) : std::nullopt) patch["lists"][key] = *std::move(changes);
    else patch["members"][key] = {{"before", old}, {"after", now}};
  }
  return patch;
}

Json inverse_patch(const Json& patch) {
  const auto turned = [](const Json& change) {
    Json result = Json::object();
    for (const auto& [key, value] : change.items())
      result[key == "before" ? "after" : key == "after" ? "before" : key] = value;
    return result;
  };
  Json inverse = Json::object();
  for (const auto& [key, changes] : member_of(patch, "lists").items()) {
    inverse["lists"][key] = Json::array();
    for (const auto& change : changes) inverse["lists"][key].push_back(turned(change));
  }
  for (const auto& [key, change] : member_of(patch, "members").items()) inverse["members"][key] = turned(change);
  return inverse;
}

Result<Json> apply_patch(Json document, const Json& patch) {
  for (const auto& [key, changes] : member_of(patch, "lists").items()) {
    if (!document.contains(key) || !document[key].is_array() || !changes.is_array())
      return misfit("\"" + key + "\" is no list");
    if (auto status = patch_list(document[key], changes); !status) return status.error();
  }
  const Json& members = member_of(patch, "members");
  if (members.size() > most_members) return misfit("it has more members than scenes");
  for (const auto& [key, change] : members.items()) {
    if (member_of(document, key) != member_of(change, "before")) return misfit("\"" + key + "\" is another");
    if (member_of(change, "after").is_null()) document.erase(key);
    else document[key] = member_of(change, "after");
  }
  return in_order(std::move(document));
}

}  // namespace roomgen
