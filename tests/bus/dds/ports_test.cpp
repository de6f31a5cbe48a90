// Other programs have UDP ports that a run would take.

#include "agents/bus/ports.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"
#include "experiments/conductor/dds_players.hpp"
#include "tests/bus/dds/fake_answers.hpp"
#include "tests/bus/dds/run_processes.hpp"
#include "tests/folder.hpp"
#include "tests/held_ports.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr int ports_of_a_domain = 250;

DdsRun run_in(const fs::path& folder) {
  return {.folder = folder, .regions = 3, .programs = own_folder() / "fakes", .patience = 20s};
}

int domain_of(const fs::path& folder) {
  return std::stoi(test::word_after(test::find_process(folder, "agent-0"), "--domain"));
}

TEST(Ports, OfADomainInUseAreLeftToTheOthers) {
  const Folder folder;
  const int next = DomainLock(6).domain();
  const HeldPorts held(discovery_port(next, 0), 4);
  DdsPlayers players(run_in(folder.path()));
  EXPECT_NE(domain_of(folder.path()), next);  // perhaps one before it, which another run has just left
  EXPECT_EQ(players.play(fake::tick(0, 3)).departures.size(), 3U);
}

TEST(Ports, OfThreeDomainsInUseAreLeftToTheOthers) {
  const Folder folder;
  const int next = DomainLock(6).domain();
  const HeldPorts held(discovery_port(next, 0), 3 * ports_of_a_domain);
  DdsPlayers players(run_in(folder.path()));
  const int domain = domain_of(folder.path());
  EXPECT_TRUE(domain < next || domain >= next + 3) << domain;
  EXPECT_EQ(players.play(fake::tick(0, 3)).departures.size(), 3U);
}

TEST(Ports, AreOfAnAddressThatThisMachineHas) {
  EXPECT_TRUE(is_own_address("127.0.0.1"));
  try {
    const Participant participant({.run = "1-1", .domain = 1, .participant = 3, .participants = 4, .host = "127.0.0.2"},
                                  "a");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "address 127.0.0.2: no network interface of this machine has it; `ip address` shows those that do");
  }
}

TEST(Ports, OfAParticipantAreItsOwnOrItSaysWhichIsNot) {
  const DomainLock lock(4);
  for (const int offset : {0, 1}) {
    const int port = discovery_port(lock.domain(), 3) + offset;
    const HeldPorts held(port, 1);
    try {
      const Participant participant({.run = "1-1", .domain = lock.domain(), .participant = 3, .participants = 4}, "a");
      FAIL() << "Fast DDS took another port than " << port;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::run_failed);
      EXPECT_EQ(std::string(error.what()),
                "UDP port " + std::to_string(port) + " of 127.0.0.1 cannot be had: Address already in use");
    }
  }
}

TEST(Ports, TakenWhileARunBeginsMakeItBeginAgain) {
  const Folder folder;
  const fs::path taken = folder.path() / "taken";
  DdsRun run = run_in(folder.path());
  const std::string late = "while ! [ -e " + taken.string() + " ]; do sleep 0.01; done; exec " +
                           (own_folder() / "fakes" / "evbal-coordinator").string() + " \"$@\"";
  run.coordinator = {"/bin/sh", "-c", late, "late"};
  std::optional<HeldPorts> held;
  int first = 0;
  std::thread thief([&] {
    pid_t coordinator = 0;
    for (int i = 0; i < 1000 && coordinator == 0; ++i) {
      std::this_thread::sleep_for(10ms);
      coordinator = test::find_process(folder.path(), "coordinator");
    }
    first = std::stoi("0" + test::word_after(coordinator, "--domain"));
    held.emplace(discovery_port(first, BusAddress::coordinator), 1);
    std::ofstream(taken) << "by another program";
  });
  DdsPlayers players(run);
  thief.join();
  EXPECT_GT(first, 0);
  EXPECT_GT(domain_of(folder.path()), first);
  EXPECT_EQ(players.play(fake::tick(0, 3)).departures.size(), 3U);
}

}  // namespace
}  // namespace evbal
