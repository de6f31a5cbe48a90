#pragma once

#include "common/error.hpp"
#include "experiments/record/row.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>

namespace evbal {

/// Error{run_failed} of a database that cannot be written, with the system's reason if there is one.
Error cannot_write(const SQLite::Database& database, const SQLite::Exception& error);

/// A table of a database, to which rows are added.
class Table {
 public:
  /// Made if it is missing; `like` gives the columns' names and types.
  Table(SQLite::Database& database, const std::string& name, const Row& like);

  /// `row` has the columns of `like`.
  void add(const Row& row);

 private:
  std::optional<SQLite::Statement> insert_;
};

}  // namespace evbal
