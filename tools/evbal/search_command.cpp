#include "tools/evbal/search_command.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/search/described.hpp"
#include "experiments/search/path_csv.hpp"
#include "experiments/search/search_task.hpp"
#include "experiments/search/searched_days.hpp"
#include "experiments/search/shrink.hpp"
#include "tools/evbal/playing_options.hpp"
#include "tools/evbal/scenario_options.hpp"
#include "tools/evbal/study_progress.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// The share of the harm that must remain of a schedule that is made small.
constexpr double kept_share = 0.9;

struct SearchArguments {
  ScenarioOptions options;
  int budget = 300;
  bool random = false;
  std::string metric;
  std::string out;
  PlayingOptions playing;
};

/// What a search came to.
struct Found {
  double without = 0.0;       ///< the metric without faults
  std::vector<Trial> trials;  ///< all, in their order; those of making it small behind the others
  std::size_t tried = 0;      ///< schedules among which the worst was found
  Trial worst;                ///< that does most harm
  Trial small;                ///< what remains of it
  std::size_t draws = 0;      ///< random ones to compare with
  double drawn = 0.0;         ///< harm of the worst of these
};

/// The harm of each schedule, played.
Harms harms_of(const SearchTask& task, SearchedDays& days, double without) {
  return [&task, &days, without](const std::vector<Trial>& trials) {
    std::vector<double> values = days.values(trials, task.metric);
    for (double& value : values) {
      value = task.harm(value, without);
    }
    return values;
  };
}

/// The same under as many random draws as the search had schedules, or under those that it began with.
void compare_with_draws(const SearchTask& task, std::size_t count, const Harms& harms, Found& found) {
  std::vector<Trial> drawn;
  for (auto& picks : random_draws(task.ingredients, count)) {
    drawn.push_back({.number = drawn.size() + 1, .stage = "draw", .change = "", .picks = std::move(picks)});
  }
  found.draws = count;
  found.drawn = std::ranges::max(harms(drawn));
}

/// What is left of the worst schedule when all is taken away that is not needed: for the most of its harm, and to fail
/// what it fails. Without harm there is nothing to keep.
Trial made_small(const SearchTask& task, const Harms& harms, Found& found) {
  if (found.worst.harm <= 0.0) {
    return {};
  }
  const auto fails = [&](double harm) { return task.expect && !task.expect->holds(task.value(harm, found.without)); };
  const auto enough = [&](double harm) {
    return harm >= kept_share * found.worst.harm && (fails(harm) || !fails(found.worst.harm));
  };
  return shrink(task.ingredients, found.worst, enough, harms, found.trials);
}

Found find_worst(const SearchTask& task, SearchedDays& days, const SearchArguments& arguments) {
  Found found;
  found.without = days.values({Trial{}}, task.metric).front();
  const Harms harms = harms_of(task, days, found.without);
  const auto budget = static_cast<std::size_t>(arguments.budget);
  found.trials = search_worst(task.ingredients, budget, harms);
  found.tried = found.trials.size();
  found.worst = most_harmful(found.trials);
  compare_with_draws(task, arguments.random ? budget : first_draws(budget), harms, found);
  found.small = made_small(task, harms, found);
  return found;
}

std::string number_words(double value) {
  constexpr int digits = 3;
  return value == std::round(value) ? decimal(value) : fixed(value, digits);
}

std::string faults_of(const Trial& trial) {
  return std::to_string(trial.picks.size()) + (trial.picks.size() == 1 ? " fault" : " faults");
}

std::string times_drawn(const Trial& trial, const Found& found) {
  constexpr int digits = 2;
  return found.drawn > 0.0 ? fixed(trial.harm / found.drawn, digits) + " times as much as" : "against no harm";
}

/// What came out, in words.
std::string text_of(const SearchTask& task, const Found& found, const SearchedDays& days) {
  const std::string draws = "the worst of " + std::to_string(found.draws) + " random draws";
  const auto line = [&](const std::string& what, double harm) {
    return what + ": " + number_words(task.value(harm, found.without)) + ", harm " + number_words(harm);
  };
  std::string text = task.scenario.planning.controller + ", " + task.metric +
                     "\nwithout faults: " + number_words(found.without) + "\n" + line(draws, found.drawn) + "\n" +
                     line("the worst of " + std::to_string(found.tried) + " tried", found.worst.harm) + ", " +
                     times_drawn(found.worst, found) + " under " + draws + ", " + faults_of(found.worst) + "\n";
  if (found.worst.harm <= 0.0) {
    return text + "No schedule was found that does any harm.\n";
  }
  return text + line("what remains of it", found.small.harm) + ", " +
         fixed(100.0 * found.small.harm / found.worst.harm, 0) + " %, " + faults_of(found.small) + ", after " +
         std::to_string(found.trials.size() - found.tried) + " more tried\n\nEnough for `" + task.metric + "` to " +
         (task.more_is_worse ? "rise" : "fall") + " by " + number_words(found.small.harm) + ", " +
         times_drawn(found.small, found) + " under " + draws + ": " +
         described(days.with(found.small.picks).schedule, task.scenario.world.clock) + ".\n";
}

/// A scenario that runs alone, held to all that it expects.
void write_scenario(const fs::path& file, Scenario scenario) {
  for (auto& expect : scenario.expect) {
    expect.under_search = false;
  }
  write_file(file, resolved_yaml(scenario, scenario.planning.controller));
}

/// Throws Error{expectation_failed} with the smallest schedule that fails what is expected under search.
void check_expectation(const SearchTask& task, const Found& found, const SearchedDays& days, const fs::path& file) {
  const double value = task.value(std::max(0.0, found.small.harm), found.without);
  if (task.expect && !task.expect->holds(value)) {
    throw Error(ExitStatus::expectation_failed,
                task.scenario.planning.controller + ": " + task.metric + " is " + decimal(value) + ", expected " +
                    task.expect->words() + " under search, with " +
                    described(days.with(found.small.picks).schedule, task.scenario.world.clock) + ": evbal run " +
                    file.string());
  }
}

void search(const SearchArguments& arguments) {
  catch_interrupts();
  const SearchTask task =
      read_search_task(find_scenario(arguments.options.scenario), arguments.options.overrides, arguments.metric);
  check_planning(task.scenario);
  const SweepFolder folder(
      arguments.out.empty() ? fs::path("runs") / (task.scenario.name + "-search") : fs::path(arguments.out),
      search_file_name);
  for (const char* file : {"worst.yaml", "shrunk.yaml", "path.csv", "search.txt"}) {
    fs::remove(folder.path() / file);
  }
  StudyProgress progress(arguments.playing.quiet);
  Playing playing = arguments.playing.playing;
  playing.on_day_ended = progress.shown_days();
  SearchedDays days(task.scenario, task.ingredients, folder, playing, 1 + static_cast<std::size_t>(arguments.budget));
  const Found found = find_worst(task, days, arguments);
  warn_of_other_programs(folder.file(), days.used());
  const fs::path shrunk = folder.path() / "shrunk.yaml";
  const std::string text = text_of(task, found, days);
  write_scenario(folder.path() / "worst.yaml", days.with(found.worst.picks));
  write_scenario(shrunk, days.with(found.small.picks));
  write_file(folder.path() / "path.csv", path_csv(found.trials, task.ingredients));
  write_file(folder.path() / "search.txt", text);
  std::printf("\n%s%s\n", text.c_str(), folder.path().c_str());
  check_expectation(task, found, days, shrunk);
}

}  // namespace

void add_search_command(CLI::App& app) {
  const auto arguments = std::make_shared<SearchArguments>();
  CLI::App* command = app.add_subcommand("search", "Find the faults that hurt a day most, and as few as do");
  add_day_options(*command, arguments->options);
  command->add_option("--controller", arguments->options.overrides.controller,
                      "One controller in place of the scenario's");
  constexpr int most = 1'000'000;
  command->add_option("--budget", arguments->budget, "Schedules of faults to try, before the worst is made small")
      ->capture_default_str()
      ->check(CLI::Range(1, most));
  command->add_option("--metric", arguments->metric,
                      "Metric that is to be hurt; otherwise that of `expect` under search, or lost");
  command->add_flag("--random", arguments->random, "Compare with as many random draws, which are played besides");
  command->add_option("--out", arguments->out, "Directory, new or of this search; otherwise one under runs/");
  add_playing_options(*command, arguments->playing);
  command->callback([arguments] { search(*arguments); });
}

}  // namespace evbal
