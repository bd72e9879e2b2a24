#pragma once

#include <map>
#include <string>
#include <vector>

#include "brief/brief.h"
#include "brief/dwelling_prompt.h"
#include "roomgen/scene/plan.h"

namespace roomgen::plan {

/// Of each of Brief::heard: by which requirements it is checked.
using RequirementIds = std::vector<std::vector<std::string>>;

/// What each word of a prompt was taken for, in the order of the text. Function words stand in it
/// only between others of the same entry. What should be checked but is checked by nothing was not
/// understood, and so was what nobody heard.
std::vector<Heard> heard_words(const std::string& prompt, const brief::Brief& brief,
                               const RequirementIds& ids);

/// That of the prompt of a dwelling: what names its rooms, and what each room's own plan heard.
/// `ids` are those of the dwelling's own requirements by the kind of room that they count.
std::vector<Heard> heard_words(const std::string& prompt, const brief::SaidDwelling& said,
                               const std::vector<Plan>& rooms,
                               const std::map<std::string, std::string>& ids);

}  // namespace roomgen::plan
