#include "tools/evbal/run_command.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "common/log.hpp"
#include "experiments/record/paired_run.hpp"
#include "experiments/record/recorded_run.hpp"
#include "experiments/run/run_folder.hpp"
#include "experiments/run/twins.hpp"
#include "experiments/study/executors/monte_carlo.hpp"
#include "tools/console/console.hpp"
#include "tools/evbal/console_table.hpp"
#include "tools/evbal/day_progress.hpp"
#include "tools/evbal/json_output.hpp"
#include "tools/evbal/report_command.hpp"
#include "tools/evbal/runs_folder.hpp"
#include "tools/evbal/scenario_options.hpp"
#include "tools/evbal/study_progress.hpp"
#include "tools/evbal/usage_error.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace evbal {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  ScenarioOptions options;
  std::string out;
  bool quiet = false;
  bool json = false;
  std::string log_level = "warn";
  std::optional<int> watch;  ///< port of the console, 0 for any
};

/// How fast a day is played that is watched, until somebody says otherwise: ten minutes a second.
constexpr double watched_speed = 600.0;

/// The port that `--watch` names, if it names one.
int port_of(const std::string& given) {
  if (given.empty() || given == "true") {  // as CLI11 has an option without its value
    return 0;
  }
  const bool number = given.size() <= 5 && given.find_first_not_of("0123456789") == std::string::npos;
  if (const int port = number ? std::stoi(given) : 0; port >= 1 && port <= 65'535) {
    return port;
  }
  throw bad_input("--watch: `" + given + "` is no port; give one from 1 to 65535, or none to have one chosen");
}

/// What is shown of runs that are over.
enum class Output { tables, folders, json };

Output output_of(const RunArguments& arguments) {
  if (arguments.json) {
    return Output::json;
  }
  return arguments.quiet ? Output::folders : Output::tables;
}

/// `runs/latest` leads to the newest run that is complete and was given no other place.
void note_latest(const fs::path& folder, const RunArguments& arguments) {
  if (arguments.out.empty()) {
    name_latest(folder);
  }
}

/// Those who are told of the days: the terminal, and who watches.
struct Audience {
  bool quiet = false;
  Console* console = nullptr;  ///< if somebody may watch
};

/// Plays a run, tells of it, and asks for its twin as soon as it has a fault.
RunResult play(const std::vector<Run>& runs, std::size_t position, Twins& twins, const Audience& audience) {
  const Scenario& scenario = runs[position].scenario;
  std::optional<DayProgress> progress;
  if (!audience.quiet) {
    progress.emplace(scenario);
  }
  DoorOptions door;
  if (audience.console != nullptr) {
    audience.console->begin(scenario, runs[position].folder);
    door.speed = watched_speed;
  }
  if (!scenario.schedule.faults.empty()) {
    twins.need(position);
  }
  const auto on_tick = [&](const TickRecord& tick) {
    if (progress) {
      progress->show(tick);
    }
    if (audience.console != nullptr) {
      audience.console->add(tick);
      audience.console->add_twin(twins.heard(position));
    }
  };
  door.on_fault = [&](const Fault& fault) {
    twins.need(position);
    if (progress) {
      progress->add_fault(fault.name);
    }
    if (audience.console != nullptr) {
      audience.console->add_fault(fault);
    }
  };
  door.on_pace = [&](const DayPace& pace) {
    if (progress) {
      progress->note_pace(pace);
    }
    if (audience.console != nullptr) {
      audience.console->note_pace(pace);
    }
  };
  return record(runs[position], on_tick, door);
}

/// Plays the runs, and beside them the twins of those with faults.
std::vector<RunResult> record_all(const std::vector<Run>& runs, const RunArguments& arguments) {
  Twins twins(runs);
  std::optional<Console> console;
  if (arguments.watch) {
    console.emplace(*arguments.watch);
    std::fprintf(stderr, "watch at %s\n", console->link().c_str());
  }
  std::vector<RunResult> results;
  results.reserve(runs.size());
  for (std::size_t position = 0; position < runs.size(); ++position) {
    results.push_back(play(runs, position, twins, {arguments.quiet, console ? &*console : nullptr}));
  }
  twins.await();
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
      for (const auto& expect : of_runs(scenario.expect)) {
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

/// The runs of a schedule that was drawn once.
void play_once(const Scenario& scenario, const fs::path& folder, const RunArguments& arguments) {
  const std::vector<RunResult> results = record_all(runs_of(scenario, folder), arguments);
  const std::string costs = write_reports(folder, results);
  note_latest(folder, arguments);
  const fs::path report = folder / "report.html";
  const Output output = output_of(arguments);
  if (output == Output::json) {
    std::fputs(runs_json(results, report).c_str(), stdout);
  } else {
    if (output == Output::tables) {
      std::printf("\n%s\n%s", side_by_side(results).c_str(), costs.c_str());
    }
    for (const auto& result : results) {
      std::printf("%s\n", result.folder.c_str());
    }
    if (output == Output::tables) {
      std::printf("%s\n", report.c_str());
    }
  }
  check_expectations(scenario, results);
}

void print_draws(const DrawsResult& result, const fs::path& folder, Output output) {
  if (output == Output::json) {
    std::fputs(draws_json(result, folder).c_str(), stdout);
    return;
  }
  for (const auto& drawn : result.controllers) {
    if (output == Output::tables) {
      std::printf("%s%s, %zu draws of the faults\n%sworst: %s, %s %s; alone: evbal run %s\n\nwhat %s goes with:\n%s\n",
                  &drawn == &result.controllers.front() ? "\n" : "", drawn.controller.c_str(), drawn.draws,
                  distribution_table(drawn.metrics).c_str(), drawn.worst.c_str(), drawn.worst_metric.c_str(),
                  decimal(drawn.worst_value).c_str(), drawn.worst_file.c_str(), drawn.worst_metric.c_str(),
                  influence_table(drawn.influences).c_str());
    }
  }
  std::printf("%s\n", folder.c_str());
}

/// The runs of every draw of a schedule that are not played yet.
void play_all_draws(const Draws& draws, const OutFolder& out, bool over_bus, const RunArguments& arguments) {
  const fs::path& folder = out.path();
  StudyProgress progress(arguments.quiet);
  warn_of_other_programs(draws_file(folder), draws.keys);
  const DrawsResult result = play_draws(draws, folder, {.over_bus = over_bus, .on_day_ended = progress.shown_days()});
  out.complete();
  note_latest(folder, arguments);
  print_draws(result, folder, output_of(arguments));
  if (!result.disappointments.empty()) {
    throw Error(ExitStatus::expectation_failed, result.disappointments);
  }
}

/// Says what strangers can do to a day over several hosts.
void warn_of_strangers(const Scenario& scenario) {
  const bool apart =
      std::ranges::any_of(scenario.hosts, [](const HostSpec& host) { return !host.address.starts_with("127."); });
  if (apart && scenario.transport == "dds" && !scenario.security) {
    std::fputs(
        "hosts: nothing that is said between them is signed or encrypted: anyone on their network can read the day, "
        "write reports, plans and departures into it, and stop it; use a network that you trust, or `security: on`\n",
        stderr);
  }
}

void run(const RunArguments& arguments) {
  catch_interrupts();
  begin_log("evbal", log_level_of(arguments.log_level));
  const Overrides& overrides = arguments.options.overrides;
  const Scenario scenario = read_scenario(find_scenario(arguments.options.scenario), overrides);
  check_planning(scenario);
  warn_of_strangers(scenario);
  const fs::path folder = arguments.out.empty() ? claim_folder(scenario) : fs::path(arguments.out);
  if (arguments.watch && scenario.draws.size() > 1) {
    throw bad_input("--watch: shows one day; leave `runs` out of the schedule");
  }
  const std::optional<Draws> draws =
      scenario.draws.size() > 1 ? std::optional(draws_of(scenario, folder)) : std::nullopt;
  const OutFolder out(folder, draws ? draws->fingerprint() : "");
  try {
    if (draws) {
      const bool over_bus = overrides.transport == "dds" || own_transport(scenario) == "dds";
      play_all_draws(*draws, out, over_bus, arguments);
    } else {
      play_once(scenario, folder, arguments);
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
  CLI::App* command = app.add_subcommand(
      "run", "Play the day of a scenario and record it, over several hosts if it names some (key `hosts`)");
  add_scenario_options(*command, arguments->options);
  command->add_option("--out", arguments->out,
                      "Run directory, new, empty or of a run that broke off; otherwise one under runs/");
  command
      ->add_option_function<std::string>(
          "--watch", [arguments](const std::string& port) { arguments->watch = port_of(port); },
          "Serve a page on this port of 127.0.0.1, else on a free one, to watch the day and break it by hand; prints "
          "its "
          "link. The day is played at 600 times the wall's clock until the page says otherwise")
      ->expected(0, 1)
      ->option_text("[PORT]");
  command->add_flag("--quiet", arguments->quiet, "Without progress; print the run directories only");
  command->add_flag("--json", arguments->json, "Print the results as JSON");
  command
      ->add_option(
          "--log-level", arguments->log_level,
          "What is logged, to stderr and processes/*.log: debug, info, warn or error, and all that matters more")
      ->check(one_of_words(log_levels()));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace evbal
