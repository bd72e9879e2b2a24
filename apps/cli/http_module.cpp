#include "http_module.h"

__attribute__((visibility("default"))) void roomgen_make_http_model(
    const roomgen::HttpModelOptions& options,
    roomgen::Result<std::unique_ptr<roomgen::ChatModel>>& model) {
  model = roomgen::make_http_model(options);
}
