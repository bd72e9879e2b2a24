#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brief_form.h"
#include "discourse.h"

namespace roomgen::brief {

inline constexpr std::size_t most_of_a_thing = 24;  ///< clauses

/// The things of a form as far as they are read, for who reads what is said of them.
struct FormThings {
  FormThings(Form& of, const Vocabulary& words)
      : form(of), lexicon{words, of.table, of.kinds.get(of.brief.type)}, talk(lexicon, of.brief) {}

  std::optional<std::size_t> find_id(const std::string& id) const {
    const auto known = ids.find(id);
    return known == ids.end() ? std::nullopt : std::optional(known->second);
  }

  Form& form;
  const Lexicon lexicon;
  Discourse talk;
  std::map<std::string, std::size_t> ids;              ///< mentions
  std::vector<std::pair<std::size_t, FormNode>> read;  ///< mentions with what is said of them
};

int whole_number(const FormNode& node);
Mount mount_named(const std::string& text, Mount otherwise);

/// How each of them stands.
void read_form_places(FormThings& things);
/// What there shall not be, and what alone.
void read_form_limits(FormThings& things);

}  // namespace roomgen::brief
