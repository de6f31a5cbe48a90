#include "tools/evbal/playing_options.hpp"

#include "tools/evbal/study_progress.hpp"

#include <CLI/CLI.hpp>

namespace evbal {

void add_playing_options(CLI::App& command, PlayingOptions& options) {
  Playing& playing = options.playing;
  command.add_option("--jobs", playing.jobs, "Days at a time; otherwise one a core, or as many as Slurm likes")
      ->check(CLI::PositiveNumber);
  command.add_option("--executor", playing.executor, "Who plays the days: this machine (local) or job arrays (slurm)")
      ->check(CLI::IsMember({"local", "slurm"}));
  command.add_flag("--quiet", options.quiet, "Without progress");
}

void play_shown(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                const PlayingOptions& options) {
  warn_of_other_programs(folder.file(), keys);
  StudyProgress progress(options.quiet);
  Playing playing = options.playing;
  playing.on_day_ended = progress.shown_days();
  play_sweep(sweep, keys, folder, playing);
}

}  // namespace evbal
