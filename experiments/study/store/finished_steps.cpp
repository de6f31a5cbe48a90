#include "experiments/study/store/finished_steps.hpp"

#include "common/error.hpp"
#include "experiments/study/store/open_database.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

namespace evbal {

std::vector<FinishedSteps> read_finished_steps(const std::filesystem::path& file,
                                               const std::vector<std::string>& columns) {
  std::string names;
  for (const auto& column : columns) {
    names += ", " + column;
  }
  try {
    const SQLite::Database database = open_database(file);
    SQLite::Statement row(database,
                          "SELECT run, start" + names + " FROM days JOIN steps USING (key) ORDER BY run, step");
    std::vector<FinishedSteps> days;
    for (int run = 0; row.executeStep();) {
      if (row.getColumn(0).getInt() != run) {
        run = row.getColumn(0).getInt();
        days.emplace_back();
      }
      days.back().starts.push_back(row.getColumn(1).getString());
      for (std::size_t i = 0; i < columns.size(); ++i) {
        days.back().columns[columns[i]].push_back(row.getColumn(static_cast<int>(i) + 2).getDouble());
      }
    }
    return days;
  } catch (const SQLite::Exception& error) {
    throw bad_input(file.string() + ": is no sweep of this version of evbal (" + error.what() + ")");
  }
}

}  // namespace evbal
