// Processes of a run killed from outside, at any moment: the day must be the one in which nobody was.

#include "agents/world/synthetic.hpp"
#include "common/random.hpp"
#include "tests/bus/dds/run_processes.hpp"
#include "tests/bus/dds/toy_day.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

/// Kills the processes of a run one after another at random moments, each once the one before is back.
class Killer {
 public:
  Killer(std::string folder, std::vector<std::string> victims, int at_most, std::uint64_t seed)
      : folder_(std::move(folder)), victims_(std::move(victims)), left_(at_most), random_(seed, Purpose::fault, {}) {
    thread_ = std::thread([this] { kill_on(); });
  }
  ~Killer() {
    stop_ = true;
    thread_.join();
  }
  Killer(const Killer&) = delete;
  Killer& operator=(const Killer&) = delete;

  /// To be told who speaks, from which process.
  void hear(const std::string& name, std::int64_t process) {
    const std::lock_guard lock(mutex_);
    if (name == victim_ && process != process_) {
      seconds_.push_back(seconds_since(time_));
      victim_.clear();
    }
  }

  const std::vector<double>& seconds() const { return seconds_; }
  int left() const { return left_; }

 private:
  void kill_on() {
    while (!stop_ && left_ > 0) {
      std::this_thread::sleep_for(std::chrono::microseconds(random_.below(100'000)));
      const std::lock_guard lock(mutex_);
      const std::string& name = victims_[random_.below(victims_.size())];
      const pid_t process = victim_.empty() ? test::find_process(folder_, name) : 0;
      if (process > 0 && kill(process, SIGKILL) == 0) {
        victim_ = name;
        process_ = process;
        time_ = Clock::now();
        --left_;
      }
    }
  }

  std::string folder_;
  std::vector<std::string> victims_;
  std::atomic<int> left_;
  RandomStream random_;
  std::mutex mutex_;
  std::string victim_;  ///< who has not spoken since it was killed
  std::int64_t process_ = 0;
  Clock::time_point time_;
  std::vector<double> seconds_;  ///< from the signal to the first word of the new process
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

constexpr int kills_a_day = 10;

bool is_long() {
  return std::getenv("EVBAL_LONG") != nullptr;
}

/// A few in a plain run of the tests, `many` in a long one.
int kills(int few, int many) {
  return is_long() ? many : few;
}

class KilledProcessesTest : public test::ToyDay {
 protected:
  KilledProcessesTest() { end_at_eleven(); }

  /// Plays a generated city of so many regions in place of the toy, until eleven, without plans of cars.
  void play_large_city(int regions) {
    const auto made = synthetic_city({.name = "large",
                                      .regions = regions,
                                      .train_days = 1,
                                      .test_days = 1,
                                      .trips_per_day = 20'000.0,
                                      .vehicles = 4 * regions,
                                      .stations = regions / 5,
                                      .points = regions / 2});
    write_city(made.city, made.days, folder_.path() / "large");
    model_ = test::rough_model(made.city);
    model_.turnover.same_step_dropoffs.setConstant(0.5 / regions);
    write_model(model_, folder_.path() / "large/model.json");
    folder_.write("large.yaml",
                  "schema: 1\nseed: 1\nday: 2024-01-02\ncontrollers: [none]\n"
                  "clock: {start: \"05:00\", end: \"11:00\", tick: 5min, step: 30min, plan_every: 10min}\n"
                  "city: " +
                      (folder_.path() / "large").string() + "\n");
    scenario_ = read_scenario(folder_.path() / "large.yaml");
    scenario_.planning.controller = "none";
    write_scenario();
  }

  /// Days in which so many of the victims are killed; each must be the undisturbed one.
  void expect_undisturbed(const std::vector<std::string>& victims, int kills) {
    const std::string undisturbed = digest_in_process();
    std::vector<double> seconds;
    int left = kills;
    for (int day = 0; left > 0; ++day) {
      ASSERT_LT(day, kills) << "nobody is killed";
      Killer killer(folder_.path(), victims, std::min(left, kills_a_day), static_cast<std::uint64_t>(day));
      int ended = 0;
      const std::string disturbed = digest_over_dds(1, [&](const TickRecord& record) {
        killer.hear("faults", record.faults.origin.process_id);
        if (record.exchange.plan) {
          killer.hear("coordinator", record.exchange.plan->origin.process_id);
        }
        for (const auto& said : record.exchange.departures) {
          killer.hear("agent-" + std::to_string(said.region), said.origin.process_id);
        }
        for (const auto& incident : record.exchange.incidents) {
          ended += incident.kind == "process ended" ? 1 : 0;
        }
      });
      EXPECT_EQ(disturbed, undisturbed) << "day " << day;
      EXPECT_GE(ended, static_cast<int>(killer.seconds().size()));
      left -= std::min(left, kills_a_day) - killer.left();
      seconds.insert(seconds.end(), killer.seconds().begin(), killer.seconds().end());
    }
    std::sort(seconds.begin(), seconds.end());
    std::cout << kills << " killed; seconds until they spoke again: median " << seconds[seconds.size() / 2]
              << ", longest " << seconds.back() << "\n";
  }
};

TEST_F(KilledProcessesTest, AgentsCostNothing) {
  expect_undisturbed({"agent-0", "agent-1", "agent-2", "agent-3", "agent-4"}, kills(6, 100));
}

TEST_F(KilledProcessesTest, TheCoordinatorCostsNothing) {
  expect_undisturbed({"coordinator"}, kills(3, 20));
}

// The filter that finds them is in no journal: the new coordinator works it out again from the reports of the day.
TEST_F(KilledProcessesTest, TheCoordinatorCostsNothingWhileSensorsLie) {
  scenario_.planning.sensor_faults = SensorFaults::isolate;
  scenario_.schedule.faults = {{.name = "boast",
                                .type = EffectType::sensor_biased,
                                .regions = {1},
                                .magnitudes = {7.0},
                                .start = 60,
                                .duration = 180,
                                .field = ReportField::vacant},
                               {.name = "silence",
                                .type = EffectType::sensor_off,
                                .regions = {3},
                                .magnitudes = {0.0},
                                .start = 90,
                                .duration = 200,
                                .field = ReportField::demand}};
  write_scenario();
  expect_undisturbed({"coordinator"}, kills(3, 20));
}

TEST_F(KilledProcessesTest, TheInjectorCostsNothing) {
  expect_undisturbed({"faults"}, kills(2, 5));
}

TEST_F(KilledProcessesTest, SomeOfHundredsOfAgentsCostNothing) {
  if (!is_long()) {
    GTEST_SKIP() << "takes minutes: only with EVBAL_LONG in the environment";
  }
  constexpr int regions = 247;
  play_large_city(regions);
  std::vector<std::string> agents;
  for (int region = 0; region < regions; ++region) {
    agents.push_back("agent-" + std::to_string(region));
  }
  expect_undisturbed(agents, 30);
}

TEST_F(KilledProcessesTest, AllAtOnceCostNothing) {
  expect_undisturbed({"agent-0", "agent-1", "coordinator", "faults"}, kills(4, 30));
}

}  // namespace
}  // namespace evbal
