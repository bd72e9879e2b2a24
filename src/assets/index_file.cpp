#include "index_file.h"

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::assets {

namespace {

// texts repeats what people search by; its rowid is that of assets. The porter tokenizer makes
// "wooden drawers" find "wood drawer".
constexpr const char* schema = R"sql(
  PRAGMA journal_mode = OFF;
  PRAGMA synchronous = OFF;
  BEGIN;
  CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT);
  CREATE TABLE assets (
    id INTEGER PRIMARY KEY, library TEXT, asset TEXT, name TEXT, category TEXT, tags TEXT,
    grp TEXT, width REAL, depth REAL, height REAL, mount TEXT, elevation REAL, support REAL,
    front INTEGER, round INTEGER, colors TEXT, triangles INTEGER, sha256 TEXT, license TEXT,
    creator TEXT, mesh TEXT, frame TEXT, wall_fit TEXT);
  CREATE TABLE left_out (mesh TEXT, reason TEXT, sha256 TEXT, too_much INTEGER);
  CREATE VIRTUAL TABLE texts USING fts5(name, tags, category, grp, words, looks,
                                        tokenize = 'porter unicode61');
)sql";

constexpr const char* finish = R"sql(
  CREATE UNIQUE INDEX assets_by_asset ON assets (asset);
  CREATE INDEX assets_by_category ON assets (category);
  COMMIT;
)sql";

std::string json_text(const std::vector<std::string>& texts) {
  return Json(texts).dump();
}

std::vector<std::string> texts_of(const std::string& json) {
  const auto value = parse_json(json, "catalogue");
  std::vector<std::string> result;
  if (value && value->is_array())
    for (const auto& text : *value)
      if (text.is_string()) result.push_back(text.get<std::string>());
  return result;
}

std::string matrix_text(const Eigen::Matrix3d& matrix) {
  Json values = Json::array();
  for (int i = 0; i < 9; ++i) values.push_back(matrix(i / 3, i % 3));
  return values.dump();
}

Eigen::Matrix3d matrix_of(const std::string& json) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  const auto value = parse_json(json, "catalogue");
  if (value && value->is_array() && value->size() == 9)
    for (std::size_t i = 0; i < 9; ++i)
      if ((*value)[i].is_number())
        matrix(static_cast<int>(i / 3), static_cast<int>(i % 3)) = (*value)[i].get<double>();
  return matrix;
}

std::string wall_fit_text(const std::optional<WallFit>& fit) {
  if (!fit) return {};
  Json json = {{"front", fit->wall_front},
               {"back", fit->wall_back},
               {"leaves", fit->leaves},
               {"hinge_left", fit->hinge_left},
               {"outline", Json::array()}};
  for (const auto& p : fit->outline) json["outline"].push_back({p.x(), p.y()});
  return json.dump();
}

std::optional<WallFit> wall_fit_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto value = parse_json(text, "catalogue");
  if (!value) return std::nullopt;
  JsonReader::Problems problems("catalogue");
  const JsonReader json(*value, problems);
  WallFit fit;
  fit.wall_front = json["front"].number(0, 100);
  fit.wall_back = json["back"].number(0, 100);
  fit.leaves = static_cast<int>(json["leaves"].integer_or(0, 0, 20));
  fit.hinge_left = json["hinge_left"].boolean_or(false);
  for (const auto& element : json["outline"].elements_or_none()) {
    const auto p = element.numbers(2, 0, 1);
    fit.outline.emplace_back(p[0], p[1]);
  }
  return problems.first() ? std::nullopt : std::optional(fit);
}

// "leather_sofa2" and "bathroomRadiator" hold words.
std::string id_words(const std::string& id) {
  std::string spaced;
  char previous = ' ';
  const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
  for (const char c : id) {
    const bool begins_word = (c >= 'A' && c <= 'Z' && is_lower(previous)) ||
                             (c >= '0' && c <= '9' && is_lower(previous));
    if (begins_word) spaced += ' ';
    spaced += c;
    previous = c;
  }
  return join(words(spaced), " ");
}

void insert_asset(Statement& insert, long long number, const IndexedAsset& asset) {
  const AssetInfo& info = asset.info;
  insert.bind(1, number)
      .bind(2, info.ref.library)
      .bind(3, info.ref.id)
      .bind(4, info.name)
      .bind(5, info.category)
      .bind(6, json_text(info.tags))
      .bind(7, info.group)
      .bind(8, info.size.x())
      .bind(9, info.size.y())
      .bind(10, info.size.z())
      .bind(11, name(info.mount))
      .bind(12, info.elevation)
      .bind(13, info.support_height)
      .bind(14, static_cast<long long>(info.has_front))
      .bind(15, static_cast<long long>(info.round))
      .bind(16, json_text(info.colors))
      .bind(17, static_cast<long long>(info.triangles))
      .bind(18, info.ref.sha256)
      .bind(19, info.ref.license)
      .bind(20, info.ref.creator)
      .bind(21, asset.mesh)
      .bind(22, matrix_text(asset.ours_from_source))
      .bind(23, wall_fit_text(info.wall_fit));
  insert.run();
}

void insert_texts(Statement& insert, long long number, const IndexedAsset& asset) {
  const AssetInfo& info = asset.info;
  insert.bind(1, number)
      .bind(2, info.name)
      .bind(3, join(info.tags, " "))
      .bind(4, info.category)
      .bind(5, info.group)
      .bind(6, id_words(info.ref.id))
      .bind(7, asset.looks);
  insert.run();
}

}  // namespace

const char* const row_columns =
    "library, asset, name, category, tags, grp, width, depth, height, mount, elevation, support, "
    "front, round, colors, triangles, sha256, license, creator, mesh, frame, wall_fit";

IndexedAsset row_of(const Statement& row) {
  IndexedAsset asset;
  AssetInfo& info = asset.info;
  info.ref.library = row.text(0);
  info.ref.id = row.text(1);
  info.name = row.text(2);
  info.category = row.text(3);
  info.tags = texts_of(row.text(4));
  info.group = row.text(5);
  info.size = Vec3(row.number(6), row.number(7), row.number(8));
  info.mount = parse_mount(row.text(9)).value_or(Mount::floor);
  info.elevation = row.number(10);
  if (!row.is_null(11)) info.support_height = row.number(11);
  info.has_front = row.integer(12) != 0;
  info.round = row.integer(13) != 0;
  info.colors = texts_of(row.text(14));
  info.triangles = static_cast<std::size_t>(row.integer(15));
  info.ref.sha256 = row.text(16);
  info.ref.license = row.text(17);
  info.ref.creator = row.text(18);
  asset.mesh = row.text(19);
  asset.ours_from_source = matrix_of(row.text(20));
  info.wall_fit = wall_fit_of(row.text(21));
  return asset;
}

Status write_index(const std::filesystem::path& path, const std::string& stamp,
                   const std::vector<IndexedAsset>& assets, const std::vector<LeftOutMesh>& left_out) {
  auto database = Database::create(path);
  if (!database) return database.error();
  if (auto status = database->run(schema); !status) return status;
  Statement meta = database->prepare("INSERT INTO meta VALUES ('stamp', ?)");
  meta.bind(1, stamp).run();
  Statement rows = database->prepare(
      "INSERT INTO assets VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  Statement texts = database->prepare(
      "INSERT INTO texts (rowid, name, tags, category, grp, words, looks) VALUES (?,?,?,?,?,?,?)");
  long long number = 0;
  for (const auto& asset : assets) {
    insert_asset(rows, ++number, asset);
    insert_texts(texts, number, asset);
  }
  Statement others = database->prepare("INSERT INTO left_out VALUES (?,?,?,?)");
  for (const auto& mesh : left_out)
    others.bind(1, mesh.mesh)
        .bind(2, mesh.reason)
        .bind(3, mesh.sha256)
        .bind(4, static_cast<long long>(mesh.too_much))
        .run();
  for (const auto& status : {meta.status(), rows.status(), texts.status(), others.status()})
    if (!status) return status;
  return database->run(finish);
}

Result<std::vector<LeftOutMesh>> read_left_out(const Database& database, const std::string& library) {
  Statement rows = database.prepare("SELECT mesh, reason, sha256, too_much FROM left_out ORDER BY mesh");
  std::vector<LeftOutMesh> result;
  while (rows.step())
    result.push_back({library, rows.text(0), rows.text(1), rows.text(2), rows.integer(3) != 0});
  if (auto status = rows.status(); !status) return status.error();
  return result;
}

std::string read_stamp(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::exists(path, code)) return {};
  const auto database = Database::open_read_only(path);
  if (!database) return {};
  Statement statement = database->prepare("SELECT value FROM meta WHERE key = 'stamp'");
  return statement.step() ? statement.text(0) : std::string();
}

}  // namespace roomgen::assets
