#include "tools/evbal/playing_options.hpp"

#include "tools/evbal/study_progress.hpp"
#include "tools/evbal/usage_error.hpp"

#include <CLI/CLI.hpp>

namespace evbal {
namespace {

std::string jobs_complaint(const std::string& text) {
  const bool whole = text.find_first_not_of("0123456789") == std::string::npos;
  return whole && text.find_first_not_of('0') != std::string::npos ? "" : "give a whole number, at least 1";
}

}  // namespace

void add_playing_options(CLI::App& command, PlayingOptions& options) {
  Playing& playing = options.playing;
  command.add_option("--jobs", playing.jobs, "Days at a time; otherwise one a core, or as many as Slurm likes")
      ->check(jobs_complaint);
  command.add_option("--executor", playing.executor, "Who plays the days: this machine (local) or job arrays (slurm)")
      ->check(one_of_words({"local", "slurm"}));
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
