// Learns the roles of words in edits: train_edit_roles FOLDER SCENES EDITS... writes the models of the committee;
// train_edit_roles --test MODEL SCENES EDITS... says how many roles and deeds a model gets right, with --show which not.
#include <cstdio>
#include <exception>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "role_model.h"
#include "train/learn_roles.h"

namespace roomgen {

namespace {

std::vector<MarkedEdit> read_all(const std::vector<std::string>& files, const MarkedScenes& scenes) {
  std::vector<MarkedEdit> all;
  for (const auto& file : files)
    for (auto& edit : read_marked_edits(file, scenes)) all.push_back(std::move(edit));
  return all;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw std::runtime_error("cannot write " + path);
}

std::string with_roles(const EditText& text, const std::vector<EditRole>& roles) {
  std::string line;
  for (const auto& stretch : stretches_of(roles))
    line += "[" + text.words_from(stretch.begin, stretch.end) + "]" +
            std::string(edit_role_names[static_cast<std::size_t>(stretch.role)]) + " ";
  return line;
}

void test(const std::string& path, const std::vector<MarkedEdit>& edits, bool show) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const RoleModel model(bytes);
  const SumsOf<int> sums = [&](const Features& features) { return model.sums(features); };
  std::size_t right = 0, words = 0, whole = 0, deeds_right = 0, deeds = 0;
  for (const auto& edit : edits) {
    const auto said = best_roles<int>(edit.text, edit.signs, sums);
    for (std::size_t i = 0; i < said.size(); ++i) right += said[i] == edit.roles[i];
    words += said.size();
    whole += said == edit.roles;
    if (show && said != edit.roles)
      std::printf("%s\n  %s\n", with_roles(edit.text, edit.roles).c_str(), with_roles(edit.text, said).c_str());
    for (const auto& order : edit.orders) {
      const auto all = model.sums(deed_features(edit.text, edit.signs, order.order, order.previous));
      const auto best = std::max_element(all.begin() + first_deed, all.begin() + first_place) - all.begin() - first_deed;
      const bool is_right = best == static_cast<std::ptrdiff_t>(order.deed);
      deeds_right += is_right;
      ++deeds;
      if (show && !is_right)
        std::printf("%s: %s, said %s\n", with_roles(edit.text, edit.roles).c_str(),
                    std::string(deed_names[static_cast<std::size_t>(order.deed)]).c_str(),
                    std::string(deed_names[static_cast<std::size_t>(best)]).c_str());
    }
  }
  std::printf("roles: %zu of %zu words right, %zu of %zu sentences wholly; deeds: %zu of %zu\n", right, words, whole,
              edits.size(), deeds_right, deeds);
}

int run(std::vector<std::string> arguments) {
  const auto take = [&](const char* flag) { return std::erase(arguments, flag) > 0; };
  const bool is_test = take("--test"), show = take("--show");
  if (arguments.size() < 3) {
    std::fprintf(stderr, "usage: train_edit_roles [--test [--show]] MODEL SCENES EDITS...\n");
    return 2;
  }
  const auto scenes = read_marked_scenes(arguments[1]);
  const auto edits = read_all({arguments.begin() + 2, arguments.end()}, scenes);
  if (is_test) test(arguments[0], edits, show);
  for (std::size_t member = 0; !is_test && member < role_model_count; ++member)
    write(arguments[0] + "/edit-roles-" + std::to_string(member) + ".bin", learn_roles(lesson_of(edits, member)));
  return 0;
}

}  // namespace

}  // namespace roomgen

int main(int argc, char** argv) {
  try {
    return roomgen::run({argv + 1, argv + argc});
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "train_edit_roles: %s\n", problem.what());
    return 1;
  }
}
