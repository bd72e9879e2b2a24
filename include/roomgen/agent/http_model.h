#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

/// How questions and answers look on the wire.
enum class ChatProtocol {
  openai,  ///< POST BASE/chat/completions: OpenAI, vLLM, llama.cpp, Ollama, OpenRouter, Gemini, …
  anthropic,  ///< POST BASE/v1/messages
};

/// Bounds on one HTTP request.
struct HttpLimits {
  using Seconds = std::chrono::duration<double>;
  Seconds connect{10};  ///< name look-up, TCP and TLS handshakes
  Seconds idle{30};     ///< of silence; a model that thinks longer needs more
  Seconds call{120};    ///< from start to the last byte
  /// Bytes a second, in either direction; less is silence. So slow an answer would not be whole in time.
  double least_speed = 16.0;
  std::size_t answer_bytes = 16u << 20;  ///< of the body, unpacked
};

/// When a request that failed for the moment is sent again: after 408, 409, 429, 5xx, a time limit,
/// or a broken connection; not after silence, which would only last as long again. Waits double from `first_wait` to `longest_wait`, each shortened by up
/// to a half at random, so that many clients do not come back at once. A server that is still loading its
/// model (503) is waited for as long as `total` allows, whatever `attempts` says.
struct RetryPolicy {
  using Seconds = std::chrono::duration<double>;
  int attempts = 5;  ///< of one question, the first one included
  Seconds first_wait{0.5};
  Seconds longest_wait{20};
  Seconds longest_retry_after{60};  ///< a server that asks for a longer wait ends the call
  Seconds total{600};               ///< over all attempts and waits
  std::uint64_t seed = 0;           ///< of the random part; best another one for each client
};

/// How time passes for time limits and waits; what is left empty is the machine's.
struct HttpClock {
  using Seconds = std::chrono::duration<double>;
  std::function<Seconds()> now;  ///< since any fixed moment
  /// Waits, or returns false as soon as the token is set.
  std::function<bool(Seconds, const CancelToken&)> pause;
};

struct HttpModelOptions {
  std::string base_url = "https://api.openai.com/v1";  ///< http or https; a query is kept
  std::string model;                                   ///< as the endpoint names it
  std::optional<ChatProtocol> protocol;                ///< unless given: told from the host
  /// A file of mode 600 that holds the key and nothing else. Unless given, the key is the
  /// environment's ROOMGEN_API_KEY, or else OPENAI_API_KEY or ANTHROPIC_API_KEY by protocol.
  /// ROOMGEN_API_KEY set to nothing says that the server wants none; one on this machine may always
  /// go without.
  std::filesystem::path key_file;
  HttpLimits limits;
  RetryPolicy retry;
  HttpClock clock;
  LogSink log;  ///< told of retries and of what the endpoint does not take
};

/// A model behind an HTTP endpoint; needs the network at `chat`, not before. Redirects are not
/// followed: the key goes to the host of `base_url` and to no other, over plain http only to this
/// machine. It appears in no error, reply or log.
///
/// An endpoint that refuses an option of the request (a schema, a temperature, the name of the
/// bound on tokens) is asked again without it, and not with it again. One that takes no pictures fails
/// with invalid_input.
///
/// Every request that reaches the endpoint counts with ChatRequest::meter: those that are repeated,
/// and those that end in a time limit or an answer of no use.
///
/// Fails with invalid_input for a URL, an option or a key that cannot be right, unavailable without
/// a needed key. One call at a time; several models may work at once.
Result<std::unique_ptr<ChatModel>> make_http_model(const HttpModelOptions& options);

}  // namespace roomgen
