// A language model over HTTP; nobody listens at the address.
#include <roomgen/agent/http_model.h>

#include <cstdio>

int main() {
  using namespace roomgen;
  HttpModelOptions options;
  options.base_url = "http://127.0.0.1:1/v1";
  options.model = "tiny-1";
  options.retry.attempts = 1;
  const auto model = make_http_model(options);
  if (!model) return 1;
  const auto reply = (*model)->chat({});
  if (reply || reply.error().kind != Error::Kind::unavailable) return 1;
  std::puts(reply.error().message.c_str());
}
