#include "experiments/study/store/sweep_file.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/table_text.hpp"
#include "common/version.hpp"
#include "experiments/metrics/columns.hpp"
#include "experiments/record/database_table.hpp"
#include "experiments/study/store/open_database.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;

Error no_sweep(const fs::path& file, const SQLite::Exception& error) {
  return bad_input(file.string() + ": is no sweep of this version of evbal (" + error.what() +
                   "); give another directory with --out");
}

/// Appends the columns of a metrics' row.
template <class Line>
void add_columns(Row& row, const Line& line) {
  columns(
      [&](const char* name, auto value) {
        if constexpr (std::is_integral_v<decltype(value)>) {
          row.push_back({name, std::int64_t{value}});
        } else {
          row.push_back({name, value});
        }
      },
      line);
}

Row result_row(const std::string& key, const DayResult& result) {
  Row row = {{"key", key}};
  add_columns(row, result.metrics.totals);
  row.push_back({"fallbacks", std::int64_t{result.fallbacks}});
  row.push_back({"program", this_program()});
  row.push_back({"digest", result.digest});
  return row;
}

Row step_row(const std::string& key, const DayClock& clock, const CityStep& step) {
  Row row = {{"key", key}, {"start", time_of_day(clock, step.step * clock.step)}};
  add_columns(row, step);
  return row;
}

Row day_row(std::size_t run, const Sweep& sweep, const SweptDay& day, const std::string& key) {
  Row row = {{"run", static_cast<std::int64_t>(run)}, {"scenario", day.scenario}, {"variant", day.variant},
             {"controller", day.controller},          {"faults", day.faults},     {"day", day.day},
             {"seed", std::to_string(day.seed)}};
  for (const auto& path : sweep.settings) {
    const auto given = day.settings.find(path);
    row.push_back({path, given == day.settings.end() ? "" : given->second});
  }
  row.push_back({"key", key});
  return row;
}

/// By key, what the steps from 07:00 on add up to.
std::string after_7_query() {
  std::string sums;
  for (const auto& name : additive_metrics()) {
    sums.append(", sum(\"").append(name).append("\") AS \"").append(name).append("_after_7\"");
  }
  return "(SELECT key" + sums + " FROM steps WHERE start >= '07:00' GROUP BY key)";
}

/// A row of `days` with its result.
FinishedDay finished_day(SQLite::Statement& row) {
  FinishedDay day{.scenario = row.getColumn("scenario").getString(),
                  .variant = row.getColumn("variant").getString(),
                  .controller = row.getColumn("controller").getString(),
                  .faults = row.getColumn("faults").getString(),
                  .day = row.getColumn("day").getString(),
                  .seed = std::stoull(row.getColumn("seed").getString())};
  int at = row.getColumnIndex("seed") + 1;
  for (; std::string(row.getColumnName(at)) != "key"; ++at) {
    day.settings[row.getColumnName(at)] = row.getColumn(at).getString();
  }
  for (const auto& metric : finished_metrics()) {
    day.totals[metric] = row.getColumn(metric.c_str()).getDouble();
  }
  day.digest = row.getColumn("digest").getString();
  return day;
}

std::string cell(const SQLite::Column& column) {
  return column.isFloat() ? decimal(column.getDouble()) : column.getString();
}

/// All that `query` finds, with a header; `key` is left out.
std::string csv(const fs::path& file, const std::string& query) {
  const SQLite::Database database = open_database(file);
  SQLite::Statement rows(database, query);
  std::vector<int> shown;
  std::vector<std::string> cells;
  for (int i = 0; i < rows.getColumnCount(); ++i) {
    if (std::string(rows.getColumnName(i)) != "key") {
      cells.emplace_back(rows.getColumnName(i));
      shown.push_back(i);
    }
  }
  std::string text = csv_row(cells);
  while (rows.executeStep()) {
    cells.clear();
    for (const int i : shown) {
      cells.push_back(cell(rows.getColumn(i)));
    }
    text += csv_row(cells);
  }
  return text;
}

Row failure_row(const std::string& key, const std::string& reason) {
  return {{"key", key}, {"reason", reason}};
}

Row timing_row(const std::string& key, double seconds) {
  return {{"key", key}, {"seconds", seconds}};
}

void make_tables(SQLite::Database& database) {
  const Table results(database, "results", result_row("", {}));
  const Table failed(database, "failed", failure_row("", ""));
  const Table timings(database, "timings", timing_row("", 0.0));
  const Table steps(database, "steps", step_row("", {}, {}));
  database.exec("CREATE UNIQUE INDEX IF NOT EXISTS by_key ON results (key)");
  database.exec("CREATE INDEX IF NOT EXISTS steps_by_key ON steps (key)");
}

}  // namespace

std::set<std::string> begin_sweep(const fs::path& file, const Sweep& sweep, const std::vector<std::string>& keys) {
  try {
    SQLite::Database database = open_database(file, SQLite::OPEN_CREATE);
    SQLite::Transaction transaction(database);
    make_tables(database);
    database.exec("DROP TABLE IF EXISTS days");
    Table days(database, "days", day_row(0, sweep, sweep.days.front(), ""));
    for (std::size_t i = 0; i < keys.size(); ++i) {
      days.add(day_row(i + 1, sweep, sweep.days[i], keys[i]));
    }
    std::set<std::string> finished;
    SQLite::Statement query(database, "SELECT key FROM results");
    while (query.executeStep()) {
      finished.insert(query.getColumn(0).getString());
    }
    transaction.commit();
    return finished;
  } catch (const SQLite::Exception& error) {
    throw no_sweep(file, error);
  }
}

void add_result(const fs::path& file, const std::string& key, const DayClock& clock, const DayResult& result) {
  SQLite::Database database = open_database(file);
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  Table(database, "results", result_row("", {})).add(result_row(key, result));
  Table steps(database, "steps", step_row("", {}, {}));
  for (const auto& step : result.metrics.steps) {
    steps.add(step_row(key, clock, step));
  }
  transaction.commit();
}

void note_failure(const fs::path& file, const std::string& key, const std::string& reason) {
  SQLite::Database database = open_database(file);
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement before(database, "DELETE FROM failed WHERE key = ?");
  before.bind(1, key);
  before.exec();
  Table(database, "failed", failure_row("", "")).add(failure_row(key, reason));
  transaction.commit();
}

std::map<std::string, std::string> failures_in(const fs::path& file) {
  std::map<std::string, std::string> reasons;
  if (!fs::exists(file)) {
    return reasons;
  }
  try {
    const SQLite::Database database = open_database(file);
    if (!database.tableExists("failed")) {
      return reasons;
    }
    SQLite::Statement row(database, "SELECT key, reason FROM failed WHERE key NOT IN (SELECT key FROM results)");
    while (row.executeStep()) {
      reasons[row.getColumn(0).getString()] = row.getColumn(1).getString();
    }
    return reasons;
  } catch (const SQLite::Exception& error) {
    throw no_sweep(file, error);
  }
}

std::string failed_days_csv(const fs::path& file) {
  if (failures_in(file).empty()) {
    return "";
  }
  return csv(file,
             "SELECT * FROM days JOIN failed USING (key) WHERE key NOT IN (SELECT key FROM results) ORDER BY run");
}

void note_seconds(const fs::path& file, const std::string& key, double seconds) {
  SQLite::Database database = open_database(file);
  Table(database, "timings", timing_row("", 0.0)).add(timing_row(key, seconds));
}

std::map<std::string, std::optional<double>> seconds_of_results(const fs::path& file) {
  std::map<std::string, std::optional<double>> seconds;
  if (!fs::exists(file)) {
    return seconds;
  }
  try {
    const SQLite::Database database = open_database(file);
    const bool timed = database.tableExists("timings");
    SQLite::Statement row(database, timed ? "SELECT key, seconds FROM results LEFT JOIN timings USING (key)"
                                          : "SELECT key, NULL FROM results");
    while (row.executeStep()) {
      const SQLite::Column took = row.getColumn(1);
      seconds[row.getColumn(0).getString()] = took.isNull() ? std::nullopt : std::optional(took.getDouble());
    }
    return seconds;
  } catch (const SQLite::Exception& error) {
    throw no_sweep(file, error);
  }
}

void begin_results(const fs::path& file) {
  try {
    SQLite::Database database = open_database(file, SQLite::OPEN_CREATE);
    SQLite::Transaction transaction(database);
    make_tables(database);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw no_sweep(file, error);
  }
}

void merge_result(const fs::path& file, const fs::path& other) {
  SQLite::Database database = open_database(file);
  SQLite::Statement attach(database, "ATTACH ? AS other");
  attach.bind(1, other.string());
  attach.exec();
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  database.exec("INSERT INTO steps SELECT * FROM other.steps WHERE key NOT IN (SELECT key FROM results)");
  database.exec("INSERT INTO timings SELECT * FROM other.timings WHERE key NOT IN (SELECT key FROM results)");
  database.exec("INSERT OR IGNORE INTO results SELECT * FROM other.results");
  transaction.commit();
}

std::vector<PlayedByAnother> played_by_others(const fs::path& file, const std::vector<std::string>& keys) {
  if (!fs::exists(file)) {
    return {};
  }
  try {
    const SQLite::Database database = open_database(file);
    if (is_blank(database)) {
      return {};
    }
    SQLite::Statement row(database, "SELECT program, key FROM results WHERE program <> ? ORDER BY program");
    row.bind(1, this_program());
    const std::set<std::string> asked_for(keys.begin(), keys.end());
    std::vector<PlayedByAnother> all;
    while (row.executeStep()) {
      const std::string program = row.getColumn(0).getString();
      if (all.empty() || all.back().program != program) {
        all.push_back({.program = program});
      }
      ++(asked_for.contains(row.getColumn(1).getString()) ? all.back().asked_for : all.back().others);
    }
    return all;
  } catch (const SQLite::Exception& error) {
    throw no_sweep(file, error);
  }
}

std::string swept_days_csv(const fs::path& file) {
  return csv(file, "SELECT * FROM days JOIN results USING (key) ORDER BY run");
}

std::string swept_steps_csv(const fs::path& file) {
  return csv(file, "SELECT run, steps.* FROM days JOIN steps USING (key) ORDER BY run, step");
}

std::vector<FinishedDay> read_asked_for(const fs::path& file) try {
  if (!fs::exists(file)) {
    throw bad_input(file.string() + ": is not there; give a directory that `evbal sweep` wrote");
  }
  const SQLite::Database database = open_database(file);
  if (is_blank(database)) {
    throw bad_input(file.string() + ": holds no day yet; run the sweep first");
  }
  SQLite::Statement rows(database, "SELECT * FROM days LEFT JOIN results USING (key) LEFT JOIN " + after_7_query() +
                                       " USING (key) ORDER BY run");
  std::vector<FinishedDay> days;
  while (rows.executeStep()) {
    days.push_back(finished_day(rows));
    if (rows.getColumn("digest").isNull()) {
      days.back().totals.clear();
    }
  }
  return days;
} catch (const SQLite::Exception& error) {
  throw no_sweep(file, error);
}

PlayedDays read_played(const fs::path& file) {
  PlayedDays played;
  std::size_t run = 0;
  for (auto& day : read_asked_for(file)) {
    ++run;
    if (!day.totals.empty()) {
      played.days.push_back(std::move(day));
      continue;
    }
    if (played.missing.empty()) {
      played.first_missing = std::to_string(run);
    }
    played.missing.push_back(std::move(day));
  }
  return played;
}

std::vector<FinishedDay> read_finished(const fs::path& file) {
  PlayedDays played = read_played(file);
  if (!played.missing.empty()) {
    throw bad_input(file.string() + ": run " + played.first_missing + " is missing; run the sweep to its end first");
  }
  return std::move(played.days);
}

}  // namespace evbal
