#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workplace.h"

namespace roomgen {

/// What was said of one object so far.
struct EarlierAnswers {
  std::vector<PlaceAdvice> answers;
  std::vector<std::string> refusals;    ///< of those that found no place
  std::vector<std::string> objections;  ///< to the last one, which did
  std::optional<Vec2> standing_at;      ///< then
};

/// Asks the designer for the place of an object, with why earlier answers did not fit, and keeps account of
/// what that took.
Result<PlaceAdvice> consult(Work& work, const PlannedObject& planned, const PlacementTask& task,
                            const EarlierAnswers& earlier);

/// Adds what an answer took.
void tally(const Consultation& consultation, ModelUse& use);

/// The same of an answer about assets; false where there is none, which may be the end.
template <typename Answer>
bool account(const Result<Answer>& answer, Workplace& place) {
  if (!answer && answer.error().kind == Error::Kind::limit) place.stopped = answer.error().message;
  if (!answer) return false;
  tally(answer->consultation, place.model_use);
  place.model_use.fallbacks = 0;  // those count places
  return true;
}

/// The advice decides what carries the object or what it hangs above, and so its height. `refused`: how
/// often it found no place already.
Status follow(const Work& work, const PlaceAdvice& advice, const PlannedObject& planned,
              std::size_t refused, PlacementTask& task);

}  // namespace roomgen
