#include "tools/evbal/playing_options.hpp"

#include "common/yaml.hpp"
#include "tools/evbal/study_progress.hpp"
#include "tools/evbal/usage_error.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>

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
  const auto set_limit = [&playing](const std::string& text) {
    constexpr double second = 1.0 / 60.0;
    constexpr double week = 7.0 * 24.0 * 60.0;
    const double minutes = YamlValue::parse(text, "--day-limit").duration(second, week);
    playing.day_limit = std::chrono::seconds(std::lround(60.0 * minutes));
  };
  command.add_option_function<std::string>("--day-limit", set_limit,
                                           "End a day that takes longer than this, such as 10min; it has failed then");
  command.add_flag("--quiet", options.quiet, "Without progress");
}

std::vector<FailedDay> play_shown(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                                  const PlayingOptions& options) {
  warn_of_other_programs(folder.file(), keys);
  StudyProgress progress(options.quiet);
  Playing playing = options.playing;
  playing.on_day_ended = progress.shown_days();
  return play_sweep(sweep, keys, folder, playing);
}

}  // namespace evbal
