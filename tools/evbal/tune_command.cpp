#include "tools/evbal/tune_command.hpp"

#include "common/error.hpp"
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
#include <string>
#include <vector>

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

/// Throws Error{run_failed} if a variant has no candidate of which every day was played.
void refuse_hopeless(const Tuning& tuning, const std::vector<Contest>& contests, const std::vector<FailedDay>& failed) {
  for (const auto& contest : contests) {
    if (!contest.candidates.front().has_played()) {
      throw run_failed("every candidate of " + tuning.variants[contest.variant].name + " in " + contest.scenario +
                       " has days that failed; the same command tries them again:" + shown(failed));
    }
  }
}

}  // namespace

fs::path tune(const TuneArguments& arguments) {
  const Tuning tuning = read_tuning(find_study(arguments.tuning), arguments.quick);
  std::vector<Contest> contests = contests_of(tuning);
  Sweep round = round_of(tuning, contests);
  std::vector<std::string> keys = keys_of(round);
  const SweepFolder folder(arguments.out, tuning_file_name);
  std::vector<FailedDay> failed;
  while (true) {
    const std::vector<FailedDay> failed_now = play_shown(round, keys, folder, arguments.options);
    failed.insert(failed.end(), failed_now.begin(), failed_now.end());
    judge_round(tuning, read_asked_for(folder.file()), contests);
    refuse_hopeless(tuning, contests, failed);
    if (!undecided(contests)) {
      break;
    }
    round = round_of(tuning, contests);
    keys = keys_of(round);
  }
  write_file(folder.path() / "candidates.csv", candidates_csv(tuning, contests));
  const Tuned tuned = judged_winners(tuning, contests);
  write_file(folder.path() / tuned_file_name, tuned_yaml(tuned));
  if (!failed.empty()) {
    std::fprintf(stderr, "evbal: %zu days of the tuning failed twice; a candidate with such a day cannot win:%s\n",
                 failed.size(), shown(failed).c_str());
  }
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
