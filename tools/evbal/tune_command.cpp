#include "tools/evbal/tune_command.hpp"

#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "experiments/study/design/study_file.hpp"
#include "experiments/study/design/tuning.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/statistics/tuning_outcome.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "tools/evbal/console_table.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace evbal {
namespace {

namespace fs = std::filesystem;

void tune_at(TuneArguments arguments) {
  catch_interrupts();
  if (arguments.out.empty()) {
    arguments.out = fs::path("runs") / arguments.tuning.stem();
  }
  std::printf("%s\n", tune(arguments).c_str());
}

}  // namespace

fs::path tune(const TuneArguments& arguments) {
  const Tuning tuning = read_tuning(find_study(arguments.tuning), arguments.quick);
  std::vector<Contest> contests = contests_of(tuning);
  Sweep round = round_of(tuning, contests);
  std::vector<std::string> keys = keys_of(round);
  const SweepFolder folder(arguments.out, tuning_file_name);
  while (true) {
    play_shown(round, keys, folder, arguments.options);
    judge_round(tuning, read_finished(folder.file()), contests);
    if (!undecided(contests)) {
      break;
    }
    round = round_of(tuning, contests);
    keys = keys_of(round);
  }
  write_file(folder.path() / "candidates.csv", candidates_csv(tuning, contests));
  const Tuned tuned = judged_winners(tuning, contests);
  write_file(folder.path() / tuned_file_name, tuned_yaml(tuned));
  if (!arguments.options.quiet) {
    std::fputs(aligned(tuned_rows(tuned), 2).c_str(), stderr);
  }
  return folder.path() / tuned_file_name;
}

void add_tune_command(CLI::App& app) {
  const auto arguments = std::make_shared<TuneArguments>();
  CLI::App* command = app.add_subcommand("tune", "Find every controller's settings on training days");
  command->add_option("TUNING", arguments->tuning, "Tuning file (YAML), or the name of a shipped one")->required();
  command->add_option("--out", arguments->out, "Directory, new or of this tuning; otherwise one under runs/");
  command->add_flag("--quick", arguments->quick, "Four candidates, one day and one seed only");
  add_playing_options(*command, arguments->options);
  command->callback([arguments] { tune_at(*arguments); });
}

}  // namespace evbal
