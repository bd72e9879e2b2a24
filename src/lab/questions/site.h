#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "base/random.h"
#include "forms.h"
#include "references.h"
#include "roomgen/lab/questions.h"

namespace roomgen::lab::detail {

inline constexpr std::size_t most_wrong = 3;  ///< choices besides the right one
inline constexpr int tries_for_one = 40;      ///< draws for a question that is wanted

/// What questions of all forms are made from.
struct QuestionSite {
  const Scene& scene;
  const KindTable& kinds;
  const std::vector<FrameRecord>& frames;
  const std::vector<Appearance>& seen;
  const References& references;
  std::size_t most = 4;  ///< questions of a form

  const Object& object(std::size_t k) const { return scene.objects[k]; }
  /// Of the frame's picture.
  double share(std::size_t frame, std::size_t object) const;
  bool same_room(std::size_t a, std::size_t b) const { return object(a).room == object(b).room; }
};

/// Frames at which the camera has stopped to look at something, in their order; and at what, as an index of the scene.
std::vector<std::size_t> stops_of(const QuestionSite& site);
std::size_t target_of(const QuestionSite& site, std::size_t frame);

/// A form's questions, at most `most`.
using FormMaker = std::vector<SpatialQuestion> (*)(const QuestionSite& site, Random& random);

/// A question without its answer: `places` are what stands in its text, by the names of their places.
struct QuestionDraft {
  std::string form;
  std::vector<std::pair<std::string, const Reference*>> places;
  Fillings words;                        ///< of places that are no things
  std::vector<const Reference*> things;  ///< that it is about besides
  std::vector<std::size_t> frames;       ///< that show what the answer needs besides the things' best ones
  Json arguments = Json::object();       ///< besides the places
};
SpatialQuestion number_question(const QuestionSite& site, Random& random, const QuestionDraft& draft, double answer);
/// With the choices in an order of chance; none may be twice.
SpatialQuestion choice_question(const QuestionSite& site, Random& random, const QuestionDraft& draft, const std::string& right,
                         std::vector<std::string> wrong);

/// References that say nothing of where a thing is: choices give no answers away.
bool says_no_place(const Reference& reference);

std::vector<SpatialQuestion> height_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> length_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> distance_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> gap_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> area_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> room_area_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> count_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> side_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> behind_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> order_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> first_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> between_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> carried_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> carrier_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> nearest_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> in_room_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> color_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> kind_questions(const QuestionSite& site, Random& random);
std::vector<SpatialQuestion> in_sight_questions(const QuestionSite& site, Random& random);

}  // namespace roomgen::lab::detail
