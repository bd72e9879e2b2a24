#include "libraries.h"

#include <unistd.h>

#include <cstdio>
#include <optional>

#include "print.h"
#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "roomgen/library/library.h"

namespace roomgen::cli {

namespace {

void print_progress(const assets::IndexProgress& progress) {
  std::fprintf(stderr, "\rIndexing %.*s: %zu of %zu ", static_cast<int>(progress.library.size()),
               progress.library.data(), progress.done, progress.total);
  if (progress.done == progress.total) std::fputs("\n", stderr);
}

class LaterLibrary final : public AssetLibrary {
 public:
  LaterLibrary(const LibraryOptions& options, const Context& context) : options_(options), context_(context) {}

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    const auto& library = opened();
    if (!library) return library.error();
    return (*library)->search(query);
  }
  Result<AssetInfo> find(std::string_view key) const override {
    const auto& library = opened();
    if (!library) return library.error();
    return (*library)->find(key);
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    const auto& library = opened();
    if (!library) return library.error();
    return (*library)->load(ref);
  }

 private:
  const Result<std::unique_ptr<AssetLibrary>>& opened() const {
    if (!library_) library_.emplace(open_all_libraries(options_, context_));
    return *library_;
  }

  const LibraryOptions& options_;
  const Context& context_;
  mutable std::optional<Result<std::unique_ptr<AssetLibrary>>> library_;
};

}  // namespace

void add_library_options(CLI::App& command, LibraryOptions& options) {
  command
      .add_option("--library", options.more,
                  "Another furniture library: a .sh3f file or a folder of meshes")
      ->allow_extra_args(false);
  command.add_flag("--no-default-libraries", options.only_these,
                   "Leave out the libraries that the system has");
  command.add_option("--cache", options.cache, "Where the catalogue is kept");
  command.add_flag("--require-sandbox", options.require_sandbox,
                   "Read meshes only where the process that does so can be shut in wholly");
}

Result<std::unique_ptr<assets::Catalogue>> open_libraries(const LibraryOptions& options,
                                                          const Context& context) {
  assets::CatalogueOptions catalogue;
  if (options.only_these) catalogue.libraries.clear();
  catalogue.libraries.insert(catalogue.libraries.end(), options.more.begin(), options.more.end());
  if (catalogue.libraries.empty())
    return Error{Error::Kind::not_found,
                 "no furniture library: install sweethome3d-furniture or give --library"};
  if (!options.cache.empty()) catalogue.cache_dir = options.cache;
  catalogue.rebuild = options.rebuild;
  catalogue.cancel = context.cancel;
  if (!context.quiet && ::isatty(STDERR_FILENO)) catalogue.progress = print_progress;
  catalogue.require_sandbox = options.require_sandbox;
  if (!context.quiet)
    catalogue.log = [verbose = options.verbose](LogLevel level, std::string_view message) {
      if (verbose || level == LogLevel::warning)
        warn(message);
    };
  return assets::open_catalogue(catalogue);
}

std::filesystem::path cache_folder(const LibraryOptions& options) {
  return options.cache.empty() ? assets::default_cache_dir() : std::filesystem::path(options.cache);
}

std::filesystem::path kept_folder(const std::string& cache) {
  return (cache.empty() ? assets::default_cache_dir() : std::filesystem::path(cache)) / "created";
}

Result<std::unique_ptr<AssetLibrary>> open_all_libraries(const LibraryOptions& options,
                                                         const Context& context) {
  std::vector<std::shared_ptr<const AssetLibrary>> libraries;
  libraries.push_back(create::make_kept_library(kept_folder(options.cache)));
  auto catalogue = open_libraries(options, context);
  if (catalogue) libraries.push_back(create::make_finishing_library(*std::move(catalogue)));
  else if (catalogue.error().kind != Error::Kind::not_found || !options.more.empty())
    return catalogue.error();
  else
    std::fprintf(stderr, "roomgen: %s; everything is made from words\n",
                 printable(catalogue.error().message).c_str());
  libraries.push_back(create::make_finishing_library(create::make_created_library()));
  return make_first_of(std::move(libraries));
}

std::unique_ptr<AssetLibrary> make_later_library(const LibraryOptions& options, const Context& context) {
  return std::make_unique<LaterLibrary>(options, context);
}

}  // namespace roomgen::cli
