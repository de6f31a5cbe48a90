#include "tools/evbal/slurm_task_command.hpp"

#include "experiments/study/executors/slurm.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace evbal {

void add_slurm_task_command(CLI::App& app) {
  const auto scenario = std::make_shared<std::filesystem::path>();
  CLI::App* command = app.add_subcommand("slurm-task", "Play one day of a sweep, as its job array asks for");
  command->group("");  // not shown
  command->add_option("SCENARIO", *scenario, "Resolved scenario, named after its day's key")->required();
  command->callback([scenario] { play_slurm_task(*scenario); });
}

}  // namespace evbal
