#include "http.h"

#include "http_module.h"
#include "roomgen/base/shared_library.h"

namespace roomgen::cli {

namespace {

// Found by the program's own place, so that neither a path of the machine that built it nor the working
// folder decides what is loaded.
Result<SharedLibrary> open_module(const std::string& name) {
  std::error_code failed;
  const auto folder = program_folder();
  for (const auto& place : {folder / name, folder / ROOMGEN_MODULE_FOLDER / name})
    if (std::filesystem::exists(place, failed)) return SharedLibrary::open(place.string());
  return Error{Error::Kind::unavailable,
               name + " is missing beside the program: without it there are no language models"};
}

}  // namespace

Result<std::unique_ptr<ChatModel>> load_http_model(const HttpModelOptions& options) {
  const auto library = open_module("roomgen-agent.so");
  if (!library) return library.error();
  decltype(&roomgen_make_http_model) make = nullptr;
  if (auto found = library->find("roomgen_make_http_model", make); !found) return found.error();
  Result<std::unique_ptr<ChatModel>> model = std::unique_ptr<ChatModel>();
  make(options, model);
  return model;
}

}  // namespace roomgen::cli
