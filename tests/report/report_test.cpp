#include "tools/report/report.hpp"

#include "common/error.hpp"
#include "tools/report/assets.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace evbal {
namespace {

ReportedRun small_run(const std::string& controller) {
  ReportedRun run;
  run.folder = "runs/" + controller;
  run.scenario = "small </script>";
  run.date = "2008-06-03";
  run.controller = controller;
  run.day_start = "05:00";
  run.step_minutes = 30;
  run.totals = {{"idle_km", 12.5}};
  run.plan_costs = {{"km", 4.5}};
  run.steps = {{"step", {0, 1}}, {"idle_km", {5.25, 7.25}}};
  run.faults = {{{.name = "spike", .type = "demand.scale", .start = 30, .end = 60}}};
  return run;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Report, HoldsTheRunsAndEveryFaultOnce) {
  const std::string page = report_page({.runs = {small_run("nominal"), small_run("robust")}});
  EXPECT_NE(page.find("\"idle_km\":[5.25,7.25]"), std::string::npos);
  EXPECT_NE(page.find("\"label\":\"robust\""), std::string::npos);
  EXPECT_NE(page.find("\"plan_costs\":[{\"term\":\"km\",\"cost\":4.5}]"), std::string::npos);
  EXPECT_NE(page.find("\"windows\":[{\"name\":\"spike\",\"start\":30,\"end\":60}],"), std::string::npos);
}

TEST(Report, TellsRunsOfOneControllerApart) {
  auto other = small_run("robust");
  other.folder = "runs/robust-2";
  const std::string page = report_page({.runs = {small_run("robust"), other}});
  EXPECT_NE(page.find("\"label\":\"robust (robust-2)\""), std::string::npos);
}

TEST(Report, ShowsWhatWasForecast) {
  SeasonalModel model;
  model.mean.fill(Eigen::MatrixXd::Constant(2, 3, 4.0));
  model.region.resize(2);
  model.city.variance = 2.0;
  const Eigen::MatrixXd counts = (Eigen::MatrixXd(2, 3) << 1, 2, 3, 5, 6, 7).finished();
  ForecastFigure figure = forecast_figure(model, DayKind::weekday, 0, counts);
  EXPECT_EQ(figure.observed, Eigen::Vector3d(6.0, 8.0, 10.0));
  EXPECT_EQ(figure.forecast, Eigen::Vector3d(8.0, 8.0, 8.0));
  EXPECT_TRUE(figure.deviation.isApprox(Eigen::Vector3d(4.0, 4.0, 4.0)));
  figure.title = "Demand";
  const std::string page = report_page({.runs = {small_run("robust")}, .forecasts = {figure}});
  EXPECT_NE(page.find("\"observed\":[6.0,8.0,10.0],\"forecast\":[8.0,8.0,8.0]"), std::string::npos);
}

TEST(Report, DrawsRegionsOnAPlane) {
  const LocalFrame frame({37.7749, -122.4194});
  Region region;
  region.name = "north";
  region.outline = {{frame.global({0, 1000}), frame.global({500, 1000})}};
  region.centroid = frame.global({0, 0});
  auto run = small_run("robust");
  run.regions = 1;
  run.step_minutes = 10;
  run.ticks = 4;
  for (const char* column : {"supply", "demand", "lost", "queue_minutes"}) {
    run.by_region[column] = (Eigen::MatrixXd(1, 2) << 0.125, 3).finished();
  }
  run.faults[0].said = {{0, {no_region}}, {2, {0}}};
  run.faults[0].amount = {{2, 3.0}};
  const std::string page = report_page({.runs = {run}, .map = city_map({region})});
  EXPECT_NE(page.find("\"map\":{\"names\":[\"north\"],\"outlines\":[[[0,-100,50,-100]]]}"), std::string::npos);
  EXPECT_NE(page.find("\"supply\":[0.13,3.0]"), std::string::npos);
  EXPECT_NE(page.find("\"regions\":[0],\"acts\":[[1,0]],\"said_minutes\":10,\"seen_minutes\":5"), std::string::npos);
  run.regions = 2;
  EXPECT_EQ(report_page({.runs = {run}, .map = city_map({region})}).find("\"map\":"), std::string::npos);
}

TEST(Report, NamesEachThingOfItsScriptsOnce) {
  std::istringstream lines(page_js);
  std::set<std::string> names;
  const std::regex definition("^(?:(?:async )?function|const|let) (\\w+).*");
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, definition)) {
      EXPECT_TRUE(names.insert(match[1]).second) << match[1] << " is defined twice, and the later one stands";
    }
  }
  EXPECT_GT(names.size(), 100U);
}

TEST(Report, NeedsNothingButItself) {
  const std::string page = report_page({.runs = {small_run("robust")}});
  EXPECT_NE(page.find("d3js.org v5."), std::string::npos);
  EXPECT_NE(page.find("content=\"default-src 'none';"), std::string::npos);
  for (const char* outside : {" src=", "<link", "@import"}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(page.find("fetch(", page.find("id=\"data\"")), std::string::npos) << "D3 could, and is not asked to";
  EXPECT_EQ(count(page, "</script>"), 3);  // no data can end a script
}

TEST(Report, RefusesRunsOfDifferentClocks) {
  auto other = small_run("robust");
  other.step_minutes = 15;
  EXPECT_THROW(report_page({.runs = {small_run("nominal"), other}}), Error);
}

}  // namespace
}  // namespace evbal
