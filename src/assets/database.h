#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "roomgen/base/result.h"

namespace roomgen::assets {

/// A prepared SQLite statement. The first failure is kept and told by status(); after it step()
/// answers false.
class Statement {
 public:
  Statement(sqlite3* database, const std::string& sql);

  Statement& bind(int index, std::string_view text);
  Statement& bind(int index, double value);
  Statement& bind(int index, long long value);
  Statement& bind(int index, const std::optional<double>& value);
  /// True while there is a row.
  bool step();
  /// Runs to the end, ready for new values.
  void run();

  std::string text(int column) const;
  double number(int column) const;
  long long integer(int column) const;
  bool is_null(int column) const;

  Status status() const;

 private:
  void check(int code);

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::string problem_;
};

/// An open SQLite file; used by one thread at a time.
class Database {
 public:
  static Result<Database> create(const std::filesystem::path& path);
  static Result<Database> open_read_only(const std::filesystem::path& path);

  Status run(const std::string& sql);
  Statement prepare(const std::string& sql) const { return Statement(handle_.get(), sql); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close(handle); }
  };
  explicit Database(sqlite3* handle) : handle_(handle) {}
  static Result<Database> open(const std::filesystem::path& path, int flags);

  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace roomgen::assets
