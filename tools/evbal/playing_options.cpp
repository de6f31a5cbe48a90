#include "tools/evbal/playing_options.hpp"

#include <CLI/CLI.hpp>

namespace evbal {

void add_playing_options(CLI::App& command, Playing& playing) {
  command.add_option("--jobs", playing.jobs, "Days at a time; otherwise one a core")->check(CLI::PositiveNumber);
  command.add_option("--executor", playing.executor, "Who plays the days: this machine (local) or job arrays (slurm)")
      ->check(CLI::IsMember({"local", "slurm"}));
  command.add_flag("--quiet", playing.quiet, "Without progress");
}

}  // namespace evbal
