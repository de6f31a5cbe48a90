// What a scenario says of how its processes meet: profiles, security, hosts.

#include "experiments/scenario/scenario.hpp"
#include "tests/scenario/scenario_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

using test::head;
using ScenarioOfABus = test::ScenarioFile;

TEST_F(ScenarioOfABus, ProfilesOfDdsLieBesideIt) {
  const fs::path file = write(head + "dds_profiles: fast.xml\n");
  const fs::path beside = fs::absolute(file).parent_path() / "fast.xml";
  const Scenario scenario = read_scenario(file);
  EXPECT_EQ(scenario.dds_profiles, beside);
  EXPECT_EQ(read_scenario(write(resolved_yaml(scenario, "robust"))).dds_profiles, beside);
  EXPECT_EQ(read_scenario(file, {.dds_profiles = "other.xml"}).dds_profiles, fs::absolute("other.xml"));
  expect_refused([&] { read_scenario(file, {.transport = "inproc"}); }, "dds_profiles", "choose `dds`");
}

TEST_F(ScenarioOfABus, SecurityIsOffUnlessAskedFor) {
  EXPECT_FALSE(read_scenario(write(head)).security);
  EXPECT_FALSE(read_scenario(write(head + "security: off\n")).security);
  EXPECT_EQ(resolved_yaml(read_scenario(write(head)), "robust").find("security"), std::string::npos);
  const Scenario made = read_scenario(write(head + "security: on\n"));
  EXPECT_EQ(made.security.value().ca, "");
  EXPECT_EQ(read_scenario(write(resolved_yaml(made, "robust"))).security.value().ca, "");
  const fs::path file = write(head + "security: {ca: mine}\n");
  const Scenario own = read_scenario(file);
  EXPECT_EQ(own.security.value().ca, fs::absolute(file).parent_path() / "mine");
  EXPECT_EQ(read_scenario(write(resolved_yaml(own, "robust"))).security.value().ca, own.security->ca);
  expect_refused([&] { read_scenario(write(head + "security: yes\n")); }, "a.yaml:5", "on");
  expect_refused([&] { read_scenario(write(head + "security: {}\n")); }, "a.yaml:5", "ca");
}

const std::string two_hosts =
    "regions_per_process: 1\n"
    "hosts:\n"
    "  - {address: 10.0.0.2, start: local, weight: 2}\n"
    "  - {address: 10.0.0.3, start: ssh -p 2222 b, weight: 3}\n";

TEST_F(ScenarioOfABus, NamesHostsThatShareTheRegions) {
  const Scenario scenario = read_scenario(write(head + two_hosts));
  ASSERT_EQ(scenario.hosts.size(), 2U);
  EXPECT_EQ(share_out(scenario.hosts, 5), (std::vector<int>{0, 0, 1, 1, 1}));
  EXPECT_EQ(share_out(scenario.hosts, 1), (std::vector<int>{1}));
  EXPECT_EQ(share_out({}, 5), (std::vector<int>{}));
  EXPECT_EQ(regions_by_host(scenario.hosts, 5, 2), (std::vector<std::vector<int>>{{0, 1}, {2, 3, 4}}));
  EXPECT_EQ(on_host(scenario.hosts[0], "echo 'a'"), (Command{"sh", "-c", "echo 'a'"}));
  EXPECT_EQ(on_host(scenario.hosts[1], "echo 'a'").back(), R"(sh -c 'echo '\''a'\''')");
  EXPECT_EQ(shown(scenario.hosts[1]), "10.0.0.3 (ssh -p 2222 b)");
  const Scenario again = read_scenario(write(resolved_yaml(scenario, "robust"), "b.yaml"));
  EXPECT_EQ(again.hosts, scenario.hosts);
}

TEST_F(ScenarioOfABus, KeepsHostsOutOfADayThatNeedsNone) {
  const Scenario scenario = read_scenario(write(head + two_hosts + "transport: inproc\n"));
  EXPECT_EQ(resolved_yaml(scenario, "robust").find("hosts"), std::string::npos) << "a day's key is made of this text";
}

TEST_F(ScenarioOfABus, ResolvesAHostThatGoesDownToItsRegions) {
  const std::string faults =
      "faults: {schema: 1, seed: 1, faults: [{name: a, type: host.down, target: {host: 1}, start: \"08:00\", "
      "restart_after: 30min}]}\n";
  const Scenario scenario = read_scenario(write(head + two_hosts + faults));
  EXPECT_EQ(scenario.schedule.faults.front().regions, (std::vector<int>{2, 3, 4}));
  const Scenario coarse = read_scenario(write(head + two_hosts + faults), {.regions_per_process = 3});
  EXPECT_EQ(coarse.schedule.faults.front().regions, (std::vector<int>{3, 4}));
  const Scenario again = read_scenario(write(resolved_yaml(scenario, "robust"), "b.yaml"));
  EXPECT_EQ(again.schedule, scenario.schedule);
  expect_refused([&] { read_scenario(write(head + faults)); }, "a.yaml:5", "names no hosts");
}

TEST_F(ScenarioOfABus, RefusesHostsThatAreNone) {
  const auto refused = [&](const std::string& hosts, const std::string& hint) {
    expect_refused([&] { read_scenario(write(head + "hosts: " + hosts + "\n")); }, "a.yaml:5", hint);
  };
  refused("[]", "at least one");
  refused("[{start: local}]", "`address` is missing");
  refused("[{address: b, start: local}]", "IPv4");
  refused("[{address: 0.0.0.0, start: local}]", "IPv4");
  refused("[{address: 10.0.0.2, start: ssh}]", "such as `ssh b`");
  refused("[{address: 10.0.0.2, start: rsh b}]", "such as `ssh b`");
  refused("[{address: 10.0.0.2, start: local, weight: 0}]", "from 1");
  refused("[{address: 10.0.0.2, start: local, port: 1}]", "unknown key `port`");
  const std::string network = "network: {loss: 0.1, delay: 1ms}\nhosts: [{address: 10.0.0.2, start: local}]\n";
  expect_refused([&] { read_scenario(write(head + network)); }, "network", "leave one of them out");
}

}  // namespace
}  // namespace evbal
