#pragma once

#include <filesystem>
#include <memory>

#include "roomgen/library/library.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

/// A library that has nothing in stock and builds what is asked for from words, by rules: for every
/// kind that a recipe makes (create/kinds.h) one match of low score, in the wanted size as far as
/// people would believe it, in the colours and materials that the description names. A thing of another
/// kind that somebody asked for (AssetQuery::asked) is put together from its words, if they say enough,
/// and marked approximate; else there is nothing.
///
/// AssetRef::procedural carries all that is needed to build it again: recipe "words", the params kind,
/// description, size in metres and approximate, and the seed, which follows from the words.
///
/// What was built is kept in memory; for use by several threads at once.
std::unique_ptr<AssetLibrary> make_created_library();

/// The programs of objects that were made and kept: a folder of JSON files, whose "name" says what
/// they are. Licence CC0. A folder that is not there is empty; files that are no programs are left
/// out.
std::unique_ptr<AssetLibrary> make_kept_library(const std::filesystem::path& folder);
/// Keeps a program in the folder, under a name of its own ("bar-stool-3f2a91.json"), which is
/// returned. The folder is made if need be.
Result<std::string> keep_program(const shape::Program& program, const std::filesystem::path& folder);

}  // namespace roomgen::create
