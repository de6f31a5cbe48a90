// A process that nobody asked writes on the bus of a run: the day must be the one in which it does not.

#include "common/installation.hpp"
#include "tests/bus/dds/run_processes.hpp"
#include "tests/bus/dds/toy_day.hpp"

#include <map>
#include <optional>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;

class StrangersTest : public test::ToyDay {
 protected:
  StrangersTest() { end_at_eleven(); }
};

TEST_F(StrangersTest, AreRefusedWhateverTheySay) {
  Supervisor supervisor(folder_.path() / "strangers");
  const auto ready = folder_.path() / "ready";
  const auto invite = [&] {
    const pid_t agent = test::find_process(folder_.path(), "agent-0");
    supervisor.start("stranger", own_folder() / "evbal-stranger",
                     {test::word_after(agent, "--domain"), test::word_after(agent, "--run"),
                      test::word_after(agent, "--participants"), ready.string()});
    for (int i = 0; i < 2000 && !std::filesystem::exists(ready); ++i) {
      std::this_thread::sleep_for(10ms);
    }
    ASSERT_TRUE(std::filesystem::exists(ready)) << "the stranger is not heard";
  };
  std::map<std::string, int> refused;  // by topic
  const std::string disturbed = digest_over_dds(1, [&](const TickRecord& record) {
    if (record.tick.tick == 2) {
      invite();
    }
    std::this_thread::sleep_for(1ms);  // that there be something to refuse in each tick
    for (const auto& incident : record.exchange.incidents) {
      ASSERT_EQ(incident.kind, "sample refused");
      const auto topic = incident.what.find("evbal/");
      refused[incident.what.substr(topic, incident.what.find(' ', topic) - topic)] += std::stoi(incident.what);
    }
  });
  EXPECT_EQ(disturbed, digest_in_process());
  EXPECT_EQ(refused.size(), 6U) << "of each topic";
  for (const auto& [topic, times] : refused) {
    EXPECT_GT(times, 20) << topic;
  }
}

}  // namespace
}  // namespace evbal
