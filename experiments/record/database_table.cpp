#include "experiments/record/database_table.hpp"

#include <sqlite3.h>

#include <array>
#include <system_error>

namespace evbal {

Error cannot_write(const SQLite::Database& database, const SQLite::Exception& error) {
  const int reason = sqlite3_system_errno(database.getHandle());
  const std::string system = reason == 0 ? "" : " (" + std::generic_category().message(reason) + ")";
  return run_failed(database.getFilename() + ": cannot be written: " + error.what() + system);
}

Table::Table(SQLite::Database& database, const std::string& name, const Row& like) {
  std::string columns;
  std::string names;
  std::string places;
  for (const auto& cell : like) {
    static constexpr std::array types = {"INTEGER", "REAL", "TEXT"};
    const std::string quoted = '"' + cell.name + '"';
    columns += (columns.empty() ? "" : ", ") + quoted + " " + types.at(cell.value.index());
    names += (names.empty() ? "" : ", ") + quoted;
    places += places.empty() ? "?" : ", ?";
  }
  database.exec("CREATE TABLE IF NOT EXISTS " + name + " (" + columns + ")");
  insert_.emplace(database, "INSERT INTO " + name + " (" + names + ") VALUES (" + places + ")");
}

void Table::add(const Row& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    std::visit([&](const auto& value) { insert_->bind(static_cast<int>(i) + 1, value); }, row[i].value);
  }
  insert_->exec();
  insert_->reset();
}

}  // namespace evbal
