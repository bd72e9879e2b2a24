#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "add_commands.h"
#include "libraries.h"
#include "options.h"
#ifdef ROOMGEN_HAS_RENDER
#include "portrait.h"
#endif
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/geometry/model.h"

namespace roomgen::cli {

namespace {

struct AssetsOptions {
  LibraryOptions libraries;
  std::string category;
  std::string text;
  std::vector<double> size;
  std::string mount;
  std::size_t limit = 10;
  std::string asset;
  std::string picture;
  bool rebuild = false;
  bool strict = false;
};

Json to_json(const AssetInfo& info) {
  Json json;
  json["library"] = info.ref.library;
  json["id"] = info.ref.id;
  json["name"] = info.name;
  json["category"] = info.category;
  json["tags"] = info.tags;
  json["group"] = info.group;
  json["size"] = {rounded(info.size.x()), rounded(info.size.y()), rounded(info.size.z())};
  json["mount"] = std::string(name(info.mount));
  json["elevation"] = rounded(info.elevation);
  json["support_height"] =
      info.support_height ? Json(rounded(*info.support_height)) : Json(nullptr);
  json["front"] = info.has_front;
  json["round"] = info.round;
  json["colors"] = info.colors;
  json["triangles"] = info.triangles;
  json["sha256"] = info.ref.sha256;
  json["license"] = info.ref.license;
  json["creator"] = info.ref.creator;
  return json;
}

std::string key(const AssetInfo& info) {
  return info.ref.library + "/" + info.ref.id;
}

void print_table(const std::vector<AssetMatch>& matches) {
  std::printf("%5s  %-40s %-24s %-20s %-8s %s\n", "score", "asset", "category", "size (m)", "mount",
              "colours");
  for (const auto& match : matches) {
    const AssetInfo& info = match.asset;
    std::printf("%5.2f  %-40s %-24s %-20s %-8s %s\n", match.score, printable(key(info)).c_str(),
                printable(info.category).c_str(), size_text(info.size).c_str(),
                std::string(name(info.mount)).c_str(), join(info.colors, ", ").c_str());
  }
}

Result<AssetQuery> query_of(const AssetsOptions& options) {
  AssetQuery query;
  query.category = options.category;
  query.description = options.text;
  query.limit = options.limit;
  if (!options.size.empty()) {
    query.size = Vec3(options.size[0], options.size[1], options.size[2]);
    if (!(query.size->minCoeff() > 0.0))
      return Error{Error::Kind::invalid_input, "--size wants three lengths above 0, in metres"};
  }
  if (!options.mount.empty()) query.mount = parse_mount(options.mount);
  return query;
}

Result<int> search(const AssetsOptions& options, const Context& context) {
  const auto query = query_of(options);
  if (!query) return query.error();
  auto catalogue = open_libraries(options.libraries, context);
  if (!catalogue) return catalogue.error();
  const auto matches = (*catalogue)->search(*query);
  if (!matches) return matches.error();
  if (context.json) {
    Json list = Json::array();
    for (const auto& match : *matches) {
      list.push_back(to_json(match.asset));
      list.back()["score"] = rounded(match.score);
    }
    std::fputs(dump_json(list).c_str(), stdout);
  } else if (matches->empty()) {
    std::puts("Nothing fits.");
  } else {
    print_table(*matches);
  }
  return exit_ok;
}

void print_fields(const AssetInfo& info) {
  const auto line = [](const char* label, const std::string& text) {
    if (!text.empty()) std::printf("%-15s %s\n", label, printable(text).c_str());
  };
  line("asset", key(info));
  line("name", info.name);
  line("category", info.category);
  line("tags", join(info.tags, ", "));
  line("group", info.group);
  line("size", size_text(info.size) + " m (width, depth, height)");
  line("mount", std::string(name(info.mount)));
  line("elevation", format_number(info.elevation) + " m");
  line("support height", info.support_height ? format_number(*info.support_height) + " m" : "none");
  line("front", info.has_front ? "yes" : "no");
  line("round", info.round ? "yes" : "no");
  line("colours", join(info.colors, ", "));
  line("triangles", std::to_string(info.triangles));
  line("licence", info.ref.license);
  line("creator", info.ref.creator);
  line("sha256", info.ref.sha256);
}

Result<int> show(const AssetsOptions& options, const Context& context) {
  auto catalogue = open_libraries(options.libraries, context);
  if (!catalogue) return catalogue.error();
  const auto info = (*catalogue)->find(options.asset);
  if (!info) return info.error();
  const auto model = (*catalogue)->load(info->ref);
  if (!model) return model.error();
#ifdef ROOMGEN_HAS_RENDER
  if (!options.picture.empty())
    if (auto status = write_portrait(*info, *model, 512, options.picture); !status)
      return status.error();
#endif
  if (context.json) {
    std::fputs(dump_json(to_json(*info)).c_str(), stdout);
    return exit_ok;
  }
  print_fields(*info);
  for (const auto& part : (*model)->parts) {
    const Material& material = (*model)->materials[static_cast<std::size_t>(part.material)];
    std::printf("%-15s %s, %zu triangles%s\n", "part", printable(material.name).c_str(),
                part.mesh.triangles.size(), material.texture ? ", textured" : "");
  }
  return exit_ok;
}

Result<int> index(const AssetsOptions& options, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  auto libraries = options.libraries;
  libraries.rebuild = options.rebuild;
  libraries.verbose = true;
  auto catalogue = open_libraries(libraries, context);
  if (!catalogue) return catalogue.error();
  const auto all = (*catalogue)->all();
  if (!all) return all.error();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (context.json)
    std::fputs(
        dump_json(Json{{"assets", all->size()}, {"seconds", rounded(elapsed.count(), 3)}}).c_str(),
        stdout);
  else
    std::printf("%zu assets, %.2f s\n", all->size(), elapsed.count());
  return exit_ok;
}

Json to_json(const assets::LeftOutMesh& mesh) {
  return {{"library", mesh.library}, {"mesh", mesh.mesh}, {"reason", mesh.reason}, {"sha256", mesh.sha256},
          {"too_much", mesh.too_much}};
}

// Fails with --strict if a mesh was left out, so that scripts can ask.
Result<int> check(const AssetsOptions& options, const Context& context) {
  auto catalogue = open_libraries(options.libraries, context);
  if (!catalogue) return catalogue.error();
  const auto left_out = (*catalogue)->left_out();
  const auto all = (*catalogue)->all();
  if (!left_out) return left_out.error();
  if (!all) return all.error();
  if (context.json) {
    Json list = Json::array();
    for (const auto& mesh : *left_out) list.push_back(to_json(mesh));
    std::fputs(dump_json(Json{{"assets", all->size()}, {"left_out", list}}).c_str(), stdout);
  } else {
    for (const auto& mesh : *left_out)
      std::printf("%s: %s\n", printable(mesh.library).c_str(), printable(mesh.reason).c_str());
    std::printf("%zu assets can be used, %zu meshes cannot\n", all->size(), left_out->size());
  }
  return options.strict && !left_out->empty() ? exit_failure : exit_ok;
}

}  // namespace

void add_assets_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<AssetsOptions>();
  CLI::App* command = app.add_subcommand("assets", "Look into the furniture libraries");
  command->require_subcommand(1);
  command->fallthrough();
  add_library_options(*command, options->libraries);

  CLI::App* make = command->add_subcommand("index", "Read the libraries into the catalogue");
  make->add_flag("--rebuild", options->rebuild, "Even if nothing changed");
  make->callback(
      [=, &context] { context.run = [=, &context] { return index(*options, context); }; });

  CLI::App* find =
      command->add_subcommand("search", "Find furniture: assets search \"white desk\"");
  find->add_option("description", options->text, "What it is and looks like")->required();
  find->add_option("--category", options->category, "What it is, if the description does not say");
  find->add_option("--size", options->size, "Wanted width, depth and height in metres")
      ->expected(3);
  find->add_option("--mount", options->mount, "How it is put up")
      ->check(CLI::IsMember({"floor", "wall", "ceiling", "surface"}));
  find->add_option("--limit", options->limit, "At most so many answers")->capture_default_str();
  find->callback(
      [=, &context] { context.run = [=, &context] { return search(*options, context); }; });

  CLI::App* whole = command->add_subcommand("check", "Which meshes cannot be used, and why");
  whole->add_flag("--strict", options->strict, "Exit code 1 if there are any");
  whole->callback(
      [=, &context] { context.run = [=, &context] { return check(*options, context); }; });

  CLI::App* one = command->add_subcommand("show", "All that is known about an asset");
  one->add_option("asset", options->asset, "Library/id, or the id alone")->required();
#ifdef ROOMGEN_HAS_RENDER
  one->add_option("-o,--picture", options->picture, "Also draw it, into this PNG file");
#endif
  one->callback([=, &context] { context.run = [=, &context] { return show(*options, context); }; });
}

}  // namespace roomgen::cli
