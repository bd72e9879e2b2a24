#include <set>

#include "base/resource.h"
#include "brief/kind_mention.h"
#include "brief/prompt_words.h"
#include "brief/room_kinds.h"
#include "catch.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "solve/arrangement.h"

using namespace roomgen;
using namespace roomgen::brief;

namespace {

const KindTable& table() {
  return KindTable::built_in();
}

bool exists(const std::string& category) {
  const auto found = table().all().find(category);
  return found != table().all().end() && !found->second.variant;
}

void check_pieces(const std::vector<Piece>& pieces, const RoomKinds& kinds) {
  for (const auto& piece : pieces) {
    for (const auto& [category, weight] : piece.any) {
      INFO(category);
      CHECK(exists(category));
    }
    for (const auto& [variant, weight] : piece.of) {
      INFO(variant);
      CHECK((variant.empty() || kinds.variants.count(variant)));
    }
    for (const auto& category : {piece.each, piece.needs, piece.serves}) {
      INFO(category);
      CHECK((category.empty() || exists(category)));
    }
    for (const auto& category : piece.unless) {
      INFO(category);
      CHECK(exists(category));
    }
    check_pieces(piece.then, kinds);
  }
}

}  // namespace

TEST_CASE("categories only name categories that exist") {
  for (const auto& [name, category] : table().all()) {
    INFO(name);
    for (const auto& zone : category.zones)
      for (const auto& partner : zone.partners) CHECK(exists(partner));
    for (const auto& gap : category.gaps) {
      CHECK(exists(gap.partner));
      CHECK(gap.low <= gap.high);
    }
    for (const auto& other : category.tucks_under) CHECK(exists(other));
  }
}

TEST_CASE("what hangs or stands on others needs no floor for its use") {
  for (const auto& [name, category] : table().all())
    if (!category.variant && (category.mount == Mount::ceiling || category.mount == Mount::surface)) {
      INFO(name);
      CHECK(category.zones.empty());
    }
}

TEST_CASE("data/rooms.json parses and only names categories that exist") {
  const auto parsed = parse_room_kinds(*resource("data/rooms.json"), "rooms.json");
  if (!parsed) FAIL(parsed.error().message);
  std::vector<RoomKind> kinds{parsed->any};
  for (const auto& [type, kind] : parsed->types) kinds.push_back(kind);
  for (const auto& kind : kinds) {
    INFO(kind.type);
    check_pieces(kind.core, *parsed);
    check_pieces(kind.extras, *parsed);
    check_pieces(kind.details, *parsed);
    for (const auto& [word, category] : kind.means) CHECK(exists(category));
    CHECK(kind.share.high < 0.5);
  }
  for (const auto& finish : parsed->finishes)
    for (const auto& category : finish.kinds) CHECK(exists(category));
  for (const auto& [word, style] : parsed->style_words) CHECK(parsed->styles.count(style) == 1);
  for (const auto& [word, style] : parsed->styles)
    for (const auto& category : style.more) CHECK(exists(category));
}

TEST_CASE("data/arrangements.json parses and only names kinds that exist") {
  const auto parsed = parse_arrangements(*resource("data/arrangements.json"), "arrangements.json");
  if (!parsed) FAIL(parsed.error().message);
  for (const auto& [kind, arrangement] : parsed->kinds) {
    INFO(kind);
    CHECK((exists(kind) || kind.ends_with(" thing")));
    auto ways = arrangement.ways;
    ways.insert(ways.end(), arrangement.otherwise.begin(), arrangement.otherwise.end());
    for (const auto& way : ways)
      for (const auto& relation : way) {
        std::string target = relation.target;
        if (target.starts_with("exactly ")) target = target.substr(8);
        INFO(target);
        CHECK((target.empty() || target == "door" || target == "window" || exists(target)));
      }
  }
}

TEST_CASE("data/words.json parses") {
  const auto parsed = parse_vocabulary(*resource("data/words.json"), "words.json");
  if (!parsed) FAIL(parsed.error().message);
  CHECK(parsed->placements.size() > 100);
}

TEST_CASE("names are found in the singular and the plural") {
  const auto found = [&](const std::string& text) {
    const auto match = mention_at(table(), tokenize(text), 0);
    return match.category ? match.category->name : "";
  };
  CHECK(found("bookshelves") == "bookshelf");
  CHECK(found("bedside tables") == "nightstand");
  CHECK(found("couches") == "sofa");
  CHECK(found("knives") == "kitchen knife");
  CHECK(found("spools of thread") == "spool of thread");
  CHECK(found("loaves of bread") == "bread loaf");
  CHECK(found("TV stand") == "tv stand");
  CHECK(found("nonsense") == "");
}
