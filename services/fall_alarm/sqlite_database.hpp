// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace fallen {

/// A file that is no database, or whose content contradicts itself.
struct DamagedDatabase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A prepared statement; binds from 1, reads columns from 0. Errors are std::runtime_error.
class SqliteStatement {
 public:
  SqliteStatement(sqlite3* database, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  SqliteStatement& Bind(int index, std::int64_t value);
  SqliteStatement& Bind(int index, const std::string& text);
  SqliteStatement& Bind(int index, std::span<const std::uint8_t> bytes);

  /// Next row. @return false at the end.
  bool Step();
  std::int64_t Int(int column) const;
  std::string Text(int column) const;
  std::vector<std::uint8_t> Bytes(int column) const;

 private:
  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// An SQLite database that is on disk when a transaction has ended, power loss or not.
class SqliteDatabase {
 public:
  /// Opens, or makes, and checks the whole file. ":memory:" keeps all in memory.
  /// @throws DamagedDatabase or std::runtime_error "<file>: <what is wrong with it>".
  explicit SqliteDatabase(const std::filesystem::path& file);
  ~SqliteDatabase();
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  sqlite3* handle() const { return handle_; }
  /// Statements without a result, separated by ';'.
  void Run(const std::string& sql) const;
  /// First column of the first row; nothing without a row.
  std::optional<std::int64_t> Number(const std::string& sql) const;

 private:
  sqlite3* handle_ = nullptr;
};

/// Commits when told, else takes back when it goes.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;
  void Commit();

 private:
  SqliteDatabase& database_;
  bool is_open_ = true;
};

}  // namespace fallen
