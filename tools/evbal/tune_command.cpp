#include "tools/evbal/tune_command.hpp"

#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "experiments/study/design/tuning.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "tools/evbal/playing_options.hpp"

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
  const Tuning tuning = read_tuning(arguments.tuning, arguments.quick);
  std::vector<Contest> contests = contests_of(tuning);
  Sweep round = round_of(tuning, contests);
  std::vector<std::string> keys = keys_of(round);
  const SweepFolder folder(arguments.out);
  while (true) {
    play_sweep(round, keys, folder, arguments.playing);
    judge_round(tuning, read_finished(folder.file()), contests);
    if (!undecided(contests)) {
      break;
    }
    round = round_of(tuning, contests);
    keys = keys_of(round);
  }
  write_file(folder.path() / "trials.csv", trials_csv(tuning, contests));
  write_file(folder.path() / "tuned.yaml", tuned_yaml(winners(tuning, contests)));
  return folder.path() / "tuned.yaml";
}

void add_tune_command(CLI::App& app) {
  const auto arguments = std::make_shared<TuneArguments>();
  CLI::App* command = app.add_subcommand("tune", "Find every controller's settings on training days");
  command->add_option("TUNING", arguments->tuning, "Tuning file (YAML)")->required();
  command->add_option("--out", arguments->out, "Directory, new or of this tuning; otherwise one under runs/");
  command->add_flag("--quick", arguments->quick, "Four candidates, one day and one seed only");
  add_playing_options(*command, arguments->playing);
  command->callback([arguments] { tune_at(*arguments); });
}

}  // namespace evbal
