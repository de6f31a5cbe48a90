// Processes of a run that wait in vain: each gives up in time and says for whom it waited.

#include "agents/hosting/process.hpp"
#include "common/error.hpp"
#include "common/installation.hpp"
#include "common/open_file.hpp"
#include "common/pipe.hpp"
#include "common/spawn.hpp"
#include "experiments/conductor/domain_lock.hpp"
#include "tests/bus/dds/fake_answers.hpp"
#include "tests/folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;

/// A run of one region in which this process is the conductor and says only what a test has it say.
class BoundedWaits : public testing::Test {
 protected:
  BoundedWaits() { address_.domain = domain_.domain(); }
  ~BoundedWaits() override {
    for (const pid_t id : ids_) {
      kill(id, SIGKILL);
      waitpid(id, nullptr, 0);
    }
  }

  void start(const std::string& name, int participant) {
    ProcessOptions options{.name = name,
                           .address = address_,
                           .scenario = folder_.path() / "none.yaml",
                           .journal = folder_.path() / (name + ".journal"),
                           .patience = 2s};
    options.address.participant = participant;
    Command command = {own_folder() / "fakes" / "evbal-agent"};
    const auto words = arguments(options);
    command.insert(command.end(), words.begin(), words.end());
    const OpenFile log(folder_.path() / name, O_WRONLY | O_CREAT);
    ids_.push_back(spawn(command, {.input = input_.read_end(), .output = log.number(), .errors = log.number()}));
  }

  void join_the_bus() {
    participant_.emplace(address_, "conductor");
    hello_.emplace(*participant_);
    faults_.emplace(*participant_);
    ticks_.emplace(*participant_);
    reports_.emplace(*participant_);
    plans_.emplace(*participant_);
    departures_.emplace(*participant_);
  }

  /// The last line of the process that was started last, once it has ended by itself; waits up to a minute.
  std::string last_words(const std::string& name) {
    int status = 0;
    for (int i = 0; i < 6000; ++i) {
      if (waitpid(ids_.back(), &status, WNOHANG) == ids_.back()) {
        ids_.pop_back();
        EXPECT_EQ(ending(status), "ended with status 3");
        return text_of(folder_.path() / name);
      }
      std::this_thread::sleep_for(10ms);
    }
    return "goes on";
  }

  Folder folder_;
  DomainLock domain_{4};
  BusAddress address_{.run = "1-1", .domain = 0, .participant = BusAddress::conductor, .participants = 4};
  Pipe input_;
  std::vector<pid_t> ids_;
  std::optional<Participant> participant_;
  std::optional<Reader<Hello>> hello_;
  std::optional<Reader<Faults>> faults_;
  std::optional<Writer<Tick>> ticks_;
  std::optional<Reader<std::vector<Report>>> reports_;
  std::optional<Reader<Plan>> plans_;
  std::optional<Reader<std::vector<Departures>>> departures_;
};

TEST_F(BoundedWaits, ForAConductor) {
  start("agent-0", BusAddress::first_agent);
  EXPECT_EQ(last_words("agent-0"), "no conductor on the bus within 2 s\n");
}

TEST_F(BoundedWaits, ForATick) {
  start("agent-0", BusAddress::first_agent);
  join_the_bus();
  EXPECT_EQ(last_words("agent-0"), "no tick after -1 from the conductor within 2 s\n");
}

TEST_F(BoundedWaits, ForAPlan) {
  start("agent-0", BusAddress::first_agent);
  join_the_bus();
  ticks_->write(fake::tick(0, 1));
  EXPECT_EQ(last_words("agent-0"), "no plan of tick 0 from the coordinator within 2 s\n");
}

TEST_F(BoundedWaits, ForReports) {
  start("coordinator", BusAddress::coordinator);
  join_the_bus();
  ticks_->write(fake::tick(0, 3));
  EXPECT_EQ(last_words("coordinator"), "no report of tick 0 from region 0 and 2 more within 2 s\n");
}

TEST(DomainLockDeathTest, TellsWhyNoneCanBeLocked) {
  EXPECT_EXIT(
      {
        rlimit no_files{};
        setrlimit(RLIMIT_NOFILE, &no_files);
        try {
          const DomainLock lock(3);
        } catch (const Error& error) {
          std::fputs(error.what(), stderr);
          _exit(static_cast<int>(error.status()));
        }
      },
      testing::ExitedWithCode(3), "Too many open files");
}

}  // namespace
}  // namespace evbal
