#include "experiments/record/compare_days.hpp"

#include "common/decimal.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <vector>

namespace evbal {
namespace {

struct Difference {
  std::int64_t tick = 0;
  std::string what;
};

std::vector<std::string> tables_of(SQLite::Database& database) {
  SQLite::Statement query(database, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
  std::vector<std::string> names;
  while (query.executeStep()) {
    names.push_back(query.getColumn(0).getString());
  }
  return names;
}

std::string shown(const SQLite::Column& column) {
  return column.isFloat() ? decimal(column.getDouble()) : column.isNull() ? "null" : column.getString();
}

/// A row by its columns' names, as text, in the order of the table; empty after the last row.
using NamedRow = std::vector<std::pair<std::string, std::string>>;

NamedRow next_row(SQLite::Statement& query) {
  NamedRow row;
  if (query.executeStep()) {
    for (int i = 0; i < query.getColumnCount(); ++i) {
      const SQLite::Column column = query.getColumn(i);
      const std::string name = column.getName();
      if (!name.starts_with("origin_")) {
        row.emplace_back(name, shown(column));
      }
    }
  }
  return row;
}

std::string value_of(const NamedRow& row, const std::string& name) {
  for (const auto& [column, value] : row) {
    if (column == name) {
      return value;
    }
  }
  return "";
}

Difference described(const std::string& table, const NamedRow& place, const std::string& what) {
  const std::string tick = value_of(place, "tick");
  std::string region = value_of(place, "region");
  if (region.empty()) {
    region = value_of(place, "from_region");
  }
  std::string text = "run.sqlite: " + table;
  text += tick.empty() ? "" : ", tick " + tick;
  text += region.empty() ? ", all regions" : ", region " + region;
  // The place may be the altered row's, whose tick need not be a number any more.
  const bool counted = !tick.empty() && tick.find_first_not_of("0123456789") == std::string::npos;
  return {counted ? std::stoll(tick) : -1, text + ": " + what};
}

std::optional<Difference> compare_rows(const std::string& table, const NamedRow& was, const NamedRow& is) {
  if (was == is) {
    return std::nullopt;
  }
  if (was.empty() || is.empty()) {
    return described(table, was.empty() ? is : was, was.empty() ? "a row is missing" : "the replay has no such row");
  }
  for (const auto& [name, value] : is) {
    const std::string said = value_of(was, name);
    if (said != value) {
      return described(table, is, disagreement(name, "`" + said + "`", "`" + value + "`"));
    }
  }
  return described(table, is, "the columns are not the same");
}

std::optional<Difference> compare_tables(SQLite::Database& recorded, SQLite::Database& replayed,
                                         const std::string& table) {
  const std::string incidents =
      table == "events"
          ? " WHERE kind NOT LIKE 'process %' AND kind NOT IN ('sample refused', 'stranger kept out', 'host gone')"
          : "";
  const std::string query = "SELECT * FROM \"" + table + "\"" + incidents + " ORDER BY rowid";
  SQLite::Statement was(recorded, query);
  SQLite::Statement is(replayed, query);
  while (true) {
    const NamedRow was_row = next_row(was);
    const NamedRow is_row = next_row(is);
    if (auto difference = compare_rows(table, was_row, is_row)) {
      return difference;
    }
    if (is_row.empty()) {
      return std::nullopt;
    }
  }
}

}  // namespace

std::string disagreement(const std::string& name, const std::string& recorded, const std::string& replayed) {
  return name + " is " + recorded + ", the replay gives " + replayed;
}

std::optional<std::string> compare_days(const std::filesystem::path& recorded, const std::filesystem::path& replayed) {
  try {
    SQLite::Database was(recorded.string());
    SQLite::Database is(replayed.string());
    const auto tables = tables_of(is);
    if (tables_of(was) != tables) {
      return "run.sqlite: does not have the tables of a run";
    }
    std::optional<Difference> first;
    for (const auto& table : tables) {
      const auto found = compare_tables(was, is, table);
      if (found && (!first || found->tick < first->tick)) {
        first = found;
      }
    }
    return first ? std::optional(first->what) : std::nullopt;
  } catch (const SQLite::Exception& error) {
    return std::string("run.sqlite: cannot be read: ") + error.what();
  }
}

}  // namespace evbal
