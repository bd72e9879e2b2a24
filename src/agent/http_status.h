#pragma once

#include "endpoint.h"
#include "roomgen/base/result.h"
#include "transport.h"

namespace roomgen {

/// What an answer other than 2xx means and what to do about it.
Error status_error(const HttpAnswer& answer, const Endpoint& endpoint, ChatProtocol protocol);

/// What it means that there was no answer.
Error failure_error(const HttpFailure& failure, const Endpoint& endpoint);

}  // namespace roomgen
