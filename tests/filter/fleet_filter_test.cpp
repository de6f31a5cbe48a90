#include "coordinator/filter/fleet_filter.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Three regions with ten vacant cars each and no charger. In ten minutes two passengers appear in region 0 and one in
/// region 1, all are picked up, and none has arrived.
class FleetFilterTest : public testing::Test {
 protected:
  FleetFilterTest() { begin({said(0, 10, 0), said(1, 10, 0), said(2, 10, 0)}); }

  void begin(std::vector<std::optional<Report>> reports) {
    filter_ = FleetFilter({30, Eigen::VectorXi::Zero(3), 20.0, Eigen::MatrixXd::Constant(3, 3, 15.0),
                           [](double /*so_far*/, double /*minutes*/) { return 0.0; }});
    hear(0, std::move(reports));
  }

  static Report said(int region, int vacant, int demand) {
    Report report;
    report.region = region;
    report.vacant = vacant;
    report.demand = demand;
    return report;
  }

  /// Their passengers and how many cars carry them now.
  static std::vector<std::optional<Report>> truth() { return {said(0, 8, 2), said(1, 9, 1), said(2, 10, 0)}; }

  FleetFilter::Result hear(int tick, std::vector<std::optional<Report>> reports, int riding = 0) {
    Tick announced;
    announced.tick = tick;
    announced.due = {0, 1, 2};
    if (riding > 0) {
      announced.under_way = {{2, 5 * tick + 20, Errand::passenger, riding}};
    }
    for (auto& report : reports) {
      if (report) {
        report->tick = tick;
      }
    }
    const Eigen::VectorXd demand = Eigen::VectorXd::Constant(3, 2.0);
    return filter_.observe(announced, 5 * tick, reports, {}, {short_trips_, demand, 1.4});
  }

  std::vector<ShortTrips> short_trips_;
  FleetFilter filter_{FilterModel{}};
};

using Flags = std::vector<SensorFlag>;

TEST_F(FleetFilterTest, BelievesTheTruth) {
  const auto result = hear(2, truth(), 3);
  EXPECT_EQ(result.flags, Flags{});
  EXPECT_EQ(result.reports[0].vacant, 8);
  EXPECT_EQ(filter_.variance(), Eigen::VectorXd::Zero(3));
}

TEST_F(FleetFilterTest, BelievesASpike) {
  EXPECT_EQ(hear(2, {said(0, 1, 9), said(1, 9, 1), said(2, 10, 0)}, 10).flags, Flags{});
}

TEST_F(FleetFilterTest, TakesWhatIsNotSaidFromTheFleet) {
  auto reports = truth();
  reports[1]->vacant = -1;
  const auto result = hear(2, reports, 3);
  EXPECT_EQ(result.flags, (Flags{{1, ReportField::vacant, SensorFaultKind::silent, -1, 9, false}}));
  EXPECT_EQ(result.reports[1].vacant, 9);
  EXPECT_EQ(result.reports[1].demand, 1) << "the rest of the report is used";
}

TEST_F(FleetFilterTest, TakesARegionThatIsNotHeardFromTheFleet) {
  auto reports = truth();
  reports[0].reset();
  const auto result = hear(2, reports, 3);
  EXPECT_EQ(result.flags, Flags{});
  EXPECT_EQ(result.reports[0].vacant, 8);
  EXPECT_EQ(result.reports[0].demand, 0);
  EXPECT_LT(filter_.variance()(0), 0.2);
}

TEST_F(FleetFilterTest, SharesWhatIsLeftAmongThoseWhoAreNotHeard) {
  auto reports = truth();
  reports[0].reset();
  reports[1].reset();
  const auto result = hear(2, reports, 3);
  EXPECT_NEAR(result.reports[0].vacant + result.reports[1].vacant, 17, 1) << "each is rounded";
  EXPECT_GT(filter_.variance()(0), 0.5);
}

TEST_F(FleetFilterTest, AccusesVacantCarsIfTheFleetHasTooMany) {
  auto reports = truth();
  reports[0]->vacant += 6;
  EXPECT_EQ(hear(2, reports, 3).flags, (Flags{{0, ReportField::vacant, SensorFaultKind::biased, 14, 8, false}}));
}

TEST_F(FleetFilterTest, AccusesVacantCarsIfTheFleetHasOneTooFew) {
  auto reports = truth();
  reports[1]->vacant -= 1;
  EXPECT_EQ(hear(2, reports, 3).flags, (Flags{{1, ReportField::vacant, SensorFaultKind::biased, 8, 9, false}}));
}

TEST_F(FleetFilterTest, AccusesLowBatteryCarsIfTheyAreTheOnesTooMany) {
  auto reports = truth();
  reports[0]->low_battery += 6;
  EXPECT_EQ(hear(2, reports, 3).flags, (Flags{{0, ReportField::low_battery, SensorFaultKind::biased, 6, 0, false}}));
}

TEST_F(FleetFilterTest, AccusesDemandIfTheFleetComesOut) {
  auto reports = truth();
  reports[0]->demand += 7;
  EXPECT_EQ(hear(2, reports, 3).flags, (Flags{{0, ReportField::demand, SensorFaultKind::biased, 9, 2, false}}));
}

TEST_F(FleetFilterTest, AccusesWaitingBesideVacantCars) {
  auto reports = truth();
  reports[0]->waiting += 4;
  EXPECT_EQ(hear(2, reports, 3).flags, (Flags{{0, ReportField::waiting, SensorFaultKind::biased, 4, 0, false}}));
}

TEST_F(FleetFilterTest, BelievesAFieldAgainOnceItHasAgreedThreeTimes) {
  auto reports = truth();
  reports[0]->demand += 7;
  hear(2, reports, 3);
  const auto quiet = [&] { return std::vector<std::optional<Report>>{said(0, 8, 0), said(1, 9, 0), said(2, 10, 0)}; };
  EXPECT_EQ(hear(4, quiet(), 3).flags.size(), 1U);
  EXPECT_EQ(hear(6, quiet(), 3).flags.size(), 1U);
  EXPECT_EQ(hear(8, quiet(), 3).flags, Flags{});
}

TEST_F(FleetFilterTest, BelievesCarsAgainOnceTheyChangeAsTheyShouldAndTheCityIsTheFleet) {
  auto reports = truth();
  reports[0]->vacant += 6;
  hear(2, reports, 3);
  const auto quiet = [&] { return std::vector<std::optional<Report>>{said(0, 8, 0), said(1, 9, 0), said(2, 10, 0)}; };
  EXPECT_EQ(hear(4, quiet(), 3).flags.size(), 1U) << "it has just changed by six";
  EXPECT_EQ(hear(6, quiet(), 3).flags, Flags{});
  EXPECT_EQ(filter_.variance(), Eigen::VectorXd::Zero(3));
}

TEST_F(FleetFilterTest, AccusesLowBatteryCarsWherePassengersMayHaveGivenUp) {
  auto reports = truth();
  reports[0] = said(0, 0, 15);
  reports[0]->waiting = 5;
  EXPECT_EQ(hear(2, reports, 11).flags, Flags{});
  reports[0]->demand = reports[1]->demand = 0;
  reports[0]->low_battery = 5;
  EXPECT_EQ(hear(4, reports, 11).flags, (Flags{{0, ReportField::low_battery, SensorFaultKind::biased, 5, 0, false}}));
}

TEST_F(FleetFilterTest, AccusesDemandBesideCarsThatHaveAlwaysBeenTooMany) {
  begin({said(0, 10, 0), said(1, 10, 0), said(2, 20, 0)});
  hear(2, {said(0, 8, 7), said(1, 9, 1), said(2, 20, 0)}, 3);
  const auto flags = hear(4, {said(0, 6, 7), said(1, 8, 1), said(2, 20, 0)}, 6).flags;
  ASSERT_EQ(flags.size(), 1U);
  EXPECT_EQ(flags[0].region, 0);
  EXPECT_EQ(flags[0].field, ReportField::demand);
}

TEST_F(FleetFilterTest, BelievesAReportThatIsRightAgain) {
  begin({said(0, 16, 0), said(1, 10, 0), said(2, 10, 0)});
  EXPECT_EQ(hear(2, truth(), 3).flags, Flags{});
}

TEST_F(FleetFilterTest, FollowsCarsThatAreOffByAConstant) {
  // In each of two regions two passengers are picked up between reports, and one of the cars is back. Alone the fleet
  // cannot tell how the two share what is not known of those that are back.
  short_trips_ = {{0, 0, 0.4}, {1, 1, 0.4}};
  for (int k = 1; k <= 6; ++k) {
    const auto result = hear(2 * k, {said(0, 10 - k + 6, 2), said(1, 10 - k + 6, 2), said(2, 10, 0)}, 2 * k);
    EXPECT_NEAR(result.reports[0].vacant, 10 - k, 1) << k;
  }
  EXPECT_LT(filter_.variance()(0), 2.0);
}

TEST_F(FleetFilterTest, BelievesAllWhoTellTheTruthAgainOnceTheCityIsTheFleetWithThem) {
  // In each of two regions a passenger is picked up between reports; all cars come back to region 0. While both lie by
  // numbers that change, nobody knows how the two share what came back.
  begin({said(0, 15, 0), said(1, 15, 0), said(2, 0, 0)});
  short_trips_ = {{0, 0, 0.5}, {1, 1, 0.5}};
  const int lies[] = {6, -5, 7, -6, 5, -4, 7, -3, 6, -4};
  int tick = 0;
  int gone = 0;
  for (const int lie : lies) {
    hear(tick += 2, {said(0, 15 + lie, 1), said(1, 15 - ++gone - lie, 1), said(2, 0, 0)}, gone);
  }
  EXPECT_EQ(filter_.variance()(2), 0.0);
  EXPECT_GT(filter_.variance()(0), 0.5) << "is estimated";
  for (int k = 0; k < 3; ++k) {
    hear(tick += 2, {said(0, 15, 1), said(1, 15 - ++gone, 1), said(2, 0, 0)}, gone);
  }
  EXPECT_EQ(filter_.variance(), Eigen::VectorXd::Zero(3));
}

/// Two regions send each other four cars between reports, twice as many as the model says.
class BusyDayTest : public FleetFilterTest {
 protected:
  BusyDayTest() { short_trips_ = {{0, 1, 0.5}, {1, 0, 0.5}}; }

  /// How far vacant cars are from what is expected of them, at the last of so many such reports; region 0 says so many
  /// passengers too many.
  double surprised_after(int reports, int too_many = 0) {
    FieldInnovations vacant;
    for (int k = 0; k < reports; ++k) {
      vacant = hear(tick_ += 2, {said(0, 10, 4 + too_many), said(1, 10, 4), said(2, 10, 0)}).innovations[0];
    }
    return vacant.squares / vacant.counts;
  }

 private:
  int tick_ = 0;
};

TEST_F(BusyDayTest, IsFollowed) {
  EXPECT_DOUBLE_EQ(surprised_after(1), 2.0);
  EXPECT_LT(surprised_after(10), 0.5);
}

TEST_F(BusyDayTest, IsNotSeenInALie) {
  surprised_after(1, 9);
  EXPECT_GT(surprised_after(1), 1.5);
}

}  // namespace
}  // namespace evbal
