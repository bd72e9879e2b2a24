// Journals from strangers. Bytes as they are: what is whole in them lies within them, in order. And, since their sums let nothing
// through that nobody sealed, each line as an entry that somebody did: whatever the entries say of one another, their states come or not.
#include <algorithm>
#include <string>
#include <vector>

#include "bytes.h"
#include "edit/journal.h"
#include "edit/journal_line.h"
#include "edit/timeline.h"

namespace {

using namespace roomgen;

std::string sealed(std::string_view lines) {
  std::string journal;
  while (!lines.empty()) {
    const auto end = std::min(lines.find('\n'), lines.size());
    journal += journal_line(lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return journal;
}

void go_through(const std::vector<JournalEntry>& entries) {
  Timeline timeline;
  for (const auto& entry : entries) timeline.add(entry);
  must(timeline.branches().empty() || timeline.branches().count(timeline.branch()) == 1);
  for (const auto& [name, branch] : timeline.branches()) {
    // Back from where the branch is, and on to where it was.
    for (auto at = timeline.before(branch.head); at; at = timeline.before(*at)) must(*at < branch.head);
    if (const auto next = timeline.after(branch.head, branch.tip)) must(timeline.before(*next) == branch.head);
    const auto state = timeline.state(branch.head);
    if (!state) must(!state.error().message.empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = FuzzedBytes{data, size}.text();
  for (const std::string& text : {std::string(bytes), sealed(bytes)}) {
    const auto journal = read_journal(text, "scene.journal");
    if (!journal) continue;
    must(journal->whole_bytes <= text.size());
    go_through(journal->entries);
  }
  return 0;
}
