#pragma once

#include "roomgen/agent/http_model.h"

namespace roomgen::cli {

/// make_http_model, from the module roomgen-agent.so beside the program or in the library folder of its
/// installation. HTTP brings some thirty libraries along: they are loaded when a model is asked for.
Result<std::unique_ptr<ChatModel>> load_http_model(const HttpModelOptions& options);

}  // namespace roomgen::cli
