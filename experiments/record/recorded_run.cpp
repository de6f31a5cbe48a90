#include "experiments/record/recorded_run.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

constexpr int most_sensors = 8;

void read_summary(const fs::path& file, RecordedRun& run) {
  const auto json = nlohmann::ordered_json::parse(text_of_file(file));
  const auto& solver = json.at("solver");
  run.scenario = json.at("scenario");
  run.date = json.at("date");
  run.seed = json.at("seed");
  run.controller = json.at("controller");
  run.transport = json.at("transport");
  run.digest = json.at("digest");
  run.day_start = json.at("day_start");
  run.step_minutes = json.at("step_minutes");
  run.regions = json.at("regions");
  run.fleet = json.at("fleet");
  run.solves = solver.at("solves");
  run.fallbacks = solver.at("fallbacks");
  run.solve_seconds_median = solver.at("seconds_median");
  run.wall_seconds = json.at("wall_seconds");
  run.totals = json.at("totals").get<std::map<std::string, double>>();
  const auto timings = json.value("timings", nlohmann::ordered_json::object());
  for (const auto& [process, legs] : timings.items()) {
    ProcessLegs& of_process = run.timings.emplace_back(ProcessLegs{process, {}});
    for (const auto& [name, leg] : legs.items()) {
      of_process.legs.push_back({name, leg.at("times"), leg.at("seconds"), 1e-3 * leg.at("longest_ms").get<double>()});
    }
  }
}

/// The columns of a table by name, but for the first.
std::map<std::string, std::vector<double>> read_columns(const fs::path& file) {
  std::map<std::string, std::vector<double>> columns;
  std::istringstream lines(text_of_file(file));
  std::string line;
  std::getline(lines, line);
  const auto names = split_csv(line);
  for (int number = 2; std::getline(lines, line); ++number) {
    const auto cells = split_csv(line);
    if (cells.size() != names.size()) {
      throw bad_input(file.string(), number, "has not as many columns as the header");
    }
    for (std::size_t i = 1; i < cells.size(); ++i) {
      double value = 0.0;
      const auto end = cells[i].data() + cells[i].size();
      if (std::from_chars(cells[i].data(), end, value).ptr != end) {
        throw bad_input(file.string(), number, "`" + cells[i] + "` is no number");
      }
      columns[names[i]].push_back(value);
    }
  }
  return columns;
}

/// A column of regions.csv, which goes through the regions of a step before the next step.
Eigen::MatrixXd by_region(const std::vector<double>& column, int regions) {
  return Eigen::Map<const Eigen::MatrixXd>(column.data(), regions, static_cast<Eigen::Index>(column.size()) / regions);
}

int count_ticks(const fs::path& file) {
  const SQLite::Database database(file.string());
  SQLite::Statement query(database, "SELECT count(*) FROM injector");
  query.executeStep();
  return query.getColumn(0).getInt();
}

std::vector<PlanCost> mean_costs(const fs::path& file) {
  const SQLite::Database database(file.string());
  SQLite::Statement query(database,
                          "SELECT term, sum(cost) / (SELECT count(DISTINCT tick) FROM plan_costs) FROM plan_costs "
                          "GROUP BY term ORDER BY min(seq), term");
  std::vector<PlanCost> costs;
  while (query.executeStep()) {
    costs.push_back({query.getColumn(0).getString(), query.getColumn(1).getDouble()});
  }
  return costs;
}

}  // namespace

RecordedRun read_run(const fs::path& folder) {
  if (fs::exists(folder / "INCOMPLETE") || !fs::exists(folder / "summary.json")) {
    throw bad_input(folder.string() + ": holds no finished run; give a directory that `evbal run` wrote to its end");
  }
  return read_marked_run(folder);
}

RecordedRun read_marked_run(const fs::path& folder) {
  RecordedRun run;
  run.folder = folder;
  try {
    read_summary(folder / "summary.json", run);
    run.steps = read_columns(folder / "steps.csv");
    for (const auto& [name, column] : read_columns(folder / "regions.csv")) {
      run.by_region[name] = by_region(column, run.regions);
    }
    run.ticks = count_ticks(folder / "run.sqlite");
    run.plan_costs = mean_costs(folder / "run.sqlite");
    run.faults = read_faults(folder / "run.sqlite");
    run.sensors = read_sensors(folder / "run.sqlite", most_sensors);
  } catch (const nlohmann::json::exception& error) {
    throw bad_input((folder / "summary.json").string() + ": " + error.what());
  } catch (const SQLite::Exception& error) {
    throw bad_input((folder / "run.sqlite").string() + ": " + error.what());
  }
  return run;
}

}  // namespace evbal
