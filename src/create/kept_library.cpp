#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "kinds.h"
#include "library/vocabulary.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"
#include "stock.h"

namespace roomgen::create {

namespace {

namespace fs = std::filesystem;

constexpr const char* library_name = "kept";
// Somebody wanted to see it again: before what is made from words, after what fits better.
constexpr double kept_score = 0.5;
constexpr std::size_t most_kept = 2000;
constexpr std::size_t hash_digits = 6;

struct Kept {
  shape::Program program;
  std::string sha256, kind;
  Vec3 size = Vec3::Ones();
};

std::string kind_of(const std::string& name) {
  const auto phrase = Vocabulary::built_in().understand(name);
  return phrase.known ? phrase.kind : lower(name);
}

// What somebody made stands for no other thing of its kind.
bool is_called(const AssetQuery& query, const std::string& name) {
  const auto said = words(query.category + " " + query.description), all = words(name);
  return std::all_of(all.begin(), all.end(), [&](const std::string& word) {
    return std::find(said.begin(), said.end(), word) != said.end();
  });
}

Result<Kept> read_kept(const fs::path& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  auto json = shape::parse_recipe(*text, path.string());
  if (!json) return json.error();
  auto program = shape::instantiate(*json, {}, 0, nullptr, path.string());
  if (!program) return program.error();
  const auto made = shape::evaluate_within(*program);
  if (!made) return made.error();
  Kept kept{*std::move(program), sha256_hex(*text), "", shape::bounds(*made).size()};
  kept.kind = kind_of(kept.program.name);
  return kept;
}

class KeptLibrary final : public AssetLibrary {
 public:
  explicit KeptLibrary(const fs::path& folder) {
    std::error_code code;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, code))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    if (files.size() > most_kept) files.resize(most_kept);
    for (const auto& file : files)
      if (auto kept = read_kept(file)) kept_.emplace(file.stem().string(), *std::move(kept));
  }

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> matches;
    if (query.made) return matches;
    const auto& vocabulary = Vocabulary::built_in();
    for (const auto& [id, kept] : kept_) {
      const double fit = vocabulary.fit(kept.kind, kind_of(query.category));
      const bool instead = query.asked && !vocabulary.is_a(kept.kind, kind_of(query.category));
      const bool is_other = fit <= 0.0 || instead || !is_called(query, kept.program.name);
      if (is_other || matches.size() >= query.limit) continue;
      AssetInfo info = info_of(id, kept);
      info.mount = query.mount.value_or(info.mount);
      matches.push_back({info, kept_score * fit});
    }
    return matches;
  }

  Result<AssetInfo> find(std::string_view key) const override {
    for (const auto& [id, kept] : kept_)
      if (key == library_name + ("/" + id)) return info_of(id, kept);
    return AssetLibrary::find(key);
  }

  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    const auto found = ref.library == library_name ? kept_.find(ref.id) : kept_.end();
    if (found == kept_.end())
      return Error{Error::Kind::not_found, asset_key(ref) + ": no such object was kept"};
    auto made = shape::evaluate_within(found->second.program);
    if (!made) return made.error();
    return std::make_shared<const Model>(to_model(*made));
  }

 private:
  static AssetInfo info_of(const std::string& id, const Kept& kept) {
    AssetInfo info;
    info.ref = {library_name, id, kept.sha256, "CC0", "", std::nullopt};
    info.name = kept.program.name;
    info.category = kept.kind;
    info.group = "kept";
    info.size = kept.size;
    describe_by_kind(info, kept.kind, true);
    return info;
  }

  std::map<std::string, Kept> kept_;
};

}  // namespace

std::unique_ptr<AssetLibrary> make_kept_library(const fs::path& folder) {
  return std::make_unique<KeptLibrary>(folder);
}

Result<std::string> keep_program(const shape::Program& program, const fs::path& folder) {
  if (auto status = make_folder(folder); !status) return status.error();
  const std::string text = dump_json(shape::write_program(program));
  const auto pieces = words(program.name);
  const std::string name = (pieces.empty() ? "object" : join(pieces, "-")) + "-" +
                           sha256_hex(text).substr(0, hash_digits) + ".json";
  if (auto status = write_file(folder / name, text); !status) return status.error();
  return name;
}

}  // namespace roomgen::create
