#include <nlohmann/json.hpp>

#include "made.h"
#include "roomgen/render/pictures.h"
#include "tools.h"

namespace roomgen::mcp {

namespace {

constexpr int drawn_pixels = 320;

Result<cli::Made> made_of_program(const Json& json) {
  auto program = shape::instantiate(json, {}, 0, nullptr, "/program");
  if (!program) return program.error();
  auto made = shape::evaluate_within(*program);
  if (!made) return with_context(made.error(), "/program");
  return cli::Made{*std::move(program), *std::move(made), {}, false, false, {}, {}};
}

Result<cli::Made> made_of_words(const ToolCall& call) {
  create::CreateOptions options;
  options.cancel = call.cancel;
  if (call.arguments.contains("size")) {
    const Json& size = call.arguments["size"];
    options.size = Vec3(size[0].get<double>(), size[1].get<double>(), size[2].get<double>());
  }
  auto creation = create::create(call.arguments["words"].get<std::string>(),
                                 *create::make_rule_maker(), options);
  if (!creation) return creation.error();
  if (!creation->verdict.passes || creation->objects.empty())
    return Error{Error::Kind::invalid_input,
                 creation->verdict.reason +
                     "; a shape program (roomgen:///docs/shapes.md) says it exactly"};
  return cli::made_of(std::move(creation->objects.front()));
}

}  // namespace

Result<ToolAnswer> create_thing(Workplace& place, const ToolCall& call) {
  const bool has_words = call.arguments.contains("words");
  if (has_words == call.arguments.contains("program"))
    return Error{Error::Kind::invalid_input, "create: give either words or program"};
  auto made = has_words ? made_of_words(call) : made_of_program(call.arguments["program"]);
  if (!made) return made.error();
  made->program.name = call.arguments.value("name", made->program.name);
  const auto folder = place.made_folder();
  if (!folder) return folder.error();
  const auto kept = create::keep_program(made->program, *folder);
  if (!kept) return kept.error();
  place.renew_library();
  Json data = cli::object_json(*made);
  data.erase("bodies");
  std::vector<std::string> lines = {
      "kept as \"" + made->program.name + "\", for designs, candidates and edits that name it"};
  for (const char* list : {"notes", "repairs", "problems"})
    for (const auto& line : data.value(list, Json::array())) lines.push_back(line);
  ToolAnswer answer = text_answer(text_of(lines), std::move(data));
  const auto views = draw_views(to_model(made->shape), drawn_pixels);
  if (!views) return answer;
  if (const auto picture = encode_png(contact_sheet(*views, 2))) add_picture(answer, *picture);
  return answer;
}

}  // namespace roomgen::mcp
