#include "benchmark_run.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "benchmark_report.h"
#include "resumable_lines.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/questions.h"
#include "roomgen/lab/frames.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_video_bytes = 256u << 20;

Error bad_run(const std::string& what) { return {Error::Kind::invalid_input, "benchmark: " + what}; }

// Of a scene of the set, where questions say; or of the set itself.
fs::path folder_of(const std::string& set, const SpatialQuestion& question) {
  const Json& complexity = question.complexity;
  if (complexity.is_object() && complexity.contains("folder")) return fs::path(set) / complexity["folder"].get<std::string>();
  return set;
}

bool is_picture(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n") || bytes.starts_with("\xFF\xD8\xFF"); }
bool is_video(std::string_view bytes) { return bytes.size() > 8 && bytes.substr(4, 4) == "ftyp"; }

// Those where the camera stops and, between them, evenly spread ones; never more than `most`.
std::vector<std::size_t> spread_frames(const std::vector<FrameRecord>& frames, std::size_t most) {
  std::vector<std::size_t> stops, all;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    all.push_back(k);
    if (!frames[k].frame.target.empty()) stops.push_back(k);
  }
  const auto thinned = [](const std::vector<std::size_t>& list, std::size_t count) {
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < count && !list.empty(); ++k) some.push_back(list[k * list.size() / count]);
    return some;
  };
  if (stops.size() >= most) return thinned(stops, most);
  std::set<std::size_t> chosen(stops.begin(), stops.end());
  for (const std::size_t k : thinned(all, most)) {
    if (chosen.size() >= most) break;
    chosen.insert(k);
  }
  return {chosen.begin(), chosen.end()};
}

class Examiner {
 public:
  Examiner(const Context& context, const BenchmarkRunOptions& options, ChatModel& model, const Prompts& prompts)
      : context_(context), options_(options), model_(model), prompts_(prompts) {}

  // Who has shown videos goes on with them, who has had to show frames too: all questions are asked in one way.
  void go_on_with(const std::string& shown) { (shown == "video" ? took_video_ : refused_video_) = true; }
  const char* shows() const { return options_.video && !refused_video_ ? "video" : "frames"; }

  Result<std::string> answer(const SpatialQuestion& question) {
    const fs::path folder = folder_of(options_.set, question);
    if (options_.video && !refused_video_) {
      auto request = video_request(question, folder);
      if (!request) return request.error();
      const auto reply = model_.chat(*request);
      took_video_ = took_video_ || reply;
      if (reply) return reply->text;
      const auto kind = reply.error().kind;
      if (took_video_ || kind == Error::Kind::cancelled || kind == Error::Kind::limit) return reply.error();
      std::fprintf(stderr, "no video is taken: %s; frames are shown\n", printable(reply.error().message).c_str());
      refused_video_ = true;
    }
    const auto frames = frames_in(folder);
    if (!frames) return frames.error();
    auto request = request_for(question, **frames, folder);
    if (!request) return request.error();
    const auto reply = model_.chat(*request);
    if (!reply) return reply.error();
    return reply->text;
  }

 private:
  Result<const std::vector<FrameRecord>*> frames_in(const fs::path& folder) {
    auto& known = frames_[folder.string()];
    if (known.empty()) {
      auto frames = read_frames(folder / "frames.jsonl");
      if (!frames) return frames.error();
      known = std::move(*frames);
    }
    return &known;
  }

  Result<ChatRequest> request_for(const SpatialQuestion& question, const std::vector<FrameRecord>& frames, const fs::path& folder) {
    const auto chosen = frames_for(question, frames);
    ChatMessage user{ChatMessage::Role::user, "", {}};
    std::vector<std::string> times;
    for (const std::size_t k : chosen) {
      if (frames[k].picture.empty()) return bad_run(folder.string() + ": the frames have no rgb layer");
      auto picture = read_file(folder / frames[k].picture);
      if (!picture) return picture.error();
      // It goes to the model: a stranger's set may name, or link to, what is no picture.
      if (!is_picture(*picture)) return bad_run((folder / frames[k].picture).string() + ": is no PNG or JPEG picture");
      user.images.push_back(std::move(*picture));
      times.push_back(format_number(frames[k].frame.time, 1));
    }
    return request_of(std::move(user), question, "question-user", {{"times", join(times, ", ")}});
  }

  Result<ChatRequest> video_request(const SpatialQuestion& question, const fs::path& folder) const {
    auto video = read_file(folder / "tour.mp4", most_video_bytes);
    if (!video)
      return bad_run(video.error().message + ": `benchmark make` makes it where ffmpeg is installed; without --video frames are shown");
    if (!is_video(*video)) return bad_run((folder / "tour.mp4").string() + ": is no MP4 video");
    return request_of({ChatMessage::Role::user, "", {std::move(*video)}}, question, "question-video-user", {});
  }

  Result<ChatRequest> request_of(ChatMessage user, const SpatialQuestion& question, const char* prompt,
                                 Prompts::Slots values) const {
    values["question"] = question.text;
    values["choices"] = choices_text(question);
    const auto text = prompts_.render(prompt, values);
    const auto system = prompts_.render("question-system", {{"answer_form", answer_form(question)}});
    if (!text) return text.error();
    if (!system) return system.error();
    user.text = *text;
    ChatRequest request;
    request.messages = {{ChatMessage::Role::system, *system, {}}, std::move(user)};
    request.max_tokens = options_.answer_tokens;
    request.thinking = options_.thinking;
    request.cancel = context_.cancel;
    return request;
  }

  std::vector<std::size_t> frames_for(const SpatialQuestion& question, const std::vector<FrameRecord>& frames) const {
    if (!options_.evidence) return spread_frames(frames, static_cast<std::size_t>(options_.frames));
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < frames.size(); ++k)
      if (std::count(question.frames.begin(), question.frames.end(), frames[k].frame.number) > 0) chosen.push_back(k);
    chosen.resize(std::min(chosen.size(), static_cast<std::size_t>(options_.frames)));
    return chosen;
  }

  static std::string choices_text(const SpatialQuestion& question) {
    std::string text;
    for (std::size_t k = 0; k < question.choices.size(); ++k)
      text += std::string(1, static_cast<char>('A' + k)) + ". " + question.choices[k] + "\n";
    return text;
  }

  static std::string answer_form(const SpatialQuestion& question) {
    if (!question.choices.empty()) return "the letter of the right choice";
    return question.unit.empty() ? "a whole number" : "a number without a unit";
  }

  const Context& context_;
  const BenchmarkRunOptions& options_;
  ChatModel& model_;
  const Prompts& prompts_;
  std::map<std::string, std::vector<FrameRecord>> frames_;
  bool took_video_ = false, refused_video_ = false;
};

Json line_json(const SpatialQuestion& question, const std::string& answer, const char* shown) {
  const AnswerScore score = score_answer(question, answer);
  return {{"id", question.id}, {"task", question.task}, {"shown", shown}, {"answer", answer}, {"read", score.read}, {"exact", score.exact},
          {"mean_relative", rounded(score.mean_relative, 3)}, {"relative", rounded(score.relative, 3)}};
}

using Answers = std::map<std::string, std::string>;

// Answers whose line cannot be used are refused with the line.
Status add_answer(const Json& json, const std::string& where, Answers& answers) {
  if (!json.is_object() || !json.contains("id") || !json["id"].is_string() || !json.contains("answer"))
    return bad_run(where + ": a line must have an id and an answer");
  if (!json.value("shown", Json("")).is_string()) return bad_run(where + ": what was \"shown\" must be a text");
  answers[json["id"].get<std::string>()] = json["answer"].is_string() ? json["answer"].get<std::string>() : json["answer"].dump();
  return {};
}

Status write_results(const Context& context, const fs::path& folder, const std::vector<SpatialQuestion>& questions,
                     const Answers& answers) {
  std::vector<ScoredQuestion> scored;
  for (const auto& question : questions)
    if (const auto answer = answers.find(question.id); answer != answers.end())
      scored.push_back({&question, score_answer(question, answer->second)});
  const std::string report = benchmark_report(scored);
  if (auto status = make_folder(folder); !status) return status;
  for (const std::string factor : {"compositional", "relational", "observational"}) {
    const fs::path file = folder / (factor + ".svg");
    std::error_code code;
    fs::remove(file, code);  // of other answers
    if (const auto plot = benchmark_plot(scored, factor); !plot.empty())
      if (auto status = write_file(file, plot); !status) return status;
  }
  if (auto status = write_file(folder / "report.md", report); !status) return status;
  if (!context.quiet) std::fputs(printable(report).c_str(), stdout);
  return {};
}

}  // namespace

Result<int> run_benchmark(const Context& context, const BenchmarkRunOptions& options) {
  if (options.frames < 1 || options.frames > 1000) return bad_run("there must be 1 to 1000 frames with a question");
  if (options.video && options.evidence) return bad_run("--evidence shows single frames: leave out --video, or --evidence");
  auto questions = read_questions(fs::path(options.set) / "questions.jsonl");
  if (!questions) return questions.error();
  if (options.limit > 0) questions->resize(std::min(questions->size(), static_cast<std::size_t>(options.limit)));
  auto composed = compose_model(options.model, context, options.cache);
  if (!composed) return composed.error();
  if (!composed->model) return bad_run("name a model: --model, and --base-url for one of your own");
  Json head = {{"format", "roomgen-benchmark-answers"}, {"version", 1}, {"model", options.model.model},
               {"frames", options.frames}, {"evidence", options.evidence}};
  if (options.video) head["video"] = true;
  if (options.thinking > 0) head["thinking"] = options.thinking;
  auto lines = ResumableLines::open(options.output, head, options.force);
  if (!lines) return lines.error();
  Answers answers;
  Examiner examiner(context, options, *composed->model, composed->prompts);
  for (const auto& line : lines->earlier()) {
    if (auto status = add_answer(line.json, line.where, answers); !status) return status.error();
    examiner.go_on_with(line.json.value("shown", "frames"));
  }
  for (const auto& question : *questions) {
    if (answers.count(question.id)) continue;
    const auto answer = examiner.answer(question);
    if (!answer)
      return Error{answer.error().kind, answer.error().message + "; " + std::to_string(answers.size()) + " of " +
                                            std::to_string(questions->size()) +
                                            " are answered, the same command goes on from there"};
    if (auto status = lines->add(line_json(question, *answer, examiner.shows())); !status) return status.error();
    answers[question.id] = *answer;
    if (!context.quiet) std::fprintf(stderr, "[%zu/%zu] %s\n", answers.size(), questions->size(), printable(question.id).c_str());
  }
  if (auto status = write_results(context, options.output, *questions, answers); !status) return status.error();
  return exit_ok;
}

Result<int> score_answers(const Context& context, const std::string& questions_file, const std::string& answers_file,
                          const std::string& output) {
  const auto questions = read_questions(questions_file);
  if (!questions) return questions.error();
  const auto text = read_file(answers_file);
  if (!text) return text.error();
  Answers answers;
  std::size_t number = 0;
  for (const auto& line : split(*text, '\n')) {
    const std::string where = answers_file + ": line " + std::to_string(++number);
    if (line.empty()) continue;
    const auto json = parse_json(line, where);
    if (!json) return json.error();
    if (auto status = add_answer(*json, where, answers); !status) return status.error();
  }
  if (auto status = write_results(context, output, *questions, answers); !status) return status.error();
  return exit_ok;
}

}  // namespace roomgen::cli
