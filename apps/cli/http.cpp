#include "http.h"

#include <dlfcn.h>

#include "beside_program.h"
#include "http_module.h"

namespace roomgen::cli {

namespace {

Error load_error(const std::filesystem::path& module) {
  const char* reason = dlerror();
  return {Error::Kind::unavailable,
          module.string() + " cannot be used: " + (reason ? reason : "no reason given")};
}

}  // namespace

Result<std::unique_ptr<ChatModel>> load_http_model(const HttpModelOptions& options) {
  const auto module = find_beside_program("roomgen-agent.so", "without it there are no language models");
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
