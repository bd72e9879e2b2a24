#include "commands.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <numbers>

#include "check_report.h"
#include "explain.h"
#include "roomgen/import/import.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "views.h"

namespace roomgen::repl {

namespace {

using Maybe = std::optional<Result<Answer>>;

template <typename T>
std::optional<T> number(const std::string& word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::vector<std::string> with(std::vector<std::string> lines, const std::vector<std::string>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

Status write_followers(Desk& desk, Session& session) {
  return cli::write_room(desk.scene.file(), session, desk.draws ? &desk.drawer : nullptr, desk.pixels, desk.tell);
}

Result<Answer> help() {
  Answer answer;
  answer.lines.push_back("A sentence changes the room: put a floor lamp beside the sofa. So do operations as JSON");
  answer.lines.push_back("({\"do\": \"turn\", \"object\": \"desk-0\", \"by_deg\": 90}). Besides:");
  for (const auto& command : commands()) {
    std::string start = "  " + command.name + (command.arguments.empty() ? "" : " ") + command.arguments;
    start.resize(std::max<std::size_t>(start.size() + 1, 28), ' ');
    answer.lines.push_back(start + command.about);
    answer.data["commands"].push_back(command.name);
  }
  return answer;
}

using Step = Result<std::size_t> (Session::*)(std::size_t, const std::string&);

Result<Answer> take_steps(Desk& desk, Step step, std::size_t steps, const std::string& name) {
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const Scene before = (*session)->scene();
  const auto taken = ((*session)->*step)(steps, desk.by);
  if (!taken) return taken.error();
  if (*taken == 0) return Error{Error::Kind::not_found, "there is nothing to " + name};
  if (auto status = write_followers(desk, **session); !status) return status.error();
  const auto changes = differences(before, (*session)->scene());
  return Answer{changes, {{"steps", *taken}, {"changes", changes}}};
}

// Without a number one step.
Maybe run_steps(Desk& desk, const Words& arguments, Step step, const std::string& name) {
  if (arguments.empty()) return take_steps(desk, step, 1, name);
  const auto steps = number<std::size_t>(arguments.front());
  if (!steps || arguments.size() > 1) return std::nullopt;
  return take_steps(desk, step, *steps, name);
}

Result<Answer> tell_history(Desk& desk) {
  const auto session = desk.scene.session();
  if (!session) return session.error();
  return Answer{cli::history_lines(**session), {{"entries", cli::history_json(**session)}}};
}

// BRANCH, perhaps with the state at which a new one begins; none: which there are.
Maybe branch(Desk& desk, const Words& arguments) {
  const auto at = arguments.size() == 2 ? number<std::size_t>(arguments[1]) : std::nullopt;
  if (arguments.size() > 2 || (arguments.size() == 2 && !at)) return std::nullopt;
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const Scene before = (*session)->scene();
  if (!arguments.empty()) {
    if (auto status = (*session)->branch(arguments.front(), at, desk.by); !status) return status.error();
    if (auto status = write_followers(desk, **session); !status) return status.error();
  }
  const auto names = (*session)->branches();
  const std::string current = (*session)->current_branch();
  const auto changes = differences(before, (*session)->scene());
  Answer answer{{}, {{"branch", current}, {"branches", names}, {"changes", changes}}};
  if (!arguments.empty()) answer.lines = with({"on branch " + current}, changes);
  else
    for (const auto& name : names) answer.lines.push_back((name == current ? "* " : "  ") + name);
  return answer;
}

Maybe diff(Desk& desk, const Words& arguments) {
  std::vector<std::optional<std::size_t>> states(2);
  if (arguments.size() > states.size()) return std::nullopt;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (states[i] = number<std::size_t>(arguments[i]); !states[i]) return std::nullopt;
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const auto lines = (*session)->diff(states[0], states[1]);
  if (!lines) return lines.error();
  return Answer{*lines, {{"differences", *lines}}};
}

Maybe import_poses(Desk& desk, const Words& arguments) {
  if (arguments.empty()) return Error{Error::Kind::not_understood, "import: give a .glb file"};
  const std::string file = join(arguments, " ");
  const auto nodes = read_glb_nodes(file);
  if (!nodes) return nodes.error();
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const auto edits = (*session)->compare(*nodes);
  if (!edits) return edits.error();
  for (const auto& note : edits->notes) desk.tell(note);
  if (!edits->missing.empty()) desk.tell("no node is called " + join(edits->missing, ", ") + "; they stay");
  if (edits->operations.empty()) return Answer{{"nothing is different from the room"}, {{"changes", Json::array()}}};
  const auto report = (*session)->apply(edits->operations, {"import " + file, desk.by});
  if (!report) return report.error();
  if (auto status = write_followers(desk, **session); !status) return status.error();
  return Answer{cli::report_lines(*report), cli::report_json(*report)};
}

SceneReport examined(Session& session) { return examine(session.scene(), session.models(), KindTable::built_in()); }

Result<Answer> check(Desk& desk) {
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const Scene& scene = (*session)->scene();
  const SceneReport report = examined(**session);
  return Answer{with({cli::check_headline(scene, report)}, cli::check_lines(scene, report)),
                cli::check_json(scene, report)};
}

Result<Answer> explain(Desk& desk, const Words& arguments) {
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const Scene& scene = (*session)->scene();
  if (arguments.empty()) {
    const auto all = cli::explain_scene(scene);
    return Answer{all.lines, all.data};
  }
  const std::string id = lower(join(arguments, " "));
  const auto one = cli::explain_object(scene, examined(**session), id, cli::traced(desk.scene.file(), id));
  if (!one) return one.error();
  return Answer{one->lines, one->data};
}

Maybe preview(Desk& desk, const Words& arguments) {
  // An id may have blanks; what follows it are two or three numbers.
  std::size_t count = 0;
  while (count < arguments.size() && count < 3 && number<double>(arguments[arguments.size() - 1 - count])) ++count;
  if (count < 2 || count == arguments.size())
    return Error{Error::Kind::not_understood,
                 "preview: give an id, x, y and perhaps an angle, as in: preview desk-0 1.2 0.5 90"};
  const std::size_t first = arguments.size() - count;
  const Words named(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(first));
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const std::string id = lower(join(named, " "));
  const Object* object = find_object((*session)->scene(), id);
  if (!object) return cli::explain_object((*session)->scene(), {}, id, {}).error();
  WantedPose pose;
  pose.position = {*number<double>(arguments[first]), *number<double>(arguments[first + 1])};
  pose.yaw = count == 3 ? *number<double>(arguments[first + 2]) * std::numbers::pi / 180.0 : object->yaw;
  const auto result = (*session)->preview(id, pose);
  if (!result) return result.error();
  return Answer{cli::preview_lines(*result), cli::preview_json(*result)};
}

Maybe render(Desk& desk, const Words& arguments) {
  const std::string view = arguments.empty() ? "top" : arguments.front();
  const auto& views = cli::view_names();
  if (std::count(views.begin(), views.end(), view) == 0)
    return Error{Error::Kind::not_understood, "render: views are " + join(views, ", ")};
  const auto file = arguments.size() > 1
                        ? std::filesystem::path(join(Words(arguments.begin() + 1, arguments.end()), " "))
                        : desk.scene.file().parent_path() / (view + ".png");
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const auto renderer = desk.drawer.renderer();
  if (!renderer) return renderer.error();
  const auto image = (*renderer)->render((*session)->scene(), (*session)->models(), cli::view_named(view, desk.pixels));
  if (!image) return image.error();
  if (auto status = write_png(file, *image); !status) return status.error();
  return Answer{{"wrote " + file.string()}, {{"file", file.string()}}};
}

Answer quit() {
  Answer answer;
  answer.ends = true;
  return answer;
}

// A word that takes nothing after it.
template <typename Run>
auto alone(Run run) {
  return [run](Desk& desk, const Words& arguments) -> Maybe {
    if (!arguments.empty()) return std::nullopt;
    return run(desk);
  };
}

Result<std::vector<edit::Operation>> operations_of(const Desk& desk, const Session& session, const std::string& line) {
  if (line.front() == '{' || line.front() == '[') {
    const auto json = parse_json(line, "operations");
    if (!json) return Error{Error::Kind::not_understood, json.error().message};
    auto operations = edit::operations_from_json(*json, "operations");
    if (!operations) return Error{Error::Kind::not_understood, operations.error().message};
    return operations;
  }
  auto understood = understand(session, line);
  if (!understood) return understood.error();
  for (const auto& remark : understood->remarks) desk.tell(cli::remark_line(remark));
  return std::move(understood->operations);
}

Result<Answer> edit_room(Desk& desk, const std::string& line) {
  const auto session = desk.scene.session();
  if (!session) return session.error();
  const auto operations = operations_of(desk, **session, line);
  if (!operations) return operations.error();
  const auto report = (*session)->apply(*operations, {line, desk.by});
  if (!report) return report.error();
  if (auto status = write_followers(desk, **session); !status) return status.error();
  return Answer{cli::report_lines(*report), cli::report_json(*report)};
}

Words words_of(const std::string& line) {
  Words words = split(line, ' ');
  std::erase(words, "");
  return words;
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {"check", "", "say what is wrong with the room, and what is not as asked", alone(check)},
      {"explain", "[ID]", "say what stands where; or all about one thing",
       [](Desk& desk, const Words& words) -> Maybe { return explain(desk, words); }},
      {"preview", "ID X Y [DEGREES]", "say whether a thing may stand there; nothing changes", preview},
      {"render", "[VIEW] [FILE]", "draw the room: marks, top, iso or eye", render},
      {"undo", "[N]", "take back the last changes",
       [](Desk& desk, const Words& words) { return run_steps(desk, words, &Session::undo, "undo"); }},
      {"redo", "[N]", "do again what was taken back",
       [](Desk& desk, const Words& words) { return run_steps(desk, words, &Session::redo, "redo"); }},
      {"history", "", "list the changes; * is the current state, - what was undone", alone(tell_history)},
      {"branch", "[NAME [STATE]]", "list the branches; or go to one, which begins here or at a state if it is new", branch},
      {"diff", "[FROM [TO]]", "say what is different between two states", diff},
      {"import", "FILE.glb", "take poses back that another program changed", import_poses},
      {"help", "", "list the commands", alone([](Desk&) { return help(); })},
      {"quit", "", "end; so does Ctrl-D", alone([](Desk&) { return quit(); })},
  };
  return all;
}

Result<Answer> answer(Desk& desk, const std::string& line) {
  const Words words = words_of(line);
  const auto command = std::find_if(commands().begin(), commands().end(),
                                    [&](const Command& each) { return each.name == words.front(); });
  if (command != commands().end())
    if (auto result = command->run(desk, Words(words.begin() + 1, words.end()))) return *std::move(result);
  return edit_room(desk, line);
}

std::vector<std::string> names_in(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& object : scene.objects) names.insert(names.end(), {object.id, object.category});
  for (const auto& room : rooms_of(scene))
    for (const auto& opening : room.openings) names.push_back(opening.id);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace roomgen::repl
