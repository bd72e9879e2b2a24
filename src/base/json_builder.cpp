#include "json_builder.h"

#include <iterator>
#include <string_view>
#include <unordered_map>

namespace roomgen::detail {

namespace {

using Members = std::vector<std::pair<std::string, Json>>;

// Below this many it is quicker to look through all.
constexpr std::size_t few = 24;

// The place of each key where it came first, with the value that came last.
void unite_few(Members& members) {
  for (std::size_t i = 1; i < members.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (members[j].first == members[i].first) {
        members[j].second = std::move(members[i].second);
        members.erase(members.begin() + static_cast<std::ptrdiff_t>(i--));
        break;
      }
}

void unite_many(Members& members) {
  std::unordered_map<std::string_view, std::size_t> places;
  std::vector<bool> again(members.size());
  bool any = false;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto [first, is_new] = places.emplace(members[i].first, i);
    if (is_new) continue;
    members[first->second].second = std::move(members[i].second);
    again[i] = any = true;
  }
  if (!any) return;
  Members once;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (!again[i]) once.push_back(std::move(members[i]));
  members = std::move(once);
}

}  // namespace

bool JsonBuilder::add(Json value) {
  if (++count_ > most_values) return fault_ = Fault::too_many, false;
  values_.emplace_back(std::move(key_), std::move(value));
  key_.clear();
  return true;
}

bool JsonBuilder::number_float(number_float_t value, const string_t&) {
  return add(value);
}

bool JsonBuilder::key(string_t& name) {
  key_ = std::move(name);
  return true;
}

bool JsonBuilder::start_object(std::size_t) {
  outer_keys_.push_back(std::move(key_));
  key_.clear();
  opened_.push_back(values_.size());
  return true;
}

bool JsonBuilder::start_array(std::size_t size) {
  return start_object(size);
}

std::size_t JsonBuilder::close() {
  const std::size_t first = opened_.back();
  opened_.pop_back();
  key_ = std::move(outer_keys_.back());
  outer_keys_.pop_back();
  return first;
}

bool JsonBuilder::end_object() {
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(close());
  Members members(std::make_move_iterator(first), std::make_move_iterator(values_.end()));
  values_.erase(first, values_.end());
  if (members.size() <= few) unite_few(members);
  else unite_many(members);
  Json object = Json::object();
  auto& map = object.get_ref<Json::object_t&>();
  map.reserve(members.size());
  // The vector's own way in: the map's looks for the key first.
  auto& entries = static_cast<Json::object_t::Container&>(map);
  for (auto& [name, value] : members) entries.emplace_back(std::move(name), std::move(value));
  return add(std::move(object));
}

bool JsonBuilder::end_array() {
  const std::size_t first = close();
  Json array = Json::array();
  auto& elements = array.get_ref<Json::array_t&>();
  elements.reserve(values_.size() - first);
  for (std::size_t i = first; i < values_.size(); ++i) elements.push_back(std::move(values_[i].second));
  values_.resize(first);
  return add(std::move(array));
}

bool JsonBuilder::parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& error) {
  constexpr int out_of_range = 406;  // nlohmann's number of it
  fault_ = error.id == out_of_range ? Fault::range : Fault::syntax;
  fault_byte_ = byte;
  return false;
}

}  // namespace roomgen::detail
