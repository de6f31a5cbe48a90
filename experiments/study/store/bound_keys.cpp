#include "experiments/study/store/bound_keys.hpp"

#include "common/error.hpp"
#include "experiments/record/database_table.hpp"
#include "experiments/study/store/open_database.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

namespace evbal {
namespace {

Row bound_row(const BoundKey& key) {
  return {{"scenario", key.scenario},
          {"faults", key.faults},
          {"day", key.day},
          {"seed", std::to_string(key.seed)},
          {"bound", key.key}};
}

}  // namespace

void note_bound_keys(const std::filesystem::path& file, const std::vector<BoundKey>& keys) {
  SQLite::Database database = open_database(file);
  SQLite::Transaction transaction(database);
  database.exec("DROP TABLE IF EXISTS bound_keys");
  Table table(database, "bound_keys", bound_row({}));
  for (const BoundKey& key : keys) {
    table.add(bound_row(key));
  }
  transaction.commit();
}

std::vector<BoundKey> read_bound_keys(const std::filesystem::path& file) {
  try {
    const SQLite::Database database = open_database(file);
    SQLite::Statement rows(database, "SELECT scenario, faults, day, seed, bound FROM bound_keys");
    std::vector<BoundKey> keys;
    while (rows.executeStep()) {
      keys.push_back({.scenario = rows.getColumn(0).getString(),
                      .faults = rows.getColumn(1).getString(),
                      .day = rows.getColumn(2).getString(),
                      .seed = std::stoull(rows.getColumn(3).getString()),
                      .key = rows.getColumn(4).getString()});
    }
    return keys;
  } catch (const SQLite::Exception& error) {
    throw bad_input(file.string() + ": does not say which bounds its days have (" + error.what() +
                    "); play the sweep once more, which only adds what is missing");
  }
}

}  // namespace evbal
