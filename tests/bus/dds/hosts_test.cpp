// Days whose agents are on other hosts: here each keeper is started on this machine, which is all the same to both
// ends.

#include "common/error.hpp"
#include "tests/bus/dds/toy_day.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

pid_t parent_of(std::int64_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(in, line);
  const auto name_ends = line.rfind(')');
  return name_ends == std::string::npos ? 0 : std::atoi(line.c_str() + name_ends + 4);
}

/// The keepers of the agents that spoke in a tick, by region.
std::map<int, pid_t> keepers_in(const TickRecord& record) {
  std::map<int, pid_t> keepers;
  for (const auto& said : record.exchange.departures) {
    keepers[said.region] = parent_of(said.origin.process_id);
  }
  return keepers;
}

/// Everything on a host dies at once: the keeper, with it its agents, and the shell that would remove their folder.
void take_down(pid_t keeper) {
  const pid_t shell = parent_of(keeper);
  kill(shell, SIGKILL);
  kill(keeper, SIGKILL);
}

class HostsTest : public test::ToyDay {
 protected:
  HostsTest() {
    end_at_eleven();
    fs::create_directories(temporary());
    setenv("TMPDIR", temporary().c_str(), 1);
    hosts_ = {{.address = "127.0.0.1", .weight = 2}, {.address = "127.0.0.1", .weight = 3}};
  }
  ~HostsTest() override { unsetenv("TMPDIR"); }

  fs::path temporary() const { return folder_.path() / "there"; }

  /// What other hosts have of the run.
  std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(temporary())) {
      names.push_back(entry.path().filename());
    }
    return names;
  }
};

TEST_F(HostsTest, MakeNoDifferenceToTheDay) {
  std::map<int, pid_t> keepers;
  std::vector<std::string> names;
  EXPECT_EQ(digest_over_dds(1,
                            [&](const TickRecord& record) {
                              keepers = keepers.empty() ? keepers_in(record) : keepers;
                              names = left();
                            }),
            digest_in_process());
  ASSERT_EQ(keepers.size(), 5U);
  EXPECT_EQ(keepers[0], keepers[1]);
  EXPECT_NE(keepers[1], keepers[2]) << "weights 2 and 3";
  EXPECT_EQ(keepers[2], keepers[4]);
  EXPECT_NE(keepers[0], getpid());
  EXPECT_EQ(names.size(), 2U) << "a folder for each host";
  EXPECT_EQ(left(), std::vector<std::string>{});
}

TEST_F(HostsTest, AreLeftForOthersWhenTheyDie) {
  const std::string undisturbed = digest_in_process();
  std::map<int, pid_t> last;
  int gone = 0;
  const std::string disturbed = digest_over_dds(1, [&](const TickRecord& record) {
    last = keepers_in(record);
    if (record.tick.tick == 20) {
      take_down(last[4]);
    }
    for (const auto& incident : record.exchange.incidents) {
      gone += incident.kind == "host gone" ? 1 : 0;
    }
  });
  EXPECT_EQ(disturbed, undisturbed);
  EXPECT_EQ(gone, 1);
  EXPECT_EQ(last[4], last[0]) << "all are on the host that is left";
}

TEST_F(HostsTest, AreLeftInTheMiddleOfATick) {
  const std::string undisturbed = digest_in_process();
  std::jthread disturber;
  const std::string disturbed = digest_over_dds(1, [&](const TickRecord& record) {
    if (record.tick.tick == 20) {
      const auto waited_for = static_cast<pid_t>(record.exchange.departures[0].origin.process_id);
      kill(waited_for, SIGSTOP);
      disturber = std::jthread([waited_for, dying = keepers_in(record)[4]] {
        std::this_thread::sleep_for(500ms);  // until those on the other host have answered
        take_down(dying);
        std::this_thread::sleep_for(100ms);  // until they are started again, and do not hear anything yet
        kill(waited_for, SIGCONT);
      });
    }
  });
  EXPECT_EQ(disturbed, undisturbed);
}

TEST_F(HostsTest, BringKilledAgentsBack) {
  const std::string undisturbed = digest_in_process();
  int ended = 0;
  EXPECT_EQ(digest_over_dds(1,
                            [&](const TickRecord& record) {
                              if (record.tick.tick % 10 == 5) {
                                kill(static_cast<pid_t>(record.exchange.departures[3].origin.process_id), SIGKILL);
                              }
                              for (const auto& incident : record.exchange.incidents) {
                                ended += incident.kind == "process ended" ? 1 : 0;
                              }
                            }),
            undisturbed);
  EXPECT_GE(ended, 6);
}

TEST_F(HostsTest, AreTakenDownByScheduleAsInOneProcess) {
  Fault down;
  down.name = "down";
  down.type = EffectType::host_down;
  down.regions = regions_by_host(hosts_, 5, 1).at(1);
  down.magnitudes.assign(down.regions.size(), 0.0);
  down.start = 60;
  down.duration = 45;
  scenario_.schedule.faults.push_back(down);
  Fault pause = down;
  pause.name = "pause";
  pause.type = EffectType::process_pause;
  pause.regions = {0};
  pause.magnitudes = {0.0};
  scenario_.schedule.faults.push_back(pause);
  write_scenario();
  int absent = 0;
  EXPECT_EQ(digest_over_dds(1, [&](const TickRecord& record) { absent += record.tick.due.size() == 1U ? 1 : 0; }),
            digest_in_process());
  EXPECT_EQ(absent, 9) << "45 minutes without regions 0, 2, 3 and 4";
}

TEST_F(HostsTest, EndTheRunByNameWhenNoneIsLeft) {
  hosts_.resize(1);
  try {
    digest_over_dds(1, [&](const TickRecord& record) {
      if (record.tick.tick == 3) {
        take_down(keepers_in(record)[0]);
      }
    });
    ADD_FAILURE() << "the run goes on without a host";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::run_failed);
    EXPECT_NE(std::string(error.what()).find("no host is left: 127.0.0.1 (local): its keeper "), std::string::npos)
        << error.what();
  }
}

TEST_F(HostsTest, AreNamedIfTheyCannotBeReached) {
  const fs::path programs = folder_.path() / "bin";
  fs::create_directories(programs);
  folder_.write("bin/ssh", "#!/bin/sh\necho 'b: no such host' >&2; exit 255\n");
  fs::permissions(programs / "ssh", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (programs.string() + ":" + path).c_str(), 1);
  hosts_.back().start = {"ssh", "b"};
  try {
    digest_over_dds(1);
    ADD_FAILURE() << "a host that nobody reaches";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("127.0.0.1 (ssh b): its keeper ended with status 255: b: no such host"),
              std::string::npos)
        << error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(left(), std::vector<std::string>{});
}

}  // namespace
}  // namespace evbal
