#include "tools/evbal/sweep_command.hpp"

#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "experiments/study/design/study_file.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/statistics/page_markdown.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tools/evbal/tune_command.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

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

}  // namespace

fs::path sweep(const SweepArguments& arguments) {
  catch_interrupts();
  const fs::path file = find_study(arguments.sweep);
  const Sweep sweep = read_sweep(file, {arguments.quick, tuned_first(arguments)});
  const std::vector<std::string> keys = keys_of(sweep);
  const SweepFolder folder(folder_of(arguments), sweep_file_name);
  for (const char* csv : {"days.csv", "steps.csv", "page.md"}) {
    fs::remove(folder.path() / csv);
  }
  play_shown(sweep, keys, folder, arguments.options);
  const SweptDay& first = sweep.days.front();
  const std::string command = "evbal sweep " + arguments.sweep.string() + (arguments.quick ? " --quick" : "");
  note_origin(folder.file(), {.command = command,
                              .file = arguments.sweep.string(),
                              .text = text_of_file(file),
                              .scenario = resolved_yaml(scenario_of(first), first.controller)});
  write_file(folder.path() / "steps.csv", swept_steps_csv(folder.file()));
  write_file(folder.path() / "days.csv", swept_days_csv(folder.file()));
  if (sweep.page) {
    write_file(folder.path() / "page.md", page_markdown(*sweep.page, read_finished(folder.file()), command));
  }
  return folder.path() / "days.csv";
}

void add_sweep_command(CLI::App& app) {
  const auto arguments = std::make_shared<SweepArguments>();
  CLI::App* command = app.add_subcommand("sweep", "Play the days of a sweep that are not played yet");
  command->add_option("SWEEP", arguments->sweep, "Sweep file (YAML), or the name of a shipped one")->required();
  command->add_option("--out", arguments->out, "Directory, new or of this sweep; otherwise one under runs/");
  command->add_flag("--quick", arguments->quick, "Two days and one seed only, to see every part");
  add_playing_options(*command, arguments->options);
  command->callback([arguments] { std::printf("%s\n", sweep(*arguments).c_str()); });
}

}  // namespace evbal
