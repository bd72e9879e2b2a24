#pragma once

#include "roomgen/agent/http_model.h"

/// What roomgen-agent.so exports. Program and module are of one build.
extern "C" void roomgen_make_http_model(
    const roomgen::HttpModelOptions& options,
    roomgen::Result<std::unique_ptr<roomgen::ChatModel>>& model);
