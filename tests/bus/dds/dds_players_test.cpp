#include "experiments/conductor/dds_players.hpp"

#include "agents/bus/ports.hpp"
#include "agents/hosting/process.hpp"
#include "agents/protocol/fingerprint.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "tests/bus/dds/fake_answers.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>
#include <set>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class DdsPlayersTest : public testing::Test {
 protected:
  DdsRun run(int regions, int regions_per_process) const {
    return {.folder = folder_.path(),
            .regions = regions,
            .regions_per_process = regions_per_process,
            .programs = own_folder() / "fakes",
            .patience = 60s};
  }

  Folder folder_;
};

template <class Message>
std::string digest(const Message& message) {
  Digest digest;
  fingerprint(digest, message);
  return digest.hex();
}

void expect_whole(const Exchange& exchange, const Tick& tick) {
  ASSERT_EQ(exchange.departures.size(), tick.due.size());
  ASSERT_EQ(exchange.plan.has_value(), tick.plan_due);
  ASSERT_EQ(exchange.reports.size(), tick.plan_due ? tick.due.size() : 0);
  for (std::size_t i = 0; i < exchange.reports.size(); ++i) {
    EXPECT_EQ(digest(exchange.reports[i]), digest(fake::report(tick.tick, static_cast<int>(i))));
  }
  if (tick.plan_due) {
    EXPECT_EQ(digest(*exchange.plan), digest(fake::plan(tick, exchange.reports)));
  }
  const Plan* plan = exchange.plan ? &*exchange.plan : nullptr;
  for (std::size_t i = 0; i < exchange.departures.size(); ++i) {
    EXPECT_EQ(digest(exchange.departures[i]), digest(fake::departures(tick, plan, static_cast<int>(i))));
  }
}

TEST_F(DdsPlayersTest, EveryWordComesThrough) {
  DdsPlayers players(run(5, 1));
  for (int tick = 0; tick < 40; ++tick) {
    EXPECT_EQ(digest(players.faults(tick)), digest(fake::faults(tick)));
    const Tick message = fake::tick(tick, 5);
    expect_whole(players.play(message), message);
  }
}

TEST_F(DdsPlayersTest, RegionsMayShareAProcess) {
  DdsPlayers players(run(5, 2));
  const Tick message = fake::tick(0, 5);
  const Exchange exchange = players.play(message);
  expect_whole(exchange, message);
  EXPECT_EQ(exchange.departures[0].origin.process_id, players.process_id("agent-0"));
  EXPECT_EQ(exchange.departures[1].origin.process_id, players.process_id("agent-0"));
  EXPECT_EQ(exchange.departures[4].origin.process_id, players.process_id("agent-2"));
}

TEST_F(DdsPlayersTest, EveryoneSpeaksFromItsOwnProcess) {
  DdsPlayers players(run(3, 1));
  const Exchange exchange = players.play(fake::tick(0, 3));
  std::set<std::int64_t> processes = {getpid(), players.faults(0).origin.process_id, exchange.plan->origin.process_id};
  for (const auto& report : exchange.reports) {
    processes.insert(report.origin.process_id);
  }
  EXPECT_EQ(processes.size(), 6U);
  EXPECT_EQ(exchange.plan->origin.process_id, players.process_id("coordinator"));
}

TEST_F(DdsPlayersTest, LongMessagesComeThrough) {
  DdsPlayers players(run(3, 3));
  Tick message = fake::tick(0, 3);
  message.arrivals.resize(20000);
  expect_whole(players.play(message), message);
}

std::string complaint(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::run_failed);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

TEST_F(DdsPlayersTest, NamesTheProcessThatDiesAgainAndAgain) {
  DdsPlayers players(run(3, 1));
  players.play(fake::tick(0, 3));
  const std::string message = complaint([&] { players.play(fake::tick(fake::deadly_tick, 3)); });
  EXPECT_NE(message.find("agent-1"), std::string::npos) << message;
  EXPECT_NE(message.find("signal 9"), std::string::npos) << message;
  EXPECT_NE(message.find("deaths in a row"), std::string::npos) << message;
}

TEST_F(DdsPlayersTest, LeavesNoJournals) {
  {
    DdsPlayers players(run(3, 1));
    players.play(fake::tick(0, 3));
    EXPECT_FALSE(fs::is_empty(folder_.path() / "journals"));
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "journals"));
}

TEST_F(DdsPlayersTest, NamesTheProcessThatHangs) {
  DdsRun given = run(3, 1);
  given.patience = 5s;
  DdsPlayers players(given);
  players.play(fake::tick(0, 3));
  ASSERT_EQ(kill(players.process_id("coordinator"), SIGSTOP), 0);
  const std::string message = complaint([&] { players.play(fake::tick(2, 3)); });
  EXPECT_NE(message.find("no plan of tick 2 from coordinator"), std::string::npos) << message;
}

TEST_F(DdsPlayersTest, ShowsTheLastWordsOfAProcessThatDoesNotCome) {
  DdsRun given = run(3, 1);
  given.patience = 3s;
  given.coordinator = {"/bin/sh", "-c", "echo asking for a licence; exec sleep 60"};
  const std::string message = complaint([&] { const DdsPlayers players(given); });
  EXPECT_NE(message.find("no hello from coordinator within 3 s: asking for a licence"), std::string::npos) << message;
}

TEST_F(DdsPlayersTest, ShowsTheLastWordsOfAProcessThatFails) {
  Supervisor supervisor(folder_.path());
  supervisor.start("sad", "/bin/sh", {"-c", "echo oh no >&2; exit 7"});
  const std::string message = complaint([&] {
    for (int i = 0; i < 1000; ++i) {
      supervisor.revive();
      std::this_thread::sleep_for(5ms);
    }
  });
  EXPECT_NE(message.find("sad"), std::string::npos) << message;
  EXPECT_NE(message.find("status 7: oh no"), std::string::npos) << message;
}

TEST_F(DdsPlayersTest, DoesNotStartAgainAProcessThatAborts) {
  for (const char* signal : {"ABRT", "SEGV", "FPE"}) {
    Supervisor supervisor(folder_.path());
    supervisor.start("sad", "/bin/sh", {"-c", std::string("echo no memory >&2; kill -") + signal + " $$"});
    const std::string message = complaint([&] {
      for (int i = 0; i < 2000; ++i) {
        EXPECT_TRUE(supervisor.revive().empty()) << signal;
        std::this_thread::sleep_for(5ms);
      }
    });
    EXPECT_NE(message.find("sad: process"), std::string::npos) << message;
    EXPECT_NE(message.find("was ended by signal"), std::string::npos) << message;
    EXPECT_NE(message.find(": no memory"), std::string::npos) << message;
    EXPECT_EQ(message.find("in a row"), std::string::npos) << message;
  }
}

std::set<std::string> shared_memory() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator("/dev/shm")) {
    names.insert(entry.path().filename());
  }
  return names;
}

/// Processes whose command line has `word`.
int processes_with(const std::string& word) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream in(entry.path() / "cmdline");
    std::string line;
    std::getline(in, line);  // nothing if the process has just ended
    count += line.find(word) != std::string::npos ? 1 : 0;
  }
  return count;
}

/// Waits up to 10 s.
bool comes_true(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) {
      return true;
    }
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

/// A run of so many regions in a launcher of its own.
class Launcher {
 public:
  Launcher(const fs::path& folder, int ticks, int regions = 5) {
    const std::string program = own_folder() / "evbal-fake-run";
    const std::string count = std::to_string(ticks);
    const std::string agents = std::to_string(regions);
    id_ = fork();
    if (id_ == 0) {
      execl(program.c_str(), program.c_str(), folder.c_str(), agents.c_str(), "1", count.c_str(), nullptr);
      _exit(99);
    }
  }
  ~Launcher() {
    if (!ended_) {
      end_by(SIGKILL);
    }
  }
  Launcher(const Launcher&) = delete;
  Launcher& operator=(const Launcher&) = delete;

  bool ended() {
    ended_ = ended_ || waitpid(id_, &status_, WNOHANG) == id_;
    return ended_;
  }

  void end_by(int signal) {
    kill(id_, signal);
    ended_ = waitpid(id_, &status_, 0) == id_;
  }

  /// -1 if a signal ended it.
  int exit_status() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

 private:
  pid_t id_ = 0;
  int status_ = 0;
  bool ended_ = false;
};

TEST_F(DdsPlayersTest, TwoRunsAtOnceDoNotMeet) {
  const Folder other_folder;
  Launcher other(other_folder.path(), 200);
  DdsPlayers players(run(3, 1));
  int ticks = 0;
  for (; !other.ended(); ++ticks) {
    const Tick message = fake::tick(ticks, 3);
    expect_whole(players.play(message), message);
  }
  EXPECT_GT(ticks, 10);
  EXPECT_EQ(other.exit_status(), 0);
}

/// A launcher in the middle of a run gets the signal; nothing may be left.
void end_launcher_by(int signal, const fs::path& folder) {
  const auto shared_before = shared_memory();
  Launcher launcher(folder, 1000000);
  const int all = 8;  // five agents, coordinator, faults and the launcher
  ASSERT_TRUE(comes_true([&] { return processes_with(folder) == all; }));
  std::this_thread::sleep_for(1s);
  launcher.end_by(signal);
  EXPECT_EQ(launcher.exit_status(), signal == SIGKILL ? -1 : 3);
  EXPECT_TRUE(comes_true([&] { return processes_with(folder) == 0; }));
  EXPECT_EQ(shared_memory(), shared_before);
}

TEST_F(DdsPlayersTest, InterruptedLauncherLeavesNothing) {
  end_launcher_by(SIGINT, folder_.path());
}

TEST_F(DdsPlayersTest, LauncherEndsWhileItStartsProcesses) {
  const int regions = 300;
  Launcher launcher(folder_.path(), 1, regions);
  ASSERT_TRUE(comes_true([&] { return processes_with(folder_.path()) >= 3; }));
  launcher.end_by(SIGTERM);
  EXPECT_EQ(launcher.exit_status(), 3);
  EXPECT_EQ(processes_with(folder_.path()), 0);
  const fs::directory_iterator logs(folder_.path() / "processes");
  EXPECT_LT(std::distance(fs::begin(logs), fs::end(logs)), regions) << "not all were started";
}

/// The status with which a run ends that is asked to within ten seconds; else 0.
int status_of_asked_run() {
  try {
    for (int i = 0; i < 1000; ++i, std::this_thread::sleep_for(10ms)) {
      check_interrupt();
    }
  } catch (const Error& error) {
    return static_cast<int>(error.status());
  }
  return 0;
}

TEST(InterruptDeathTest, SignalMayReachAnotherThread) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // TSan allows no threads after a fork
  EXPECT_EXIT(
      {
        catch_interrupts();
        std::thread other([] { raise(SIGTERM); });
        const int status = status_of_asked_run();
        other.join();
        _exit(status);
      },
      testing::ExitedWithCode(3), "");
}

TEST_F(DdsPlayersTest, KilledLauncherLeavesNothing) {
  end_launcher_by(SIGKILL, folder_.path());
}

TEST(DomainLock, GivesEachRunItsOwnPorts) {
  constexpr int from = 60;  // where no other run of this machine comes
  const DomainLock first(60, from);
  const DomainLock second(60, from);
  EXPECT_NE(first.domain(), second.domain());
  int freed = 0;
  {
    const DomainLock wide(500, from);  // reaches into the next domains
    const DomainLock after(3, from);
    freed = wide.domain();
    EXPECT_GT(discovery_port(after.domain(), 0), discovery_port(wide.domain(), 500));
  }
  EXPECT_EQ(DomainLock(500, from).domain(), freed);
}

}  // namespace
}  // namespace evbal
