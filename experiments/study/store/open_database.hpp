#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

namespace evbal {

/// Opens a database, also one that is only to be read: what a process that was killed left half written is taken back
/// on the way, and for that SQLite has to be allowed to write. Waits up to a minute for another process that writes.
/// `more` flags: SQLite::OPEN_CREATE makes a file that is missing. Throws SQLite's exception.
inline SQLite::Database open_database(const std::filesystem::path& file, int more = 0) {
  constexpr int longest_wait_ms = 60'000;
  return SQLite::Database(file.string(), SQLite::OPEN_READWRITE | more, longest_wait_ms);
}

/// Whether nothing stands in it, as in one whose maker was killed before it had written.
inline bool is_blank(const SQLite::Database& database) {
  return !SQLite::Statement(database, "SELECT 1 FROM sqlite_master").executeStep();
}

}  // namespace evbal
