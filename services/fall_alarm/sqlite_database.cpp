// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/sqlite_database.hpp"

#include <sqlite3.h>

namespace fallen {
namespace {

constexpr int kBusyTimeout_ms = 5000;  // a tool may be reading

void RequireSound(sqlite3* database, const std::string& file) {
  SqliteStatement check(database, "PRAGMA quick_check(1)");
  if (check.Step() && check.Text(0) == "ok") return;
  throw DamagedDatabase(file + ": damaged: " + check.Text(0));
}

[[noreturn]] void Throw(sqlite3* database) {
  const char* file = sqlite3_db_filename(database, "main");
  const std::string text = (file && *file ? std::string(file) : std::string("history")) + ": " +
                           sqlite3_errmsg(database);
  const int code = sqlite3_errcode(database);
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT) throw DamagedDatabase(text);
  throw std::runtime_error(text);
}

}  // namespace

SqliteStatement::SqliteStatement(sqlite3* database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database, sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK)
    Throw(database);
}

SqliteStatement::~SqliteStatement() { sqlite3_finalize(statement_); }

SqliteStatement& SqliteStatement::Bind(int index, std::int64_t value) {
  if (sqlite3_bind_int64(statement_, index, value) != SQLITE_OK) Throw(database_);
  return *this;
}

SqliteStatement& SqliteStatement::Bind(int index, const std::string& text) {
  if (sqlite3_bind_text(statement_, index, text.data(), static_cast<int>(text.size()),
                        SQLITE_TRANSIENT) != SQLITE_OK)
    Throw(database_);
  return *this;
}

SqliteStatement& SqliteStatement::Bind(int index, std::span<const std::uint8_t> bytes) {
  if (sqlite3_bind_blob64(statement_, index, bytes.data(), bytes.size(), SQLITE_TRANSIENT) !=
      SQLITE_OK)
    Throw(database_);
  return *this;
}

bool SqliteStatement::Step() {
  const int status = sqlite3_step(statement_);
  if (status != SQLITE_ROW && status != SQLITE_DONE) Throw(database_);
  return status == SQLITE_ROW;
}

std::int64_t SqliteStatement::Int(int column) const {
  return sqlite3_column_int64(statement_, column);
}

std::string SqliteStatement::Text(int column) const {
  const auto* text = sqlite3_column_text(statement_, column);
  return text ? reinterpret_cast<const char*>(text) : "";
}

std::vector<std::uint8_t> SqliteStatement::Bytes(int column) const {
  const auto* bytes = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
  return {bytes, bytes + sqlite3_column_bytes(statement_, column)};
}

SqliteDatabase::SqliteDatabase(const std::filesystem::path& file) {
  const int status = sqlite3_open(file.c_str(), &handle_);
  try {
    if (status != SQLITE_OK)
      throw std::runtime_error(file.string() + ": " + sqlite3_errstr(status) +
                               ", expected a file that can be written");
    sqlite3_busy_timeout(handle_, kBusyTimeout_ms);
    RequireSound(handle_, file.string());
    // FULL: in WAL mode each commit is synced, so that power loss takes no commit back.
    Run("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
  } catch (...) {
    sqlite3_close(handle_);
    throw;
  }
}

SqliteDatabase::~SqliteDatabase() { sqlite3_close(handle_); }

void SqliteDatabase::Run(const std::string& sql) const {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) Throw(handle_);
}

std::optional<std::int64_t> SqliteDatabase::Number(const std::string& sql) const {
  SqliteStatement statement(handle_, sql);
  if (!statement.Step()) return std::nullopt;
  return statement.Int(0);
}

SqliteTransaction::SqliteTransaction(SqliteDatabase& database) : database_(database) {
  database_.Run("BEGIN IMMEDIATE");
}

SqliteTransaction::~SqliteTransaction() {
  if (!is_open_) return;
  sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void SqliteTransaction::Commit() {
  database_.Run("COMMIT");
  is_open_ = false;
}

}  // namespace fallen
