#include "tools/evbal/replay_command.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "common/scratch_folder.hpp"
#include "experiments/record/compare.hpp"
#include "experiments/run/record_day.hpp"
#include "tools/evbal/day_progress.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace evbal {
namespace {

namespace fs = std::filesystem;

void replay(const fs::path& folder, bool quiet) {
  catch_interrupts();
  const fs::path file = folder / "scenario.resolved.yaml";
  if (fs::exists(folder / "INCOMPLETE") || !fs::exists(file)) {
    throw bad_input(folder.string() + ": holds no finished run; give a directory that `evbal run` wrote to its end");
  }
  const ScratchFolder scratch;
  try {
    const Scenario scenario = read_scenario(file);
    const RunResult again = record_day(scenario, text_of_file(file), scratch.path(),
                                       {.transport = own_transport(scenario), .on_tick = shown_day(scenario, quiet)});
    if (const auto difference = first_difference(folder, scratch.path(), scenario.world.clock)) {
      throw run_failed(*difference);
    }
    std::printf("%s: the same in every tick, digest %s\n", folder.c_str(), again.digest.c_str());
  } catch (const Error& error) {
    if (error.status() == ExitStatus::bad_input && !scenario_is_original(folder)) {
      throw run_failed(std::string(error.what()) +
                       "; the file is not what the run was made from (tick 0, all regions)");
    }
    throw;
  }
}

}  // namespace

void add_replay_command(CLI::App& app) {
  struct Arguments {
    std::string folder;
    bool quiet = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("replay", "Run again what a run directory holds and compare every value");
  command->add_option("DIR", arguments->folder, "Run directory")->required();
  command->add_flag("--quiet", arguments->quiet, "Without progress");
  command->callback([arguments] { replay(arguments->folder, arguments->quiet); });
}

}  // namespace evbal
