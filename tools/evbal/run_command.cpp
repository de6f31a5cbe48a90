#include "tools/evbal/run_command.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "experiments/record/paired_run.hpp"
#include "experiments/record/recorded_run.hpp"
#include "experiments/run/run_folder.hpp"
#include "experiments/run/twins.hpp"
#include "experiments/study/executors/monte_carlo.hpp"
#include "tools/evbal/console_table.hpp"
#include "tools/evbal/day_progress.hpp"
#include "tools/evbal/report_command.hpp"
#include "tools/evbal/study_progress.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  fs::path scenario;
  Overrides overrides;
  std::string out;
  bool quiet = false;
};

/// A directory of our own under runs/, made at once so that two runs never take the same.
fs::path claim_folder(const Scenario& scenario) {
  const std::string controller = scenario.controllers.size() == 1 ? "-" + scenario.controllers.front() : "";
  const std::string base =
      scenario.name + "-" + scenario.world.day.date + controller + "-seed" + std::to_string(scenario.world.seed);
  fs::create_directories("runs");
  for (int number = 1;; ++number) {
    fs::path folder = fs::path("runs") / (number == 1 ? base : base + "-" + std::to_string(number));
    if (fs::create_directory(folder)) {
      return folder;
    }
  }
}

/// Plays the runs, and their twins beside them.
std::vector<RunResult> record_all(const std::vector<Run>& runs, bool quiet) {
  std::optional<Twins> twins;
  if (!runs.front().scenario.schedule.faults.empty()) {
    twins.emplace(runs);
  }
  std::vector<RunResult> results;
  results.reserve(runs.size());
  for (const auto& run : runs) {
    results.push_back(record(run, shown_day(run.scenario, quiet)));
  }
  if (twins) {
    twins->await();
  }
  return results;
}

/// Writes the pages and what the faults cost, which it gives back as tables. The runs are complete then.
std::string write_reports(const fs::path& folder, const std::vector<RunResult>& results) {
  std::string tables;
  std::vector<RecordedRun> runs;
  for (const auto& result : results) {
    runs.push_back(read_marked_run(result.folder));
    if (!runs.back().faults.empty()) {
      const RecordedRun twin = read_run(twin_folder(result.folder));
      const auto costs = costs_of(runs.back(), twin);
      write_costs(runs.back(), twin, costs);
      write_report(twin.folder / "report.html", {twin});
      tables += result.controller + ": what the faults cost\n" + cost_table(costs) + "\n";
    }
    write_report(result.folder / "report.html", {runs.back()});
  }
  if (runs.size() > 1) {
    write_report(folder / "report.html", runs);
  }
  for (const auto& result : results) {
    mark_complete(result.folder);
  }
  return tables;
}

/// Throws Error{expectation_failed} naming every expectation that does not hold.
void check_expectations(const Scenario& scenario, const std::vector<RunResult>& results) {
  std::string failed;
  for (const auto& result : results) {
    for (const auto& [name, value] : named(result.totals)) {
      for (const auto& expect : scenario.expect) {
        if (expect.metric == name && !expect.holds(value)) {
          failed += (failed.empty() ? "" : "; ") + result.controller + ": " + name + " is " + decimal(value) +
                    ", expected " + expect.words();
        }
      }
    }
  }
  if (!failed.empty()) {
    throw Error(ExitStatus::expectation_failed, failed);
  }
}

/// The words of a command line that is taken from the current directory.
Command words_of(const std::string& text) {
  std::istringstream in(text);
  return command_from(fs::current_path(), {std::istream_iterator<std::string>(in), {}});
}

/// The runs of a schedule that was drawn once.
void play_once(const Scenario& scenario, const fs::path& folder, bool quiet) {
  const std::vector<RunResult> results = record_all(runs_of(scenario, folder), quiet);
  const std::string costs = write_reports(folder, results);
  if (!quiet) {
    std::printf("\n%s\n%s", side_by_side(results).c_str(), costs.c_str());
  }
  for (const auto& result : results) {
    std::printf("%s\n", result.folder.c_str());
  }
  if (!quiet) {
    std::printf("%s\n", (folder / "report.html").c_str());
  }
  check_expectations(scenario, results);
}

/// The runs of every draw of a schedule that are not played yet.
void play_all_draws(const Draws& draws, const OutFolder& out, bool over_bus, bool quiet) {
  const fs::path& folder = out.path();
  StudyProgress progress(quiet);
  warn_of_other_programs(draws_file(folder), draws.keys);
  const DrawsResult result = play_draws(draws, folder, {.over_bus = over_bus, .on_day_ended = progress.shown_days()});
  out.complete();
  for (const auto& drawn : result.controllers) {
    if (!quiet) {
      std::printf("%s%s, %zu draws of the faults\n%sworst: %s, %s %s; alone: evbal run %s\n\n",
                  &drawn == &result.controllers.front() ? "\n" : "", drawn.controller.c_str(), drawn.draws,
                  distribution_table(drawn.metrics).c_str(), drawn.worst.c_str(), drawn.worst_metric.c_str(),
                  decimal(drawn.worst_value).c_str(), drawn.worst_file.c_str());
    }
  }
  std::printf("%s\n", folder.c_str());
  if (!result.disappointments.empty()) {
    throw Error(ExitStatus::expectation_failed, result.disappointments);
  }
}

void run(const RunArguments& arguments) {
  catch_interrupts();
  const Scenario scenario = read_scenario(find_scenario(arguments.scenario), arguments.overrides);
  check_planning(scenario);
  const fs::path folder = arguments.out.empty() ? claim_folder(scenario) : fs::path(arguments.out);
  const std::optional<Draws> draws =
      scenario.draws.size() > 1 ? std::optional(draws_of(scenario, folder)) : std::nullopt;
  const OutFolder out(folder, draws ? draws->fingerprint() : "");
  try {
    if (draws) {
      const bool over_bus = arguments.overrides.transport == "dds" || own_transport(scenario) == "dds";
      play_all_draws(*draws, out, over_bus, arguments.quiet);
    } else {
      play_once(scenario, folder, arguments.quiet);
    }
  } catch (...) {
    std::error_code not_empty;
    fs::remove(folder, not_empty);
    throw;
  }
}

}  // namespace

void add_run_command(CLI::App& app) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Play the day of a scenario and record it");
  command->add_option("SCENARIO", arguments->scenario, "Scenario file (YAML), or the name of a shipped one")
      ->required();
  command->add_option("--controller", arguments->overrides.controller, "One controller in place of the scenario's");
  command
      ->add_option_function<std::string>(
          "--coordinator", [arguments](const std::string& text) { arguments->overrides.coordinator = words_of(text); },
          "Program that makes the plans in place of evbal-coordinator, with its words")
      ->type_name("COMMAND");
  command->add_option("--day", arguments->overrides.day, "Another day on record, such as 2008-06-04");
  command->add_option("--seed", arguments->overrides.seed, "Another seed")->check([](const std::string& text) {
    const bool whole = text.find_first_not_of("0123456789") == std::string::npos;
    return whole ? "" : "give a whole number from 0 to 2^64-1";
  });
  command->add_option("--faults", arguments->overrides.faults, "Another fault schedule (YAML)");
  command->add_option("--transport", arguments->overrides.transport, "dds: processes on a bus; inproc: one process");
  command->add_option("--regions-per-process", arguments->overrides.regions_per_process, "Regions that an agent hosts");
  command->add_option("--engine", arguments->overrides.engine, "Solver of the balancing problem");
  command->add_option("--dds-profiles", arguments->overrides.dds_profiles,
                      "Settings of Fast DDS for the bus (XML), of which none are taken from elsewhere");
  command->add_option("--out", arguments->out,
                      "Run directory, new, empty or of a run that broke off; otherwise one under runs/");
  command->add_flag("--quiet", arguments->quiet, "Print the run directories only");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace evbal
