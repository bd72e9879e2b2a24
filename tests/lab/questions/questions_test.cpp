// Questions about boxes that frames of our own making show, against answers worked out here.
#include "roomgen/lab/questions.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "support/rooms.h"
#include "support/temporary_folder.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

const char* const kinds[] = {"sofa", "bookshelf", "wardrobe", "desk", "chair", "chair", "armchair", "floor lamp", "plant", "nightstand"};

// Some things apart from each other, a vase on one of them.
Scene random_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene = rooms::scene(rooms::box(7, 6), {});
  std::map<std::string, int> numbers;
  for (const char* kind : kinds) {
    for (int tries = 0; tries < 50; ++tries) {
      const double w = random.uniform(0.3, 1.6), d = random.uniform(0.3, 0.8), h = random.uniform(0.3, 2.0);
      const double x = random.uniform(0.9, 6.1), y = random.uniform(0.9, 5.1);
      auto object = rooms::thing(std::string(kind) + "-" + std::to_string(numbers[kind]), kind, {w, d, h}, {x, y},
                                 random.uniform(-180.0, 180.0));
      std::replace(object.id.begin(), object.id.end(), ' ', '-');
      if (std::any_of(scene.objects.begin(), scene.objects.end(),
                      [&](const Object& other) { return overlaps(footprint(object), footprint(other), 0.0); }))
        continue;
      ++numbers[kind];
      scene.objects.push_back(object);
      break;
    }
  }
  // What carries something, and what is looked at first, must be by chance here.
  random.shuffle(scene.objects);
  const char* small[] = {"vase", "clock"};
  for (std::size_t k = 0; k < 2 && k < scene.objects.size(); ++k) {
    auto object = rooms::thing(std::string(small[k]) + "-0", small[k], {0.2, 0.2, 0.3}, scene.objects[k].position.head<2>());
    object.mount = Mount::surface;
    object.on = scene.objects[k].id;
    object.position.z() = scene.objects[k].size.z();
    scene.objects.push_back(object);
  }
  return scene;
}

// A camera that turns about and jumps: what lies within 45 degrees is seen, larger the nearer it is.
std::vector<FrameRecord> random_frames(const Scene& scene, std::uint64_t seed) {
  Random random(seed, 1);
  std::vector<FrameRecord> frames(60);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    FrameRecord& frame = frames[f];
    frame.width = 640, frame.height = 480;
    frame.frame.number = f;
    frame.frame.time = 0.25 * static_cast<double>(f);
    const double x = random.uniform(0.5, 6.5), y = random.uniform(0.5, 5.5);
    frame.frame.pose = {{x, y, 1.5}, random.uniform(-pi, pi), 0.0};
    if (f % 5 == 4) frame.frame.target = scene.objects[f / 5 % scene.objects.size()].id;
    const Vec2 looks(std::sin(frame.frame.pose.yaw), -std::cos(frame.frame.pose.yaw));
    for (const auto& object : scene.objects) {
      const Vec2 way = object.position.head<2>() - Vec2(x, y);
      const bool ahead = looks.dot(way.normalized()) > std::cos(radians(45.0));
      const double size = 300.0 * object.size.z() / std::max(way.norm(), 0.3);
      const bool seen = ahead && random.chance(0.4);
      frame.objects.push_back({object.id, seen ? static_cast<std::size_t>(size * size * 0.5) : 0, {0, 0, 1, 1}});
    }
  }
  return frames;
}

std::vector<SpatialQuestion> asked(const Scene& scene, const std::vector<FrameRecord>& frames, std::uint64_t seed, int per_form = 6) {
  QuestionOptions options;
  options.seed = seed;
  options.per_form = per_form;
  auto questions = make_questions(scene, {}, KindTable::built_in(), frames, options);
  if (!questions) FAIL(questions.error().message);
  return std::move(*questions);
}

const Object& named(const Scene& scene, const SpatialQuestion& question, const char* place) {
  return *find_object(scene, question.arguments.at(place).get<std::string>());
}

std::size_t index_of(const Scene& scene, const std::string& id) {
  return static_cast<std::size_t>(find_object(scene, id) - scene.objects.data());
}

// The frame from which on an object fills a share of the picture.
std::size_t first_with(const Scene& scene, const std::vector<FrameRecord>& frames, const std::string& id, double share) {
  const std::size_t k = index_of(scene, id);
  for (std::size_t f = 0; f < frames.size(); ++f)
    if (static_cast<double>(frames[f].objects[k].pixels) >= share * 640 * 480) return f;
  return frames.size();
}

// Corners of one box against edges of the other, both ways.
double distance_between(const Object& a, const Object& b) {
  const auto corners = [](const Object& o) {
    std::vector<Vec2> list;
    for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      list.push_back(o.position.head<2>() + Vec2(std::cos(o.yaw) * x * o.size.x() - std::sin(o.yaw) * y * o.size.y(),
                                                 std::sin(o.yaw) * x * o.size.x() + std::cos(o.yaw) * y * o.size.y()));
    return list;
  };
  double least = 1e9;
  for (const auto& [one, other] : {std::pair(corners(a), corners(b)), std::pair(corners(b), corners(a))})
    for (const auto& p : one)
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 from = other[k], along = other[(k + 1) % 4] - from;
        const double t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (from + t * along - p).norm());
      }
  return least;
}

bool round(const Object& object) { return object.traits.round; }

// "" if the answer is what this finds.
std::string wrong(const Scene& scene, const std::vector<FrameRecord>& frames, const SpatialQuestion& q) {
  const auto number = [&](double truth) {
    return std::abs(truth - q.number) <= 0.0006 ? "" : std::to_string(truth) + " is not " + std::to_string(q.number);
  };
  const std::string answer = q.choices.empty() ? "" : q.choices.at(q.right);
  const auto is = [&](bool right) { return right ? "" : answer + " is not right"; };
  if (q.form == "height") return number(named(scene, q, "a").size.z());
  if (q.form == "length") return number(std::max(named(scene, q, "a").size.x(), named(scene, q, "a").size.y()));
  if (q.form == "area") return number(named(scene, q, "a").size.x() * named(scene, q, "a").size.y());
  if (q.form == "room area") return number(42.0);
  if (q.form == "distance") return number((named(scene, q, "a").position - named(scene, q, "b").position).head<2>().norm());
  if (q.form == "gap") {
    const Object &a = named(scene, q, "a"), &b = named(scene, q, "b");
    return round(a) || round(b) ? "" : number(distance_between(a, b));
  }
  if (q.form == "count") {
    int count = 0;
    const std::string kind = q.arguments.at("kind").get<std::string>();
    for (const auto& object : scene.objects)
      count += KindTable::built_in().is_a(object.category, kind) && first_with(scene, frames, object.id, 0.004) < frames.size();
    return number(count);
  }
  if (q.form == "side") {
    const Vec2 a = named(scene, q, "a").position.head<2>(), b = named(scene, q, "b").position.head<2>() - a,
               c = named(scene, q, "c").position.head<2>() - a;
    return is((b.x() * c.y() - b.y() * c.x() > 0) == (answer == "on the left"));
  }
  if (q.form == "behind") {
    const auto& frame = frames.at(q.arguments.at("frame").get<std::size_t>());
    const auto& pose = frame.frame.pose;
    const Vec2 way = named(scene, q, "right").position.head<2>() - pose.eye.head<2>();
    const bool is_behind = Vec2(std::sin(pose.yaw), -std::cos(pose.yaw)).dot(way.normalized()) < -0.4999;
    return is(is_behind && frame.frame.target == q.arguments.at("a").get<std::string>() &&
              frame.objects[index_of(scene, q.arguments.at("right"))].pixels == 0);
  }
  if (q.form == "order") {
    const auto ids = q.arguments.at("order").get<std::vector<std::string>>();
    for (std::size_t k = 1; k < ids.size(); ++k)
      if (first_with(scene, frames, ids[k - 1], 0.002) >= first_with(scene, frames, ids[k], 0.0002)) return ids[k] + " is not later";
    return "";
  }
  if (q.form == "first") {
    const std::string right = q.arguments.at("right");
    const auto stop = q.arguments.at("frame").get<std::size_t>();
    const auto after = [&](const std::string& id, double share) {
      std::size_t f = stop + 1;
      while (f < frames.size() && static_cast<double>(frames[f].objects[index_of(scene, id)].pixels) < share * 640 * 480) ++f;
      return f;
    };
    if (frames.at(stop).frame.target != q.arguments.at("a").get<std::string>()) return "the camera looks at something else";
    for (const std::string id : q.arguments.at("of")) {
      if (static_cast<double>(frames[stop].objects[index_of(scene, id)].pixels) >= 0.0002 * 640 * 480) return id + " is in sight";
      if (id != right && after(id, 0.0002) <= after(right, 0.002)) return id + " is earlier";
    }
    return "";
  }
  if (q.form == "between") {
    const auto seen = [&](const std::string& id) { return first_with(scene, frames, id, 0.002); };
    const std::size_t a = seen(q.arguments.at("a")), b = seen(q.arguments.at("b"));
    for (const std::string id : q.arguments.at("of")) {
      const bool inside = seen(id) > a && seen(id) < b;
      if (inside != (id == q.arguments.at("right").get<std::string>())) return id + " is on the wrong side";
    }
    return "";
  }
  if (q.form == "carried") return is(named(scene, q, "right").on == q.arguments.at("a").get<std::string>());
  if (q.form == "carrier") return is(named(scene, q, "a").on == q.arguments.at("right").get<std::string>());
  if (q.form == "nearest") {
    const Object &a = named(scene, q, "a"), &right = named(scene, q, "right");
    for (const auto& id : q.objects) {
      const Object& other = *find_object(scene, id);
      if (other.id == a.id || other.id == right.id || round(a) || round(other) || round(right)) continue;
      if (other.mount == Mount::floor && distance_between(a, other) < distance_between(a, right) + 0.29) return id + " is as near";
    }
    return "";
  }
  if (q.form == "kind") {
    std::vector<std::string> targets;
    for (const auto& frame : frames)
      if (!frame.frame.target.empty()) targets.push_back(frame.frame.target);
    return is(find_object(scene, targets.at(q.arguments.at("nth").get<std::size_t>() - 1))->category == answer);
  }
  if (q.form == "in sight") {
    const auto& frame = frames.at(q.arguments.at("frame").get<std::size_t>());
    return is((frame.objects[index_of(scene, q.arguments.at("b"))].pixels > 0) == (answer == "yes"));
  }
  return "nothing is known of " + q.form;
}

}  // namespace

TEST_CASE("Every answer is what follows from scene and frames") {
  std::map<std::string, int> forms;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = random_scene(seed);
    const auto frames = random_frames(scene, seed);
    for (const auto& question : asked(scene, frames, seed)) {
      INFO("seed " << seed << ": " << to_json(question).dump());
      CHECK(wrong(scene, frames, question) == "");
      ++forms[question.form];
    }
  }
  for (const char* form : {"height", "length", "area", "distance", "gap", "room area", "count", "side", "behind", "order",
                           "first", "between", "carrier", "nearest", "kind", "in sight"}) {
    INFO(form);
    CHECK(forms[form] > 20);
  }
}

TEST_CASE("Choices are each there once, with the right one in any place") {
  std::map<std::size_t, std::map<std::size_t, int>> places;  // by number of choices
  std::set<std::string> ids;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = random_scene(seed);
    for (const auto& question : asked(scene, random_frames(scene, seed), seed)) {
      INFO(to_json(question).dump());
      CHECK(std::set(question.choices.begin(), question.choices.end()).size() == question.choices.size());
      CHECK(question.text.find('{') == std::string::npos);
      CHECK(std::is_sorted(question.objects.begin(), question.objects.end()));
      CHECK((question.form == "room area" || !question.objects.empty()));
      CHECK(!question.frames.empty());
      ids.insert(std::to_string(seed) + question.id);
      if (!question.choices.empty()) ++places[question.choices.size()][question.right];
    }
  }
  for (const auto& [count, right] : places) {
    int all = 0;
    for (const auto& [place, number] : right) all += number;
    const double share = 1.0 / static_cast<double>(count);
    // Five standard deviations.
    for (std::size_t place = 0; place < count; ++place)
      CHECK(std::abs(right.at(place) - share * all) < 5.0 * std::sqrt(all * share * (1 - share)) + 1);
  }
}

TEST_CASE("Who reads only the text is right by chance") {
  // Learns on one half which words of choices and questions go with right answers, and guesses the other half.
  std::vector<SpatialQuestion> all;
  for (std::uint64_t seed = 0; seed < 160; ++seed) {
    const Scene scene = random_scene(seed);
    for (auto& question : asked(scene, random_frames(scene, seed), seed))
      if (!question.choices.empty()) all.push_back(std::move(question));
  }
  std::map<std::string, std::pair<double, double>> known;  // right, offered
  const auto features = [](const SpatialQuestion& question, std::size_t choice) {
    return std::vector<std::string>{question.form + "|" + question.choices[choice],
                                    question.form + "|" + std::to_string(question.choices.size()) + "|" + std::to_string(choice),
                                    question.form + "|" + question.text.substr(0, 60) + "|" + question.choices[choice]};
  };
  double expected = 0.0, variance = 0.0, right = 0.0;
  std::map<std::string, std::pair<double, double>> by_form;  // right beyond chance, of so many
  for (std::size_t half = 0; half < 2; ++half)
    for (std::size_t k = half; k < all.size(); k += 2) {
      const auto& question = all[k];
      const std::size_t count = question.choices.size();
      std::size_t guess = 0;
      double best = -1e9;
      for (std::size_t choice = 0; choice < count; ++choice) {
        double score = 0.0;
        for (const auto& feature : features(question, choice)) {
          auto& [hits, offered] = known[feature];
          if (half == 0) hits += choice == question.right, offered += 1.0;
          score += std::log((hits + 1.0) / (offered + static_cast<double>(count)) * static_cast<double>(count));
        }
        if (score > best) best = score, guess = choice;
      }
      if (half == 0) continue;
      const double chance = 1.0 / static_cast<double>(count);
      by_form[question.form].first += (guess == question.right) - chance, by_form[question.form].second += 1;
      expected += chance, variance += chance * (1 - chance), right += guess == question.right;
    }
  std::string forms;
  for (const auto& [form, beyond] : by_form)
    forms += "\n" + form + ": " + std::to_string(beyond.first) + " beyond chance of " + std::to_string(beyond.second);
  INFO(forms);
  INFO(right << " right, " << expected << " by chance, deviation " << std::sqrt(variance) << " of " << all.size() / 2);
  CHECK(std::abs(right - expected) < 4.0 * std::sqrt(variance));
}

TEST_CASE("What is said of a thing holds of no other") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Scene scene = random_scene(seed);
    for (const auto& question : asked(scene, random_frames(scene, seed), seed)) {
      if (question.form != "height" || question.text.find("all of them") != std::string::npos) continue;
      const Object& a = named(scene, question, "a");
      const auto same_kind = std::count_if(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
        return KindTable::built_in().is_a(other.category, a.category);
      });
      const bool plain = question.text.find(" the " + a.category + " ") != std::string::npos &&
                         question.text.find("nearest") == std::string::npos && question.text.find(" on ") == std::string::npos &&
                         question.text.find("first") == std::string::npos;
      INFO(question.text);
      if (plain) CHECK(same_kind == 1);
    }
  }
}

TEST_CASE("Equal seeds ask equal questions, and files keep them") {
  const Scene scene = random_scene(5);
  const auto frames = random_frames(scene, 5);
  const auto once = asked(scene, frames, 3), again = asked(scene, frames, 3), other = asked(scene, frames, 4);
  std::string lines, lines_again, lines_other;
  for (const auto& question : once) lines += to_json(question).dump() + "\n";
  for (const auto& question : again) lines_again += to_json(question).dump() + "\n";
  for (const auto& question : other) lines_other += to_json(question).dump() + "\n";
  CHECK(lines == lines_again);
  CHECK(lines != lines_other);
  const TemporaryFolder folder;
  std::ofstream(folder / "questions.jsonl") << lines;
  const auto read = read_questions(folder / "questions.jsonl");
  REQUIRE(read);
  std::string lines_read;
  for (const auto& question : *read) lines_read += to_json(question).dump() + "\n";
  CHECK(lines_read == lines);
}

TEST_CASE("Frames of another scene and unknown tasks are refused") {
  const Scene scene = random_scene(1);
  auto frames = random_frames(scene, 1);
  QuestionOptions options;
  options.tasks = {"riddles"};
  CHECK(!make_questions(scene, {}, KindTable::built_in(), frames, options));
  CHECK(!make_questions(scene, {}, KindTable::built_in(), {}));
  frames[3].objects.pop_back();
  CHECK(!make_questions(scene, {}, KindTable::built_in(), frames));
  options.tasks = {"measurement"};
  const auto measured = make_questions(scene, {}, KindTable::built_in(), random_frames(scene, 1), options);
  REQUIRE(measured);
  for (const auto& question : *measured) CHECK(question.task == "measurement");
}

TEST_CASE("No two questions ask one thing") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = random_scene(seed);
    std::set<std::string> sides, between;
    for (const auto& question : asked(scene, random_frames(scene, seed), seed, 40)) {
      INFO(to_json(question).dump());
      const auto& arguments = question.arguments;
      if (question.form == "side") {
        const std::string b = arguments.at("b"), c = arguments.at("c"), a = arguments.at("a");
        CHECK(sides.insert(a + " " + std::min(b, c) + " " + std::max(b, c)).second);
      }
      if (question.form == "between")
        CHECK(between.insert(arguments.at("a").dump() + arguments.at("b").dump() + arguments.at("right").dump()).second);
    }
  }
}

TEST_CASE("What is left of somebody is left of each corner of where they stand") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = random_scene(seed);
    for (const auto& question : asked(scene, random_frames(scene, seed), seed, 40)) {
      if (question.form != "side") continue;
      INFO(to_json(question).dump());
      const Object& a = named(scene, question, "a");
      const Vec2 b = named(scene, question, "b").position.head<2>(), c = named(scene, question, "c").position.head<2>();
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
          const double cosine = std::cos(a.yaw), sine = std::sin(a.yaw), u = x * a.size.x(), v = y * a.size.y();
          const Vec2 from = a.position.head<2>() + Vec2(cosine * u - sine * v, sine * u + cosine * v);
          const Vec2 ahead = b - from, there = c - from;
          const bool left = ahead.x() * there.y() - ahead.y() * there.x() > 0;
          if (!round(a)) CHECK(left == (question.choices.at(question.right) == "on the left"));
        }
    }
  }
}

TEST_CASE("Nobody is asked how tall a hanging lamp is, nor what colour a mirror is") {
  Scene scene = random_scene(3);
  for (const char* kind : {"pendant lamp", "mirror"}) {
    auto object = rooms::thing(std::string(kind) + "-0", kind, {0.4, 0.4, 0.6}, {3, 3});
    object.mount = std::string(kind) == "mirror" ? Mount::wall : Mount::ceiling;
    object.position.z() = 1.8;
    scene.objects.push_back(object);
  }
  int others = 0;
  for (const auto& question : asked(scene, random_frames(scene, 3), 3, 40)) {
    if (question.form != "height" && question.form != "color") continue;
    const std::string id = named(scene, question, "a").id;
    CHECK((question.form != "height" || id != "pendant lamp-0"));
    CHECK((question.form != "color" || id != "mirror-0"));
    ++others;
  }
  CHECK(others > 3);
}

TEST_CASE("Counts are whole in files") {
  const Scene scene = random_scene(8);
  int counts = 0;
  for (const auto& question : asked(scene, random_frames(scene, 8), 8, 40))
    if (question.form == "count") {
      CHECK(to_json(question).at("answer").is_number_integer());
      ++counts;
    }
  CHECK(counts > 0);
}

TEST_CASE("Names in a set of questions stay in its folder, and levels are plain words") {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& complexity) {
    const std::string line = R"({"id": "q", "task": "count", "form": "f", "question": "how many?", "unit": "", "answer": 2, "tolerance": 0, "complexity": )" + complexity + "}";
    REQUIRE(write_file(folder / "questions.jsonl", line + "\n"));
    const auto read = read_questions(folder / "questions.jsonl");
    return read ? std::string() : read.error().message;
  };
  CHECK(told(R"({"folder": "scene-0/a", "relational": "very low_2"})").empty());
  for (const char* name : {"../a", "/etc", "a/../../b", "c:/a", "a\\\\b"})
    CHECK(told(std::string(R"({"folder": ")") + name + "\"}").find("/complexity/folder: leads outside the set") != std::string::npos);
  CHECK(told(R"({"relational": "<script>"})").find("/complexity/relational: a level has") != std::string::npos);
}
