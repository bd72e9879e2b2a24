#pragma once

#include <string>

#include "catch.h"
#include "scene/judgement.h"
#include "support/rooms.h"

/// Does the relation of the object hold in this scene?
inline roomgen::Judgement judged(const roomgen::Scene& scene, roomgen::Object subject,
                                 const std::string& relations) {
  auto parsed = roomgen::parse_relations(relations);
  REQUIRE(parsed);
  subject.relations = *parsed;
  const auto resolved = roomgen::resolve(subject, scene.room, scene.objects,
                                         roomgen::KindTable::built_in());
  REQUIRE(resolved.size() == parsed->size());
  // The last one is meant; others only give it its sense ("aligned").
  return roomgen::judge(resolved.back(),
                        {footprint(subject), bottom(subject), top(subject)}, scene.room);
}

/// The same verdict with everything turned together, at many yaws. Fails the test if they differ.
inline bool held(const roomgen::Scene& scene, const roomgen::Object& subject,
                 const std::string& relations) {
  const auto first = judged(scene, subject, relations);
  for (double degrees = 0.0; degrees < 360.0; degrees += 36.0) {
    const double angle = roomgen::radians(degrees + 0.25);
    const roomgen::Vec2 shift(degrees / 100.0, -3.0);
    const auto turned = judged(rooms::moved(scene, angle, shift), rooms::moved(subject, angle, shift),
                               relations);
    INFO(relations << " turned by " << degrees);
    CHECK(turned.held == first.held);
    CHECK(turned.degree == Approx(first.degree).margin(1e-6));
  }
  CHECK(first.degree >= 0.0);
  CHECK(first.degree <= 1.0);
  return first.held;
}
