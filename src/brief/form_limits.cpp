// The clauses of brief.json about what there shall not be.
#include "form_things.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

void read_absence(const FormNode& node, Form& form) {
  const std::string name = lower(node["name"].text()), looks = lower(node["looks"].text());
  if (name.empty() && looks.empty()) return form.problem(node["name"], "is missing");
  std::string category = name;
  if (const FormName named = name_in_form(name, form.table);
      named.kind.length > 0 && !named.kind.is_stand_in())
    category = named.kind.category->name;
  const std::string what = looks.empty()      ? category
                           : category.empty() ? looks
                                              : looks + " " + category;
  const auto heard = form.hear(node["words"], Heard::As::absence, what, 0);
  if (heard.empty()) return form.problem(node["words"], "nothing in the wish says so");
  if (looks.empty())
    form.brief.excluded.push_back(category);
  else
    form.brief.excluded_looks.push_back({category, looks});
}

void read_limit(const FormNode& node, FormThings& things) {
  Form& form = things.form;
  Limit limit;
  for (const auto& one : node["but"].elements(most_of_a_thing))
    if (const auto thing = things.find_id(one.text()))
      limit.allowed.push_back(*thing);
    else
      form.problem(one, "\"" + one.text() + "\" is the id of no thing");
  limit.category = lower(node["name"].text());
  if (const FormName named = name_in_form(limit.category, form.table); named.kind.length > 0)
    limit.category = things.talk.category_name(named.kind);
  if (const auto on = things.find_id(node["on"].text())) limit.on = *on;
  const std::string mount = lower(node["mount"].text());
  if (mount == name(Mount::wall) || mount == name(Mount::ceiling))
    limit.mount = mount_named(mount, Mount::wall);
  limit.is_nothing = node["nothing"].flag();
  limit.heard = form.hear_as_one(node, Heard::As::absence, 0);
  if (limit.heard == HeardWords::none)
    return form.problem(node["words"], "nothing in the wish says so");
  if (limit.is_of_room()) form.brief.bare = true;
  form.brief.limits.push_back(std::move(limit));
}

}  // namespace

void read_form_limits(FormThings& things) {
  const FormNode& root = things.form.root;
  for (const auto& absence : root["absences"].elements(most_of_a_thing))
    read_absence(absence, things.form);
  for (const auto& limit : root["limits"].elements(most_of_a_thing)) read_limit(limit, things);
}

}  // namespace roomgen::brief
