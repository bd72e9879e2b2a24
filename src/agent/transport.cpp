#include "transport.h"

#include <cpr/cpr.h>
#include <curl/curl.h>

#include <exception>
#include <optional>
#include <string_view>

#include "inbox.h"
#include "roomgen/base/text.h"

// cpr describes the request; the loop around it is ours: libcurl's own looks at its callbacks only
// once a second while nothing arrives, and a cancelled call must end at once.

namespace roomgen {

namespace {

using Seconds = HttpClock::Seconds;
using Kind = HttpFailure::Kind;

constexpr int poll_ms = 50;

std::chrono::milliseconds milliseconds(HttpLimits::Seconds seconds) {
  return std::chrono::ceil<std::chrono::milliseconds>(seconds);
}

void prepare(cpr::Session& session, const HttpRequest& request, const HttpLimits& limits,
             Inbox& inbox, const HttpClock& clock) {
  session.SetUrl(cpr::Url{request.url});
  cpr::Header headers;
  for (const auto& [name, value] : request.headers) headers[name] = value;
  session.SetHeader(headers);
  session.SetBody(cpr::Body{request.body});
  // Followed by default, and then the key may go to whoever the answer names.
  session.SetRedirect(cpr::Redirect{false});
  session.SetConnectTimeout(cpr::ConnectTimeout{milliseconds(limits.connect)});
  session.SetHeaderCallback(cpr::HeaderCallback{
      [&inbox](std::string_view line, intptr_t) { return inbox.header(line); }});
  session.SetWriteCallback(
      cpr::WriteCallback{[&inbox](std::string_view bytes, intptr_t) { return inbox.body(bytes); }});
  session.SetProgressCallback(
      cpr::ProgressCallback{[&](cpr::cpr_pf_arg_t, cpr::cpr_pf_arg_t down, cpr::cpr_pf_arg_t,
                                cpr::cpr_pf_arg_t up, intptr_t) {
        inbox.moved(static_cast<long long>(up), static_cast<long long>(down), clock.now());
        return true;
      }});
  session.PreparePost();
  CURL* handle = session.GetCurlHolder()->handle;
  if (request.direct) curl_easy_setopt(handle, CURLOPT_NOPROXY, "*");
#if LIBCURL_VERSION_NUM >= 0x075700
  // A look-up that hangs must not hold up a cancelled call.
  curl_easy_setopt(handle, CURLOPT_QUICK_EXIT, 1L);
#endif
}

Kind kind_of(CURLcode code) {
  switch (code) {
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY:
      return Kind::no_such_host;
    case CURLE_COULDNT_CONNECT:
      return Kind::refused;
    case CURLE_OPERATION_TIMEDOUT:  // the only time limit that is curl's is that of the connection
      return Kind::not_taken;
    case CURLE_SSL_CONNECT_ERROR:
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CERTPROBLEM:
    case CURLE_SSL_CIPHER:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
    case CURLE_SSL_INVALIDCERTSTATUS:
      return Kind::tls;
    default:
      return Kind::broken;
  }
}

std::string within(const char* what, HttpLimits::Seconds limit) {
  return std::string(what) + " " + format_number(limit.count(), 1) + " s";
}

// Whether the server has got some of the request.
bool was_sent(CURL* handle) {
  long bytes = 0;
  curl_easy_getinfo(handle, CURLINFO_REQUEST_SIZE, &bytes);
  return bytes > 0;
}

// Takes the request off the connections before the session goes.
class InFlight {
 public:
  InFlight(CURLM* multi, CURL* easy) : multi_(multi), easy_(easy) {
    curl_multi_add_handle(multi_, easy_);
  }
  InFlight(const InFlight&) = delete;
  InFlight& operator=(const InFlight&) = delete;
  ~InFlight() { curl_multi_remove_handle(multi_, easy_); }

 private:
  CURLM* multi_;
  CURL* easy_;
};

}  // namespace

class Transport::Connections {
 public:
  explicit Connections(const HttpClock& clock) : clock_(clock) {}
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;
  ~Connections() {
    if (multi_) curl_multi_cleanup(multi_);
  }

  HttpOutcome post(const HttpRequest& request, const HttpLimits& limits,
                   const CancelToken& cancel) {
    Inbox inbox(limits, clock_.now());
    cpr::Session session;
    prepare(session, request, limits, inbox, clock_);
    if (!multi_) multi_ = curl_multi_init();  // after the session, which initialises the library
    const auto holder = session.GetCurlHolder();
    const InFlight in_flight(multi_, holder->handle);
    if (auto failure = drive(inbox, limits, cancel)) {
      if (inbox.too_long())
        failure = {Kind::too_long,
                   "the answer is longer than " + std::to_string(limits.answer_bytes) + " bytes"};
      if (failure->what.empty()) failure->what = holder->error.data();
      failure->sent = was_sent(holder->handle);
      return *failure;
    }
    long status = 0;
    curl_easy_getinfo(holder->handle, CURLINFO_RESPONSE_CODE, &status);
    HttpAnswer answer = inbox.take();
    answer.status = static_cast<int>(status);
    return answer;
  }

 private:
  // Until the whole answer is there, or there will be none.
  std::optional<HttpFailure> drive(const Inbox& inbox, const HttpLimits& limits,
                                   const CancelToken& cancel) {
    const Seconds start = clock_.now();
    while (true) {
      int running = 0;
      if (curl_multi_perform(multi_, &running) != CURLM_OK)
        return HttpFailure{Kind::broken, "the connection could not be driven"};
      if (running == 0) return ended();
      if (cancel.cancelled()) return HttpFailure{Kind::cancelled, "cancelled"};
      const Seconds now = clock_.now();
      if (now - start > limits.call)
        return HttpFailure{Kind::timed_out, within("no whole answer within", limits.call)};
      if (inbox.is_silent(now))
        return HttpFailure{Kind::silent, within("hardly a byte for", limits.idle)};
      curl_multi_poll(multi_, nullptr, 0, poll_ms, nullptr);
    }
  }

  std::optional<HttpFailure> ended() {
    int left = 0;
    while (const CURLMsg* message = curl_multi_info_read(multi_, &left)) {
      if (message->msg != CURLMSG_DONE || message->data.result == CURLE_OK) continue;
      return HttpFailure{kind_of(message->data.result), ""};
    }
    return std::nullopt;
  }

  const HttpClock& clock_;
  CURLM* multi_ = nullptr;
};

Transport::Transport(HttpClock clock)
    : clock_(std::move(clock)), connections_(std::make_unique<Connections>(clock_)) {}
Transport::~Transport() = default;

HttpOutcome Transport::post(const HttpRequest& request, const HttpLimits& limits,
                            const CancelToken& cancel) {
  if (cancel.cancelled()) return HttpFailure{Kind::cancelled, "cancelled"};
  try {
    return connections_->post(request, limits, cancel);
  } catch (const std::exception& error) {
    return HttpFailure{Kind::broken, error.what()};
  }
}

}  // namespace roomgen
