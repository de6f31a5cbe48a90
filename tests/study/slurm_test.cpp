#include "experiments/study/executors/slurm.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Programs that stand in for Slurm's, first in $PATH. Each writes its words to a file of its name; `jobs` holds the
/// ids of arrays that are not over.
class FakeSlurm : public ::testing::Test {
 protected:
  FakeSlurm() {
    program("sbatch", submits);
    program("squeue", "for id in $(cat jobs); do echo \"$id $(pwd)/tasks\"; done");
    program("scancel", "");
    folder_.write("jobs", "");
    folder_.write("next", "41\n");
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~FakeSlurm() override { setenv("PATH", path_.c_str(), 1); }

  void program(const std::string& name, const std::string& script) const {
    const fs::path file = folder_.write(
        name, "#!/bin/sh\ncd '" + folder_.path().string() + "'\necho \"$@\" >>" + name + ".txt\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }

  std::string said_to(const std::string& name) const { return text_of(folder_.path() / (name + ".txt")); }

  /// Days as tasks, of which `complaints_` hears.
  void work(std::size_t days, int at_a_time) {
    std::vector<std::size_t> all(days);
    std::iota(all.begin(), all.end(), std::size_t{0});
    const SlurmTasks tasks{.folder = tasks_,
                           .at_a_time = at_a_time,
                           .task_limit = std::chrono::seconds(90),
                           .task =
                               [](std::size_t i) {
                                 return SlurmTask{"day" + std::to_string(i), "{}\n"};
                               },
                           .merge = [](const fs::path&) {},
                           .pause = [this](std::chrono::milliseconds length) { pass(length); },
                           .longest_array = 10};
    work_on_slurm(all, tasks, [&](std::size_t, const std::string& complaint) { complaints_.push_back(complaint); });
  }

  /// Time passes, in which nobody waits; at `results_at_` the results are there.
  void pass(std::chrono::milliseconds length) {
    passed_ += length;
    if (passed_ >= results_at_) {
      program("squeue", results);
      for (const auto& entry : fs::directory_iterator(tasks_)) {
        if (entry.path().extension() == ".yaml") {
          std::ofstream(fs::path(entry.path()).replace_extension(".sqlite"));
        }
      }
    }
  }

  static constexpr const char* submits = "id=$(cat next); echo $((id + 1)) >next; echo $id >>jobs; echo $id";
  static constexpr const char* results =
      "for day in tasks/*.yaml; do [ ! -e \"$day\" ] || : >\"${day%.yaml}.sqlite\"; done";

  const std::string path_ = std::getenv("PATH");
  Folder folder_;
  fs::path tasks_ = folder_.path() / "tasks";
  std::vector<std::string> complaints_;
  std::chrono::milliseconds passed_ = std::chrono::milliseconds::zero();
  std::chrono::milliseconds results_at_ = std::chrono::milliseconds::max();
};

TEST_F(FakeSlurm, MayWarnWhenItTakesAJob) {
  program("sbatch", std::string("echo 'sbatch: warning: no account' >&2\n") + submits);
  program("squeue", std::string("echo 'squeue: warning: slow' >&2\n[ ! -e looked ] || ") + results +
                        "\n: >looked\necho \"41 $(pwd)/tasks\"");
  work(2, 0);
  EXPECT_EQ(complaints_, (std::vector<std::string>{"", ""}));
}

TEST_F(FakeSlurm, IsNotBelievedWithoutAJobId) {
  program("sbatch", "echo 'Submitted batch job 41'; echo 41 >>jobs");
  try {
    work(1, 0);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Submitted batch job 41"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("no job id"), std::string::npos) << error.what();
  }
  EXPECT_NE(said_to("scancel").find("41"), std::string::npos);  // nothing is left running unheard
}

/// The most tasks that may run at a time by what sbatch was told: of arrays, each of which may wait for another's end.
long most_at_a_time(const std::string& said) {
  std::istringstream lines(said);
  long most = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("--dependency=afterany:") == std::string::npos) {
      const auto limit = line.find('%', line.find("--array="));
      most += limit == std::string::npos ? 1'000'000 : std::stol(line.substr(limit + 1));
    }
  }
  return most;
}

TEST_F(FakeSlurm, PlaysNoMoreDaysAtATimeThanAskedForOverAllArrays) {
  program("squeue", results);
  work(21, 7);
  const std::string said = said_to("sbatch");
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 3) << said;
  EXPECT_EQ(most_at_a_time(said), 7) << said;
  EXPECT_NE(said.find("--time=1:30 "), std::string::npos) << said;
  EXPECT_EQ(complaints_.size(), 21U);
}

TEST_F(FakeSlurm, RunsAsManySideBySideAsTheirLimitTakes) {
  program("squeue", results);
  work(31, 25);
  const std::string said = said_to("sbatch");
  EXPECT_EQ(most_at_a_time(said), 24) << said;
  EXPECT_NE(said.find("--dependency=afterany:41 "), std::string::npos) << said;
}

TEST_F(FakeSlurm, IsAskedRarelyWhileResultsAreTakenSoon) {
  results_at_ = std::chrono::hours(1);
  work(2, 0);
  EXPECT_EQ(complaints_, (std::vector<std::string>{"", ""}));
  EXPECT_LT(passed_ - results_at_, std::chrono::seconds(1));
  const std::string said = said_to("squeue");
  const auto questions = std::count(said.begin(), said.end(), '\n');
  EXPECT_GE(questions, 3600 / 30);
  EXPECT_LE(questions, 3600 / 30 + 5);
}

TEST_F(FakeSlurm, SaysWhatATaskThatFailedHasSaid) {
  program("squeue", "echo 'no model' >tasks/41-2.log; : >tasks/day0.sqlite");
  work(2, 0);
  std::sort(complaints_.begin(), complaints_.end());
  EXPECT_EQ(complaints_, (std::vector<std::string>{"", "no model\n"}));
}

TEST_F(FakeSlurm, IsWaitedForWhileItDoesNotAnswer) {
  program("squeue", "[ -e asked ] && " + std::string(results) + "; : >asked; echo 'slurm_load_jobs error'");
  work(1, 0);
  EXPECT_EQ(complaints_, (std::vector<std::string>{""}));
}

TEST_F(FakeSlurm, IsToldToEndWhatIsLeft) {
  folder_.write("jobs", "17\n");
  folder_.write("tasks/day0.sqlite", "");
  std::vector<fs::path> merged;
  EXPECT_THROW(merge_left(
                   tasks_, [&](const fs::path& file) { merged.push_back(file); },
                   [this](std::chrono::milliseconds length) { passed_ += length; }),
               Error);  // it goes on
  EXPECT_LE(passed_, std::chrono::minutes(6));
  EXPECT_EQ(said_to("scancel"), "17\n");
  program("scancel", ": >jobs");
  merge_left(tasks_, [&](const fs::path& file) { merged.push_back(file.filename()); });
  EXPECT_EQ(merged, (std::vector<fs::path>{"day0.sqlite"}));
  EXPECT_FALSE(fs::exists(tasks_));
}

}  // namespace
}  // namespace evbal
