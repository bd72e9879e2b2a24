#pragma once

#include "workplace.h"

namespace roomgen {

const Step* step_of(const BuildState& state, const std::string& id);

/// Is its place one that nobody said?
bool is_in_row(const Step* step);

/// Did a designer, not rules, say where the thing goes, or where its group does? `now`: the step at work.
bool is_said(const BuildState& state, const std::string& id, const Step* now = nullptr);

/// Where a thing was said to stand; on what.
struct Said {
  std::optional<Vec2> location;
  std::string carrier;
};

/// By its group, else by the first answer: a plan repeats itself, and a model is told what it lost.
Said said_of(const BuildState& state, const Step& step);

/// " stands on desk-0, not on line-0: " and why, of what rests on another thing than was said; else
/// empty.
std::string other_carrier(const BuildState& state, const Step& step,
                          std::span<const Object> objects);

/// In which length a thing is otherwise than was asked, where its asset could not be so; else empty.
/// What a designer asked for is told sooner than what rules did.
std::string other_size(const Workplace& place, const BuildState& state,
                       const PlannedObject& planned, const Object& placed);

/// What stands, or is, otherwise than a designer said, or what it cannot know, for its next question.
std::vector<std::string> told_of(const Work& work);

}  // namespace roomgen
