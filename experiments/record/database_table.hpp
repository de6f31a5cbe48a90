#pragma once

#include "experiments/record/row.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>

namespace evbal {

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
