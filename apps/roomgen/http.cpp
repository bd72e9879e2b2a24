#include "http.h"

#include <dlfcn.h>

#include <filesystem>

#include "http_module.h"

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

// Found by the program's own place, so that neither a path of the machine that built it nor the working
// folder decides what is loaded.
Result<fs::path> find_module(const std::string& name) {
  std::error_code failed;
  const auto folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const auto& place : {folder / name, folder / ROOMGEN_MODULE_FOLDER / name})
    if (fs::exists(place, failed)) return place;
  return Error{Error::Kind::unavailable,
               name + " is missing beside the program: without it there are no language models"};
}

Error load_error(const fs::path& module) {
  const char* reason = dlerror();
  return {Error::Kind::unavailable,
          module.string() + " cannot be used: " + (reason ? reason : "no reason given")};
}

}  // namespace

Result<std::unique_ptr<ChatModel>> load_http_model(const HttpModelOptions& options) {
  const auto module = find_module("roomgen-agent.so");
  if (!module) return module.error();
  // Stays loaded until the program ends: the model's code is in it.
  void* handle = dlopen(module->c_str(), RTLD_NOW | RTLD_LOCAL);
  void* address = handle ? dlsym(handle, "roomgen_make_http_model") : nullptr;
  if (!address) return load_error(*module);
  Result<std::unique_ptr<ChatModel>> model = std::unique_ptr<ChatModel>();
  reinterpret_cast<decltype(&roomgen_make_http_model)>(address)(options, model);
  return model;
}

}  // namespace roomgen::cli
