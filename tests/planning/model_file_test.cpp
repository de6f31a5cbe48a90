#include "common/error.hpp"
#include "tests/planning/small_city.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace evbal {
namespace {

class ModelFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string written(const CityModel& model) const {
    write_model(model, file_);
    std::ifstream in(file_);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  void expect_refused(const std::string& text, const std::string& word) const {
    std::ofstream(file_) << text;
    try {
      read_model(file_);
      FAIL() << "was accepted, expected a refusal about " << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(file_.string()), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ("evbal-model-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
  std::filesystem::path file_ = folder_ / "model.json";
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST_F(ModelFile, GivesBackEveryBit) {
  CityModel model = testing::small_model();
  model.demand.seasonal.mean[1](2, 7) = 0.1 + 0.2;
  model.completions.errors.covariance.factors = Eigen::MatrixXd(6, 0);
  model.car_values.fill(Eigen::MatrixXd::Constant(3, 38, 0.125));
  model.car_values[2](1, 37) = 0.3;
  const std::string text = written(model);
  const CityModel back = read_model(file_);
  EXPECT_EQ(back.demand.seasonal.mean, model.demand.seasonal.mean);
  EXPECT_EQ(back.demand.seasonal.region[2].ma, model.demand.seasonal.region[2].ma);
  EXPECT_EQ(back.demand.seasonal.city.ar, model.demand.seasonal.city.ar);
  EXPECT_EQ(back.demand.errors.covariance.deviation, model.demand.errors.covariance.deviation);
  EXPECT_EQ(back.completions.errors.covariance.factors.cols(), 0);
  EXPECT_EQ(back.completions.errors.alarm, model.completions.errors.alarm);
  EXPECT_EQ(back.periods[1].start, 16 * 60);
  EXPECT_EQ(back.periods[0].transitions.vacant_to_occupied, model.periods[0].transitions.vacant_to_occupied);
  ASSERT_EQ(back.trips.size(), 2U);
  EXPECT_EQ(back.trips[0].shares[4].destination, 2);
  EXPECT_EQ(back.trips[0].shares[4].share, 0.25);
  EXPECT_EQ(back.car_values, model.car_values);
  EXPECT_EQ(written(back), text);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "nothing half-written stays";
}

// Of several hundred regions nearly all transitions are 0.
TEST_F(ModelFile, RowsThatAreMostlyZeroAreWrittenAsTheirOtherNumbers) {
  const std::filesystem::path shipped = test::in_source("experiments/cities/shenzhen-54/model.json");
  const CityModel model = read_model(shipped);
  const std::string text = written(model);
  EXPECT_LT(text.size(), std::filesystem::file_size(shipped) * 95 / 100);
  const CityModel back = read_model(file_);
  ASSERT_EQ(back.periods.size(), model.periods.size());
  for (std::size_t period = 0; period < model.periods.size(); ++period) {
    const Transitions& transitions = back.periods[period].transitions;
    EXPECT_EQ(transitions.vacant_to_vacant, model.periods[period].transitions.vacant_to_vacant);
    EXPECT_EQ(transitions.vacant_to_low_battery, model.periods[period].transitions.vacant_to_low_battery);
    EXPECT_EQ(transitions.occupied_to_occupied, model.periods[period].transitions.occupied_to_occupied);
  }
  EXPECT_EQ(back.turnover.same_step_dropoffs, model.turnover.same_step_dropoffs);
  EXPECT_EQ(written(back), text);
}

TEST_F(ModelFile, RefusesOtherNumbersThatAreNone) {
  const std::string rows = "\"vacant_to_vacant\":[[0.5,0.0,0.0]";
  const std::string good = written(testing::small_model());
  const auto with_row = [&](const std::string& row) { return replaced(good, rows, "\"vacant_to_vacant\":[" + row); };
  std::ofstream(file_) << with_row(R"({"columns":[0],"values":[0.5]})");
  EXPECT_EQ(read_model(file_).periods[0].transitions.vacant_to_vacant(0, 0), 0.5);
  expect_refused(with_row(R"({"columns":[0]})"), "periods[0].vacant_to_vacant[0].values");
  expect_refused(with_row(R"({"columns":[0,1],"values":[0.5]})"), "as many numbers");
  expect_refused(with_row(R"({"columns":[0,0],"values":[0.25,0.25]})"), "ascending");
  expect_refused(with_row(R"({"columns":[0.5],"values":[0.5]})"), "whole numbers");
  expect_refused(with_row(R"({"columns":[3],"values":[0.5]})"), "[0, 2]");
  expect_refused(with_row(R"({"columns":[0],"values":[1.5]})"), "[0, 1]");
  expect_refused(with_row(R"({"columns":[0],"values":[0.5],"more":1})"), "more");
}

TEST_F(ModelFile, RefusesWhatDoesNotFit) {
  const std::string good = written(testing::small_model());
  expect_refused(good.substr(0, good.size() / 2), "JSON");
  expect_refused(replaced(good, "\"schema\"", "\"city\": \"x\", \"schema\""), "twice");
  expect_refused(replaced(good, "\"schema\": 5", "\"schema\": 4"), "anew by `evbal fit`");
  expect_refused(replaced(good, "\"mean_session_minutes\"", "\"mean_session\""), "mean_session_minutes");
  expect_refused(replaced(good, "\"holidays\"", "\"extra\": 1, \"holidays\""), "extra");
  expect_refused(replaced(good, "\"regions\": 3", "\"regions\": 4"), "4 lists");
  expect_refused(replaced(good, "\"leads\": 2", "\"leads\": 3"), "deviation");
  expect_refused(replaced(good, "\"ar\":[0.8]", "\"ar\":[1.8]"), "dies away");
  expect_refused(replaced(good, "4.0", "-4.0"), "mean.");
  expect_refused(replaced(good, "4.0", "\"4\""), "number");
  expect_refused(replaced(good, "\"vacant_to_vacant\":[[0.5", "\"vacant_to_vacant\":[[0.4"), "sum to one");
  expect_refused("[]", "object");
}

TEST_F(ModelFile, RefusesTripsThatGoNowhere) {
  const std::string good = written(testing::small_model());
  const std::string from = "\"from\":[0,1,2]";
  expect_refused(replaced(good, from, "\"from\":[0,1]"), "trips[1].from");
  expect_refused(replaced(good, from, "\"from\":[0,1,3]"), "trips[1].from");
  expect_refused(replaced(good, from, "\"from\":[0,1,1.5]"), "numbers of regions");
  expect_refused(replaced(good, from, "\"from\":[1,0,2]"), "ascending");
  expect_refused(replaced(good, from, "\"from\":[0,1,1]"), "sum to one");
  expect_refused(replaced(good, "\"share\":[1.0", "\"share\":[0.9"), "trips[1].share");
}

// Numbers that no city has would make problems that no solver can scale.
TEST_F(ModelFile, RefusesAbsurdNumbers) {
  const auto expect_refused_model = [&](const char* key, const auto& spoil) {
    CityModel model = testing::small_model();
    spoil(model);
    expect_refused(written(model), key);
  };
  expect_refused_model("completions.deviation",
                       [](CityModel& m) { m.completions.errors.covariance.deviation(4) = 1e8; });
  expect_refused_model("demand.deviation", [](CityModel& m) { m.demand.errors.covariance.deviation(0) = 2e3; });
  expect_refused_model("demand.factors", [](CityModel& m) { m.demand.errors.covariance.factors(1, 0) = -1e8; });
  expect_refused_model("demand.factors", [](CityModel& m) { m.demand.errors.covariance.factors.setOnes(6, 7); });
  expect_refused_model("demand.g1", [](CityModel& m) { m.demand.errors.thresholds[1].g1 = 1e8; });
  expect_refused_model("completions.g2", [](CityModel& m) { m.completions.errors.thresholds[0].g2 = 1e8; });
  expect_refused_model("demand.alarm", [](CityModel& m) { m.demand.errors.alarm = 1e8; });
  expect_refused_model("demand.mean.sunday", [](CityModel& m) { m.demand.seasonal.mean[2](2, 3) = 30001.0; });
  expect_refused_model("demand.city.variance", [](CityModel& m) { m.demand.seasonal.city.variance = 1e8; });
  expect_refused_model("demand.region[1].ma", [](CityModel& m) { m.demand.seasonal.region[1].ma(0) = 1.5; });
  expect_refused_model("day_start", [](CityModel& m) { m.day_start = 5 * 60 + 1; });
  expect_refused_model("holidays", [](CityModel& m) { m.holidays = {"2008-02-30"}; });
  expect_refused_model("car_values.weekday", [](CityModel& m) { m.car_values.fill(Eigen::MatrixXd::Ones(3, 37)); });
  expect_refused_model("car_values.sunday", [](CityModel& m) {
    m.car_values.fill(Eigen::MatrixXd::Ones(3, 38));
    m.car_values[2](0, 0) = -1.0;
  });
  expect_refused_model("turnover.same_step_dropoffs",
                       [](CityModel& m) { m.turnover.same_step_dropoffs.setConstant(0.34); });
}

TEST_F(ModelFile, RefusesWhatIsNotThere) {
  EXPECT_THROW(read_model(folder_ / "none.json"), Error);
  EXPECT_THROW(write_model(testing::small_model(), folder_ / "none" / "model.json"), Error);
}

TEST(CityModel, KnowsHolidaysAndPeriods) {
  CityModel model = testing::small_model();
  EXPECT_EQ(model.kind("2008-05-26"), DayKind::sunday);
  EXPECT_EQ(model.kind("2008-05-27"), DayKind::weekday);
  EXPECT_EQ(&model.transitions_at(15 * 60 + 59), &model.periods[0].transitions);
  EXPECT_EQ(&model.transitions_at(16 * 60), &model.periods[1].transitions);
  EXPECT_EQ(&model.transitions_at(0), &model.periods[0].transitions);
  EXPECT_EQ(&model.trips_at(7 * 60 - 1), &model.trips[0].shares);
  EXPECT_EQ(&model.trips_at(7 * 60), &model.trips[1].shares);
}

TEST(CityModel, ValuesCarsBetweenTheStartsOfSteps) {
  CityModel model = testing::small_model();
  EXPECT_EQ(model.car_value(DayKind::weekday, 1, 400.0), 0.0) << "a model without values";
  model.car_values.fill(Eigen::MatrixXd::Constant(3, 38, 8.0));
  model.car_values[0](1, 4) = 6.0;
  EXPECT_DOUBLE_EQ(model.car_value(DayKind::weekday, 1, 5 * 60 + 4 * 30), 6.0);
  EXPECT_DOUBLE_EQ(model.car_value(DayKind::weekday, 1, 5 * 60 + 4 * 30 + 7.5), 6.5);
  EXPECT_DOUBLE_EQ(model.car_value(DayKind::sunday, 1, 5 * 60 + 4 * 30 + 7.5), 8.0);
  EXPECT_DOUBLE_EQ(model.car_value(DayKind::weekday, 1, 0.0), 8.0) << "before the day as at its start";
  EXPECT_DOUBLE_EQ(model.car_value(DayKind::weekday, 1, 24 * 60 - 15), 4.0);
  EXPECT_DOUBLE_EQ(model.car_value(DayKind::weekday, 1, 24 * 60 + 40), 0.0);
}

}  // namespace
}  // namespace evbal
