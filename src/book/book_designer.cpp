#include "book.h"
#include "brief/prompt_words.h"
#include "brief/said_wish.h"
#include "design/planned_place.h"
#include "design/wish_check.h"
#include "planner.h"
#include "roomgen/design/designer.h"
#include "solve/arrangement.h"

namespace roomgen {

namespace {

class BookDesigner : public Designer {
 public:
  explicit BookDesigner(book::Book own, bool is_own_alone)
      : own_(std::move(own)), is_own_alone_(is_own_alone) {}

  Result<Plan> plan(const PlanRequest& request) override {
    if (auto ready = design::check_knowledge(); !ready) return ready.error();
    if (auto status = design::check_request(request); !status) return status.error();
    const brief::Brief brief =
        brief::brief_of(request, *brief::built_in_room_kinds(), KindTable::built_in());
    if (auto status = design::check_understood(request, brief); !status && !is_own_alone_)
      return status.error();
    std::vector<const book::Design*> designs;
    for (const auto& design : own_.designs) designs.push_back(&design);
    Result<std::vector<book::Design>> built_in =
        is_own_alone_ ? std::vector<book::Design>()
                      : book::built_in_designs(book::room_type_of(request, brief));
    if (!built_in) return built_in.error();
    for (const auto& design : *built_in) designs.push_back(&design);
    return book::plan_by_book(request, brief, designs);
  }

  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    return design::place_as_planned(request);
  }

 private:
  book::Book own_;
  bool is_own_alone_;
};

}  // namespace

Result<std::unique_ptr<Designer>> make_book_designer(const BookOptions& options) {
  book::Book own;
  if (!options.folder.empty()) {
    auto read = book::read_book(options.folder);
    if (!read) return read.error();
    own = *std::move(read);
    if (options.log)
      for (const auto& problem : own.problems) options.log(LogLevel::warning, problem);
  }
  if (!options.design.empty()) {
    auto read = book::read_design(options.design);
    if (!read) return read.error();
    own.designs = {*std::move(read)};
  }
  return std::unique_ptr<Designer>(
      std::make_unique<BookDesigner>(std::move(own), !options.design.empty()));
}

}  // namespace roomgen
