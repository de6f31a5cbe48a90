// evbal-fake-run FOLDER REGIONS PER_PROCESS TICKS [secured]: a run with stand-ins. Prints what the exchange costs; a
// test also uses it as a launcher that it can interrupt or kill.

#include "agents/protocol/messages.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "experiments/conductor/dds_players.hpp"
#include "tests/bus/dds/fake_answers.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>

namespace {

using namespace evbal;

/// Kilobytes of one line of a process's memory account.
long memory(pid_t process, const std::string& line) {
  std::ifstream in("/proc/" + std::to_string(process) + "/smaps_rollup");
  for (std::string word; in >> word;) {
    long kilobytes = 0;
    if (word == line && in >> kilobytes) {
      return kilobytes;
    }
  }
  return 0;
}

void run(const DdsRun& given, int ticks) {
  DdsPlayers players(given);
  std::cout << "ready " << players.ready_seconds() << " s" << std::endl;
  double longest = 0.0;
  const auto begin = std::chrono::steady_clock::now();
  const auto since = [](auto time) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - time).count();
  };
  for (int tick = 0; tick < ticks; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    players.faults(tick);
    players.play(fake::tick(tick, given.regions));
    longest = std::max(longest, since(start));
  }
  std::cout << "tick " << since(begin) / ticks << " ms, longest " << longest << " ms\n"
            << "agent-0: " << memory(players.process_id("agent-0"), "Pss:") << " kB proportional, "
            << memory(players.process_id("agent-0"), "Private_Dirty:") << " kB private\n";
}

}  // namespace

int main(int argc, char** argv) {
  const bool secured = argc == 6 && std::string(argv[5]) == "secured";
  if (argc != 5 && !secured) {
    std::cerr << "usage: evbal-fake-run FOLDER REGIONS PER_PROCESS TICKS [secured]\n";
    return 2;
  }
  catch_interrupts();
  try {
    run({.folder = argv[1],
         .regions = std::atoi(argv[2]),
         .regions_per_process = std::atoi(argv[3]),
         .programs = own_folder() / "fakes",
         .security = secured ? std::optional(BusSecurity{}) : std::nullopt},
        std::atoi(argv[4]));
    return 0;
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.status());
  }
}
