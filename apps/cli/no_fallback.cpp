#include "no_fallback.h"

namespace roomgen::cli {

namespace {

class NoFallback final : public Designer {
 public:
  Result<Plan> plan(const PlanRequest&) override { return Error{Error::Kind::unavailable, reason}; }
  Result<PlaceAdvice> place(const PlaceRequest&) override { return Error{Error::Kind::limit, reason}; }

 private:
  static constexpr const char* reason = "no rules take over (--no-fallback)";
};

}  // namespace

std::unique_ptr<Designer> make_no_fallback() { return std::make_unique<NoFallback>(); }

}  // namespace roomgen::cli
