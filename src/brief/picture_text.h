#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "language/token.h"
#include "roomgen/base/json.h"

/// What the pictures of a wish show, in lines below its text: "Image 1: a white bedroom".
namespace roomgen::brief {

std::string with_pictures(std::string_view text, const std::vector<std::string>& shown);

/// The number of the picture whose line this byte of a wish stands in; 0 for the text itself.
int picture_of(std::string_view wish, std::size_t byte);

/// Writes into the clauses of brief.json which picture shows them, {"source": "image 1"}: those of
/// which all words are in its line.
void name_pictures(Json& form, std::string_view wish, const std::vector<language::Token>& tokens);

}  // namespace roomgen::brief
