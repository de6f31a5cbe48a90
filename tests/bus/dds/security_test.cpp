// Days over a bus with security: they are those of one process, whoever else tries to take part.

#include "agents/bus/cdr.hpp"
#include "agents/bus/fast_dds.hpp"
#include "agents/bus/grants.hpp"
#include "agents/bus/keys.hpp"
#include "agents/bus/strangers.hpp"
#include "common/error.hpp"
#include "common/installation.hpp"
#include "tests/bus/dds/capture.hpp"
#include "tests/bus/dds/run_processes.hpp"
#include "tests/bus/dds/toy_day.hpp"

#include <algorithm>
#include <optional>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class SecurityTest : public test::ToyDay {
 protected:
  SecurityTest() { end_at_eleven(); }

  DdsRun run(bool security) const {
    return {.folder = folder_.path(),
            .regions = scenario_.world.city.size(),
            .world = &scenario_.world,
            .programs = EVBAL_PROGRAMS,
            .security = security ? std::optional(BusSecurity{}) : std::nullopt};
  }

  /// Starts the intruder with these keys, or none, and waits until it writes.
  void invite(Supervisor& supervisor, const std::string& keys) {
    const pid_t agent = test::find_process(folder_.path(), "agent-0");
    const auto ready = folder_.path() / "ready";
    std::vector<std::string> words = {test::word_after(agent, "--domain"), test::word_after(agent, "--run"),
                                      test::word_after(agent, "--participants"), ready.string()};
    if (!keys.empty()) {
      words.push_back(keys);
    }
    supervisor.start("intruder", own_folder() / "evbal-intruder", words);
    for (int i = 0; i < 3000 && !fs::exists(ready); ++i) {
      std::this_thread::sleep_for(10ms);
    }
    ASSERT_TRUE(fs::exists(ready)) << "the intruder does not write" << supervisor.last_words("intruder");
  }

  /// The address of the run that goes on.
  BusAddress address() const {
    const pid_t agent = test::find_process(folder_.path(), "agent-0");
    return {.run = test::word_after(agent, "--run"),
            .domain = std::stoi(test::word_after(agent, "--domain")),
            .participants = std::stoi(test::word_after(agent, "--participants"))};
  }

  /// Keys of the run that goes on, by another authority.
  fs::path forged_keys() const {
    const fs::path forged = folder_.path() / "forged";
    fs::create_directory(forged);
    write_keys(forged, address(), CertificateAuthority::made("evbal run " + address().run));
    return forged;
  }

  /// Plays the day with an intruder from the third tick on, whose keys `keys` gives, and stands still for `time` there.
  /// Goes on slowly until the record says `expected` of strangers. Expects the day to be the one without them.
  void disturb(const std::function<std::string()>& keys, std::chrono::milliseconds time, const std::string& expected) {
    Supervisor supervisor(folder_.path() / "intruders");
    DdsPlayers players(run(true));
    const std::string disturbed = digest_of(players, [&](const TickRecord& record) {
      if (record.tick.tick == 2) {
        invite(supervisor, keys());
        std::this_thread::sleep_for(time);
      }
      std::this_thread::sleep_for(record.tick.tick > 2 && !says(expected) ? 100ms : 1ms);
      for (const auto& incident : record.exchange.incidents) {
        said_ += incident.kind + ": " + incident.what + "\n";
      }
    });
    EXPECT_EQ(disturbed, digest_in_process());
    EXPECT_TRUE(says(expected)) << said_;
  }

  bool says(const std::string& text) const { return said_.find(text) != std::string::npos; }

  std::string said_;
};

TEST_F(SecurityTest, TheDayIsThatOfOneProcess) {
  DdsPlayers players(run(true));
  const fs::path keys = folder_.path() / "keys";
  EXPECT_EQ(fs::status(keys).permissions(), fs::perms::owner_all);
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(keys)) {
    files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(entry.status().permissions(),
              entry.is_directory() ? fs::perms::owner_all : fs::perms::owner_read | fs::perms::owner_write)
        << entry.path();
  }
  EXPECT_EQ(files, 8 * 5) << "of each process";
  EXPECT_EQ(digest_of(players), digest_in_process());
}

TEST_F(SecurityTest, MoreAgentsThanCanProveThemselvesAreRefused) {
  DdsRun many = run(true);
  many.regions = 200;
  many.world = nullptr;
  try {
    const DdsPlayers players(many);
    FAIL() << "200 agents";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_NE(std::string(error.what()).find("regions_per_process at least 3"), std::string::npos) << error.what();
  }
}

TEST_F(SecurityTest, KeysGoWithTheRun) {
  const fs::path keys = folder_.path() / "keys";
  {
    const DdsPlayers players(run(true));
    EXPECT_TRUE(fs::exists(keys));
  }
  EXPECT_FALSE(fs::exists(keys));
}

TEST_F(SecurityTest, AProcessThatDiesComesBackByItsKeys) {
  DdsPlayers players(run(true));
  const std::string killed = digest_of(players, [&](const TickRecord& record) {
    if (record.tick.tick == 3) {
      kill(players.process_id("agent-1"), SIGKILL);
      kill(players.process_id("coordinator"), SIGKILL);
    }
  });
  EXPECT_EQ(killed, digest_in_process());
}

TEST_F(SecurityTest, WhoHasNoCertificateIsKeptOutAndNamed) {
  disturb([] { return ""; }, 1s, "has no certificate of this run");
}

TEST_F(SecurityTest, WhoIsOfAnotherAuthorityIsKeptOutAndNamed) {
  disturb([&] { return (forged_keys() / "agent-1").string(); }, 3s, "that it is agent-1");
  // The intruder's own middleware may turn from us, who are of another authority, before it has shown its certificate.
  EXPECT_TRUE(says("cannot prove that it is agent-1") || says("has not proved that it is agent-1")) << said_;
}

TEST_F(SecurityTest, AnAgentHasNoSayForOthersNorOnPlans) {
  disturb([&] { return (folder_.path() / "keys" / "agent-1").string(); }, 3s,
          "evbal/reports from agent-1, who speaks for another process");
  EXPECT_TRUE(says("evbal/departures from agent-1, who speaks for another process")) << said_;
  EXPECT_FALSE(says("evbal/plan")) << "its own middleware refuses to write there: " << said_;
}

TEST_F(SecurityTest, AnAgentThatGrantsItselfPlansIsKeptOutAndNamed) {
  const auto keys = [&] {
    const fs::path own = folder_.path() / "keys" / "agent-1";
    const BusAddress bus = address();
    const auto forger = CertificateAuthority::made("forger");
    const Subject agent{.run = bus.run, .process = "agent-1"};
    folder_.write("forged/certificate.pem", text_of(own / "certificate.pem"));
    folder_.write("forged/key.pem", text_of(own / "key.pem"));
    folder_.write("forged/ca.pem",
                  text_of(own / "ca.pem") + forger.certificate());  // so that its own middleware agrees
    folder_.write("forged/governance.p7s", forger.sign(governance_of(bus.domain)));
    folder_.write("forged/grant.p7s", forger.sign(grant_of(agent, BusAddress::coordinator, bus.domain)));
    return (folder_.path() / "forged").string();
  };
#ifdef EVBAL_FAST_DDS_3
  const std::string expected;  // version 3 tells its log alone
#else
  const std::string expected = "which calls itself `intruder`, has not proved that it is agent-1";
#endif
  disturb(keys, Strangers::time_to_prove + 1s, expected);
}

/// What a report says, as it stands in a packet of a run if nothing hides it.
std::string bytes_of(const std::string& run, const Report& report) {
  const Sample<std::vector<Report>> sample{run, {report}};
  std::string bytes(cdr_size(sample), '\0');
  write_cdr(sample, bytes.data());
  return bytes.substr(cdr_size(Sample<std::vector<Report>>{run, {}}));
}

class CaptureTest : public SecurityTest {
 protected:
  /// Plays the day; in how many reports of it a packet shows what they say.
  std::pair<int, int> readable(bool security) {
    test::Capture capture;
    std::vector<std::string> reports;
    {
      DdsPlayers players(run(security));
      const std::string id = address().run;
      digest_of(players, [&](const TickRecord& record) {
        for (const auto& report : record.exchange.reports) {
          reports.push_back(bytes_of(id, report));
        }
      });
    }
    const auto& packets = capture.stop();
    const auto shown = std::ranges::count_if(reports, [&](const std::string& report) {
      return std::ranges::any_of(packets,
                                 [&](const std::string& packet) { return packet.find(report) != std::string::npos; });
    });
    return {static_cast<int>(shown), static_cast<int>(reports.size())};
  }
};

TEST_F(CaptureTest, NoPacketShowsWhatIsSaid) {
  if (!test::Capture().allowed()) {
    GTEST_SKIP() << "packets may be looked at by root only";
  }
  const auto [shown, all] = readable(false);
  EXPECT_GT(shown, all * 9 / 10) << "what is looked for is seen without security";
  EXPECT_EQ(readable(true).first, 0);
}

}  // namespace
}  // namespace evbal
