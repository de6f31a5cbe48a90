#include "experiments/study/store/sweep_origin.hpp"

#include "common/error.hpp"
#include "experiments/record/database_table.hpp"
#include "experiments/study/store/open_database.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

namespace evbal {

void note_origin(const std::filesystem::path& file, const SweepOrigin& origin) {
  SQLite::Database database = open_database(file);
  SQLite::Transaction transaction(database);
  database.exec("DROP TABLE IF EXISTS origin");
  const Row row = {
      {"command", origin.command}, {"file", origin.file}, {"text", origin.text}, {"scenario", origin.scenario}};
  Table(database, "origin", row).add(row);
  transaction.commit();
}

SweepOrigin read_origin(const std::filesystem::path& file) {
  try {
    const SQLite::Database database = open_database(file);
    SQLite::Statement row(database, "SELECT command, file, text, scenario FROM origin");
    row.executeStep();
    return {.command = row.getColumn(0).getString(),
            .file = row.getColumn(1).getString(),
            .text = row.getColumn(2).getString(),
            .scenario = row.getColumn(3).getString()};
  } catch (const SQLite::Exception& error) {
    throw bad_input(file.string() + ": does not say what it was made from (" + error.what() +
                    "); play the sweep once more, which only adds what is missing");
  }
}

}  // namespace evbal
