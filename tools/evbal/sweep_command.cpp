#include "tools/evbal/sweep_command.hpp"

#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "experiments/study/design/study_file.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "experiments/study/store/bound_keys.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tools/evbal/bounded_days.hpp"
#include "tools/evbal/filter_options.hpp"
#include "tools/evbal/replayed_days.hpp"
#include "tools/evbal/study_page.hpp"
#include "tools/evbal/sweep_bounds.hpp"
#include "tools/evbal/sweep_plan.hpp"
#include "tools/evbal/tune_command.hpp"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>

namespace evbal {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const SweepArguments& arguments) {
  const std::string name = arguments.sweep.stem().string() + (arguments.quick ? "-quick" : "");
  return arguments.out.empty() ? fs::path("runs") / name : fs::path(arguments.out);
}

/// What the sweep's tuning froze; an empty path if it has none.
fs::path tuned_first(const SweepArguments& arguments) {
  const fs::path tuning = tuning_of(find_study(arguments.sweep));
  return tuning.empty() ? fs::path() : tune({tuning, folder_of(arguments), arguments.quick, arguments.options});
}

std::string command_of(const SweepArguments& arguments) {
  return "evbal sweep " + arguments.sweep.string() + (arguments.quick ? " --quick" : "");
}

SweepOrigin origin_of(const SweepArguments& arguments, const fs::path& file, const SweptDay& first) {
  return {.command = command_of(arguments),
          .file = arguments.sweep.string(),
          .text = text_of_file(file),
          .scenario = resolved_yaml(scenario_of(first), first.controller)};
}

/// What is played and what is left; nothing is played.
std::string plan_of(const SweepArguments& arguments, const DayFilter& filter) {
  const fs::path file = find_study(arguments.sweep);
  const fs::path folder = folder_of(arguments);
  const bool is_tuned = fs::exists(folder / tuned_file_name);
  if (!tuning_of(file).empty() && !is_tuned) {
    return arguments.sweep.string() + ": tunes its variants first; its days are known after that\n";
  }
  Sweep sweep = read_sweep(file, {arguments.quick, is_tuned ? folder / tuned_file_name : fs::path()});
  sweep.days = filtered(filter, sweep.days);
  const int jobs = arguments.options.playing.jobs;
  const fs::path results = folder / sweep_file_name;
  return sweep_plan(sweep, keys_of(sweep), seconds_of_results(results), failures_in(results),
                    jobs > 0 ? jobs : cores());
}

/// A whole command line.
struct SweepRequest {
  SweepArguments arguments;
  bool dry_run = false;
  DayFilter filter;                     ///< of the dry run
  int replay = 0;                       ///< days to be played again
  std::optional<std::uint64_t> seed{};  ///< of their choice
};

/// Plays some days of a sweep again that has been played.
std::string replay_of(const SweepRequest& asked) {
  catch_interrupts();
  const SweepArguments& arguments = asked.arguments;
  const fs::path file = find_study(arguments.sweep);
  const fs::path folder = folder_of(arguments);
  const fs::path tuned = tuning_of(file).empty() ? fs::path() : folder / tuned_file_name;
  const Sweep sweep = read_sweep(file, {arguments.quick, tuned});
  return replay_days(sweep, folder / sweep_file_name, static_cast<std::size_t>(asked.replay),
                     asked.seed ? *asked.seed : std::random_device{}(), arguments.options) +
         "\n";
}

std::string answer(const SweepRequest& asked) {
  if (asked.dry_run) {
    return plan_of(asked.arguments, asked.filter);
  }
  return asked.replay > 0 ? replay_of(asked) : sweep(asked.arguments).string() + "\n";
}

}  // namespace

fs::path sweep(const SweepArguments& arguments) {
  catch_interrupts();
  const fs::path file = find_study(arguments.sweep);
  const Sweep sweep = read_sweep(file, {arguments.quick, tuned_first(arguments)});
  const std::vector<std::string> keys = keys_of(sweep);
  const SweepFolder folder(folder_of(arguments), sweep_file_name);
  for (const char* csv : {"days.csv", "steps.csv", "failed.csv", "page.md"}) {
    fs::remove(folder.path() / csv);
  }
  begin_results(folder.file());
  note_origin(folder.file(), origin_of(arguments, file, sweep.days.front()));
  note_bound_keys(folder.file(), bound_keys_of(sweep));
  const std::vector<FailedDay> failed = play_shown(sweep, keys, folder, arguments.options);
  write_file(folder.path() / "steps.csv", swept_steps_csv(folder.file()));
  write_file(folder.path() / "days.csv", swept_days_csv(folder.file()));
  if (!failed.empty()) {
    write_file(folder.path() / "failed.csv", failed_days_csv(folder.file()));
  }
  refuse_failed(failed, sweep);
  bound_days(sweep, arguments.options);
  if (sweep.page) {
    write_study_page(folder.path(), read_study_page(folder.path()));
  }
  return folder.path() / "days.csv";
}

void add_sweep_command(CLI::App& app) {
  const auto asked = std::make_shared<SweepRequest>();
  CLI::App* command = app.add_subcommand("sweep", "Play the days of a sweep that are not played yet");
  SweepArguments& arguments = asked->arguments;
  command->add_option("SWEEP", arguments.sweep, "Sweep file (YAML), or the name of a shipped one")->required();
  command->add_option("--out", arguments.out, "Directory, new or of this sweep; otherwise one under runs/");
  command->add_flag("--quick", arguments.quick,
                    "Two days, one seed and two values of each setting only, to see every part");
  CLI::Option* plan_only = command->add_flag(
      "--dry-run", asked->dry_run, "Say what is played, failed and left, and how long that will take; play nothing");
  command
      ->add_option("--replay", asked->replay,
                   "Play so many of its days again, chosen at random, and compare their digests with those stored")
      ->check(CLI::PositiveNumber)
      ->excludes(plan_only);
  command->add_option("--seed", asked->seed, "Choice of these days; otherwise drawn, and told")->needs("--replay");
  add_playing_options(*command, arguments.options);
  for (CLI::Option* option : add_filter_options(*command, asked->filter)) {
    option->needs(plan_only);
  }
  command->callback([asked] { std::fputs(answer(*asked).c_str(), stdout); });
}

}  // namespace evbal
