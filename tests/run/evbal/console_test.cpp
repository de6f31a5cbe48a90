// The console in a browser: a morning of San Francisco over the bus, 54 agents, watched and broken by hand.

#include "experiments/record/recorded_fault.hpp"
#include "tests/run/evbal/browser.hpp"
#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace evbal {
namespace {

class ConsoleTest : public ::testing::Test {
 protected:
  /// Starts a run that may be watched, and gives the link that it prints.
  std::string start(const std::string& arguments) {
    run_ = line_.start("run " + arguments + " --watch --quiet --out a");
    for (int tries = 0; tries < 600; ++tries) {
      const std::string text = text_of(line_.path() / "err.txt");
      const auto begin = text.find("http://");
      if (const auto end = text.find('\n', begin); begin != std::string::npos && end != std::string::npos) {
        return text.substr(begin, end - begin);
      }
      usleep(100'000);
    }
    return "no link: " + text_of(line_.path() / "err.txt");
  }

  /// Its exit status.
  int end() {
    const int status = wait_for(run_);
    run_ = 0;
    return status;
  }

  void TearDown() override {
    if (run_ > 0) {
      kill(run_, SIGTERM);
      end();
    }
  }

  CommandLine line_;
  pid_t run_ = 0;
};

const std::string san_francisco_morning =
    "san-francisco-day.yaml --controller nominal "
    "--set 'clock={start: \"07:00\", end: \"10:00\", tick: 5min, step: 30min, plan_every: 10min}' "
    "--set 'faults={schema: 1, guard: {max_active: 2}, faults: []}'";

TEST_F(ConsoleTest, ShowsADayAndBreaksItByHand) {
  const std::string link = start(san_francisco_morning);
  ASSERT_TRUE(link.starts_with("http://127.0.0.1:")) << link;
  Browser page;
  page.open(link);

  // The map and the curves change as ticks pass.
  ASSERT_TRUE(page.comes_true("heard.ticks.length > 1 && document.querySelectorAll('.region').length === 54"));
  const std::string colours = "[...document.querySelectorAll('.region')].map(path => path.style.fill).join()";
  const std::string curves = "[...document.querySelectorAll('.line')].map(path => path.getAttribute('d')).join()";
  page.value_of("window.before = [" + colours + ", " + curves + "]");
  EXPECT_TRUE(page.comes_true("before[0] !== " + colours + " && before[1] !== " + curves));

  // Pause stops simulated time.
  page.value_of("document.getElementById('pause').click()");
  ASSERT_TRUE(page.comes_true("heard.pace.paused"));
  const std::string tick = page.value_of("heard.pace.tick");
  page.value_of("new Promise(done => setTimeout(done, 1500))");
  EXPECT_EQ(page.value_of("heard.pace.tick"), tick);
  EXPECT_EQ(page.value_of("document.getElementById('state').textContent"), "\"paused\"");

  // A clicked outage acts at the next tick, and is seen to.
  const std::string region = page.value_of("heard.day.points.indexOf(Math.max(...heard.day.points))");
  page.value_of("document.querySelectorAll('.region')[" + region + "].dispatchEvent(new MouseEvent('click'))");
  page.value_of("[...document.querySelectorAll('button')].find(one => one.textContent === 'Outage').click()");
  page.value_of("document.getElementById('inject').click()");
  ASSERT_TRUE(page.comes_true("heard.faults.length === 1")) << page.value_of("document.body.innerText");
  page.value_of("document.getElementById('tick').click()");
  ASSERT_TRUE(page.comes_true("heard.pace.paused && last().tick === " + tick));
  EXPECT_EQ(page.value_of("last().acting.map(one => one.regions)"), "[[" + region + "]]");
  EXPECT_EQ(page.value_of("last().acting[0].amount > 0"), "true");

  // One that cannot be is refused with its reason.
  page.value_of("document.getElementById('inject').click()");
  EXPECT_TRUE(page.comes_true("document.getElementById('answer').className === 'no'"));
  EXPECT_NE(page.value_of("document.getElementById('answer').textContent").find("overlaps `by-hand-1`"),
            std::string::npos);

  // Another terminal comes in by the same door.
  const Ended slow = line_.evbal("inject a travel.slow --regions 3,7 --for 30min --magnitude 2 --name jam");
  EXPECT_EQ(slow.status, 0) << slow.err;
  const Ended many = line_.evbal("inject a fleet.breakdown --regions 3 --for 30min --magnitude 2");
  EXPECT_EQ(many.status, 2);
  EXPECT_NE(many.err.find("the guard's max_active allows 2"), std::string::npos) << many.err;
}

TEST_F(ConsoleTest, KillsAnAgentThatComesBackAndTheReplayIsTheSame) {
  const std::string link = start(san_francisco_morning);
  Browser page;
  page.open(link);
  ASSERT_TRUE(page.comes_true("heard.ticks.length > 1"));
  page.value_of("document.getElementById('pause').click()");
  ASSERT_TRUE(page.comes_true("heard.pace.paused"));
  const std::string agent = "heard.pace.processes.find(one => one.name === 'agent-7')";
  page.value_of("window.old = " + agent + ".id");
  page.value_of(
      "[...document.querySelectorAll('td:first-child')].find(cell => cell.textContent === 'agent-7')"
      ".parentNode.querySelector('button').click()");
  EXPECT_TRUE(page.comes_true("!" + agent + ".there")) << "it is shown to be gone";
  EXPECT_TRUE(page.comes_true(agent + ".there && " + agent + ".id !== old")) << "and back";

  page.value_of(
      "ask({do: 'fault', fault: {type: 'charger.outage', target: {pick: 3}, duration: '45min', magnitude: "
      "{fraction_of_points: 1}, on_start: 'evict'}})");
  page.value_of("ask({do: 'fault', fault: {type: 'process.kill', target: {agents: [11]}, restart_after: '15min'}})");
  page.value_of("ask({do: 'speed', speed: 'unlimited'})");
  page.value_of("document.getElementById('pause').click()");
  EXPECT_TRUE(page.comes_true("heard.log.some(line => line.includes('process ended: agent-7'))"));
  EXPECT_TRUE(page.comes_true("heard.ticks.length === 36")) << page.value_of("heard.ticks.length");
  EXPECT_EQ(end(), 0) << text_of(line_.path() / "err.txt");
  const auto faults = read_faults(line_.path() / "a" / "run.sqlite");
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_FALSE(faults[0].amount.empty());
  EXPECT_FALSE(faults[1].amount.empty());
  EXPECT_TRUE(std::filesystem::exists(line_.path() / "a" / "without-faults" / "summary.json"));
  EXPECT_TRUE(std::filesystem::exists(line_.path() / "a" / "faults.csv"));
  EXPECT_FALSE(std::filesystem::exists(line_.path() / "a" / "requests"));
  const Ended replay = line_.evbal("replay a --quiet");
  EXPECT_EQ(replay.status, 0) << replay.err;
}

TEST_F(ConsoleTest, NamesAPortThatIsNone) {
  for (const char* port : {"0", "65536", "toy.yaml", "-1"}) {
    const Ended ended = line_.evbal(std::string("run morning.yaml --watch=") + port);
    EXPECT_EQ(ended.status, 2) << port;
    EXPECT_NE(ended.err.find("give one from 1 to 65535"), std::string::npos) << ended.err;
  }
}

}  // namespace
}  // namespace evbal
