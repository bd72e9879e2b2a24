#include <algorithm>

#include "opening_phrase.h"
#include "prompt_passes.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::none;
using language::NounPhrase;
using language::Run;

class PromptOpenings {
 public:
  explicit PromptOpenings(PromptReading& reading) : reading_(reading) {}

  void run() {
    const auto& kinds = OpeningKinds::built_in();
    if (!kinds) return;
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const NounPhrase& said = reading_.parse.phrases[i];
      if (reading_.is_taken(said) || said.is_denied || !names_opening(said, *kinds) ||
          is_place_of_thing(static_cast<std::int32_t>(i)))
        continue;
      read_opening_phrase(static_cast<std::int32_t>(i), *kinds);
    }
  }

 private:
  bool names_opening(const NounPhrase& said, const OpeningKinds& kinds) const {
    for (std::size_t i = said.tokens.begin; i <= said.head; ++i)
      if (const auto length = opening_name_at(reading_.text.plain, i, kinds);
          length > 0 && i + length > said.head)
        return true;
    return false;
  }
  // "under the window": where a thing is.
  bool is_place_of_thing(std::int32_t id) const {
    for (const Attachment& attachment : reading_.parse.attachments) {
      if (attachment.to != id || attachment.from == none || reading_.owns(attachment)) continue;
      const auto kind = reading_.thing(attachment.from).kind.length;
      if (kind > 0 && reading_.placement(attachment)) return true;
    }
    return false;
  }
  void read_opening_phrase(std::int32_t id, const OpeningKinds& kinds) {
    const NounPhrase& said = reading_.phrase(id);
    std::uint32_t sentence = 0;
    for (const Run& run : reading_.parse.sentences)
      if (run.begin <= said.head) sentence = run.begin;
    const auto opening =
        read_opening(reading_.left, left_index(said.tokens.begin), left_index(sentence),
                     reading_.words, reading_.text.table, kinds);
    if (!opening) return;
    if (is_part_of_thing(id, *opening)) return;
    const auto end = opening->end < reading_.left.size() ? reading_.left[opening->end].source.begin
                                                         : reading_.taken.size();
    std::fill(reading_.taken.begin() + said.tokens.begin,
              reading_.taken.begin() + static_cast<std::ptrdiff_t>(end), Taken::yes);
    ask_for(*opening, reading_.brief);
    hear_without(opening->unread, {said.tokens.begin, static_cast<std::uint32_t>(end)}, opening->wish.kind);
  }
  // "two broken windows": nothing was made of "broken".
  void hear_without(const std::vector<std::size_t>& unread, Run words, const std::string& kind) {
    for (const std::size_t i : unread) {
      const auto token = reading_.left[i].source.begin;
      if (token < words.begin || token >= words.end) continue;
      if (token > words.begin) hear(reading_.brief, {words.begin, token}, Heard::As::thing, kind);
      words.begin = token + 1;
    }
    if (!words.empty()) hear(reading_.brief, words, Heard::As::thing, kind);
  }
  // The first of the tokens that are left, from a token of the prompt on.
  std::size_t left_index(std::uint32_t token) const {
    std::size_t i = 0;
    while (i < reading_.left.size() && reading_.left[i].source.end <= token) ++i;
    return i;
  }
  // "a wardrobe with sliding doors"
  bool is_part_of_thing(std::int32_t id, const OpeningPhrase& opening) const {
    if (opening.wish.type == OpeningType::window) return false;
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& attachment) {
      if (attachment.to != id || attachment.from == none || !reading_.owns(attachment)) return false;
      const KindMention& owner = reading_.thing(attachment.from).kind;
      // "a cabinet with glass doors on the left wall": the cabinet is there.
      return owner.length > 0 && (!opening.wish.has_place() || reading_.text.table.is_a(owner.category->name, "storage"));
    });
  }

  PromptReading& reading_;
};

}  // namespace

void read_openings(PromptReading& reading) {
  PromptOpenings(reading).run();
}

}  // namespace roomgen::brief
