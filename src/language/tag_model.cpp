#include "tag_model.h"

#include <algorithm>

extern "C" {
extern const unsigned char roomgen_tagger[];
extern const std::uint64_t roomgen_tagger_size;
}

namespace roomgen::language {

namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t width) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < width; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

}  // namespace

TagModel::TagModel(std::string_view bytes) {
  if (!bytes.starts_with(magic)) return;
  bytes.remove_prefix(magic.size());
  const std::uint32_t count = number_at(bytes, 0, 4);
  slots_ = bytes.substr(4, slot_size * count);
  weights_ = bytes.substr(4 + slots_.size());
  mask_ = count - 1;
}

std::array<int, word_tag_count> TagModel::scores(const TagFeatures& features) const {
  std::array<int, word_tag_count> sums{};
  if (slots_.empty()) return sums;
  for (const std::uint32_t feature : features) {
    for (std::uint32_t slot = feature & mask_;; slot = (slot + 1) & mask_) {
      const std::uint32_t found = number_at(slots_, slot * slot_size, 4);
      if (found == 0) break;
      if (found != feature) continue;
      const std::size_t first = number_at(slots_, slot * slot_size + 4, 3);
      const std::size_t many = number_at(slots_, slot * slot_size + 7, 1);
      for (std::size_t i = first; i < first + many; ++i)
        sums[number_at(weights_, i * weight_size, 1)] +=
            static_cast<std::int16_t>(number_at(weights_, i * weight_size + 1, 2));
      break;
    }
  }
  return sums;
}

WordTag TagModel::best(const TagFeatures& features) const {
  const auto sums = scores(features);
  return static_cast<WordTag>(std::max_element(sums.begin(), sums.end()) - sums.begin());
}

std::optional<WordTag> given_tag(const Unit& unit) {
  switch (unit.kind) {
    case Unit::Kind::number:
    case Unit::Kind::measure:
      return WordTag::quantity;
    case Unit::Kind::comma:
    case Unit::Kind::stop:
      return WordTag::other;
    default:
      return std::nullopt;
  }
}

const TagModel& tag_model() {
  static const TagModel built_in(std::string_view(reinterpret_cast<const char*>(roomgen_tagger),
                                                  static_cast<std::size_t>(roomgen_tagger_size)));
  return built_in;
}

std::vector<WordTag> tag_words(const std::vector<Unit>& units, const std::vector<UnitFacts>& facts,
                               const TagModel& model) {
  std::vector<WordTag> tags;
  TagContext context;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const auto given = given_tag(units[i]);
    tags.push_back(given ? *given : model.best(tag_features(facts, i, context)));
    context.add(units[i], facts[i], tags.back());
  }
  return tags;
}

}  // namespace roomgen::language
