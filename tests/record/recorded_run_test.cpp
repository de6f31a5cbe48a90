#include "experiments/record/recorded_run.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/record/small_day.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(RecordedRun, SeesSolverFaultsInThePlansThatFellBack) {
  const Folder folder;
  RunHeader header = small_header();
  header.faults = {{.name = "fail", .type = "solver.fail", .start = 0, .end = 5}};
  auto day = small_day();
  for (auto& tick : day) {
    tick.faults.effects.clear();
  }
  day[2].exchange.departures[1].observed.clear();
  day[0].faults.effects = {{.fault = 0, .type = EffectType::solver_fail, .region = no_region}};
  day[0].exchange.plan->provenance.fallback = FallbackLevel::nominal;
  day[2].exchange.plan->provenance.fallback = FallbackLevel::nominal;  // of itself, without the fault
  RunRecord record(folder.path() / "run", header);
  for (const auto& tick : day) {
    record.add(tick);
  }
  record.finish({});
  const auto faults = read_faults(folder.path() / "run" / "run.sqlite");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].said, (std::map<int, std::set<int>>{{0, {no_region}}}));
  EXPECT_EQ(faults[0].amount, (std::map<int, double>{{0, 1.0}}));
}

TEST(RecordedRun, GivesTheMeanPlanCostByTerm) {
  const Folder folder;
  auto day = small_day();
  day[0].exchange.plan->provenance.costs = {{"km", 3.0}, {"shortage", 8.0}};
  day[2].exchange.plan->provenance.costs = {{"km", 5.0}};
  RunRecord record(folder.path() / "run", small_header());
  for (const auto& tick : day) {
    record.add(tick);
  }
  record.finish({});
  mark_complete(folder.path() / "run");
  const auto costs = read_run(folder.path() / "run").plan_costs;
  ASSERT_EQ(costs.size(), 2U);
  EXPECT_EQ(costs[0].term, "km");
  EXPECT_EQ(costs[0].cost, 4.0);
  EXPECT_EQ(costs[1].term, "shortage");
  EXPECT_EQ(costs[1].cost, 4.0);
}

TEST(RecordedRun, GivesRegionsAndFaultsBack) {
  const Folder folder;
  const auto run_folder = folder.path() / "run";
  EXPECT_THROW(read_run(run_folder), Error);
  RunRecord record(run_folder, small_header());
  for (const auto& tick : small_day()) {
    record.add(tick);
  }
  record.finish({});
  EXPECT_THROW(read_run(run_folder), Error) << "was taken as finished while it is marked";
  EXPECT_EQ(read_marked_run(run_folder).ticks, 4);
  mark_complete(run_folder);
  const RecordedRun run = read_run(run_folder);
  EXPECT_EQ(run.ticks, 4);
  EXPECT_EQ(run.by_region.at("demand"), (Eigen::MatrixXd(2, 2) << 4, 0, 1, 0).finished());
  ASSERT_EQ(run.faults.size(), 1U);
  const RecordedFault& outage = run.faults[0];
  EXPECT_EQ(outage.name, "outage");
  EXPECT_EQ(outage.end, 15);
  EXPECT_EQ(outage.said, (std::map<int, std::set<int>>{{2, {1}}}));
  EXPECT_EQ(outage.amount, (std::map<int, double>{{2, 1.0}}));
  EXPECT_EQ(outage.seen_regions, std::set<int>{1});
  EXPECT_EQ(outage.evicted, 0);
}

}  // namespace
}  // namespace evbal
