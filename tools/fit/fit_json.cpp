#include "tools/fit/fit_json.hpp"

#include "common/clock.hpp"
#include "tools/fit/trip_shares.hpp"
#include "tools/fit/turnover_fit.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <vector>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;
using Days = std::vector<HeldOutDay>;

Json by_days(const Days& training, const Days& test, const std::function<Json(const Days&)>& told) {
  return {{"training", training.empty() ? Json() : told(training)}, {"test", test.empty() ? Json() : told(test)}};
}

/// Squared errors by steps ahead, as shares of the rivals'.
Json errors_json(const Skill& skill) {
  const auto shares = [&](const Eigen::MatrixXd& rival) {
    const Eigen::RowVectorXd of = skill.forecast.colwise().sum().array() / rival.colwise().sum().array();
    return std::vector<double>(of.begin(), of.end());
  };
  return {{"of_seasonal_mean", shares(skill.seasonal_mean)}, {"of_last_value", shares(skill.last_value)}};
}

Json order_json(const ArmaOrder& order) {
  return {{"p", order.p}, {"q", order.q}};
}

Json city_json(const SeriesFit& fit, const Days& days) {
  const Skill skill = skill_of(days);
  Json json = errors_json(skill);
  json["regions_worse_than_seasonal_mean"] =
      (skill.forecast.rowwise().sum().array() > skill.seasonal_mean.rowwise().sum().array()).count();
  json["alarms_a_day"] = alarms_a_day(fit.model, days);
  return json;
}

Json region_json(const SeriesFit& fit, const std::string& name, int region) {
  if (is_thin(fit.orders, region)) {
    return {{"region", name}, {"order", nullptr}};
  }
  const auto errors = [region](const Days& days) {
    const Skill skill = skill_of(days);
    return errors_json({skill.forecast.row(region), skill.seasonal_mean.row(region), skill.last_value.row(region)});
  };
  Json json = {{"region", name}, {"order", order_json(fit.orders.region[static_cast<std::size_t>(region)])}};
  json.update(by_days(fit.training, fit.test, errors));
  return json;
}

Json thresholds_json(const ThresholdRow& row) {
  const auto& [value, error] = row.thresholds;
  Json json = {{"resample", row.resample}, {"g1", value.g1},       {"g1_error", error.g1},
               {"g2", value.g2},           {"g2_error", error.g2}, {"coverage", nullptr}};
  if (row.test) {
    json["coverage"] = {{"g1", row.test->g1}, {"g2", row.test->g2}, {"both", row.test->both}};
  }
  return json;
}

Json series_json(const SeriesFit& fit, const std::vector<Region>& regions) {
  Json json = {{"order", order_json(fit.orders.city)}, {"alarm", fit.model.errors.alarm}};
  json.update(by_days(fit.training, fit.test, [&fit](const Days& days) { return city_json(fit, days); }));
  json["regions"] = Json::array();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    json["regions"].push_back(region_json(fit, regions[i].name, static_cast<int>(i)));
  }
  json["thresholds"] = Json::array();
  for (const ThresholdRow& row : fit.thresholds) {
    json["thresholds"].push_back(thresholds_json(row));
  }
  return json;
}

Json turnover_json(const CityFit& fit) {
  const Turnover& turnover = fit.model.turnover;
  Json json = {{"phi", turnover.phi}, {"trials", Json::array()}};
  for (const PhiTrial& trial : fit.phi) {
    json["trials"].push_back(
        {{"phi", trial.phi}, {"lost", trial.lost}, {"idle_km", trial.idle_km}, {"cost", trial.cost}});
  }
  const auto leads = static_cast<int>(turnover.demand.linear.size());
  json["variance"] = {{"linear", turnover.demand.linear}, {"quadratic", turnover.demand.quadratic}};
  const auto tenths = [&](const Days& days) {
    Json steps = Json::array();
    const Eigen::MatrixXd shares = integral_transform(days, turnover.demand, leads);
    for (const auto& step : shares.colwise()) {
      steps.push_back(std::vector<double>(step.begin(), step.end()));
    }
    return steps;
  };
  json["integral_transform"] = by_days(fit.demand.training, fit.demand.test, tenths);
  return json;
}

Json trips_json(const CityModel& model) {
  Json json = Json::array();
  for (const TripPeriod& period : model.trips) {
    json.push_back({{"start", time_of_day({.start = 0}, period.start)},
                    {"pairs", period.shares.size()},
                    {"within", share_within(period, model.regions())}});
  }
  return json;
}

}  // namespace

std::string fit_json(const City& city, const CityFit& fit, const std::filesystem::path& model) {
  const Json json = {{"model", model.string()},
                     {"greedy", {{"served", fit.served}, {"lost", fit.lost}}},
                     {"demand", series_json(fit.demand, city.regions)},
                     {"completions", series_json(fit.completions, city.regions)},
                     {"turnover", turnover_json(fit)},
                     {"trips", trips_json(fit.model)}};
  return json.dump(2) + "\n";
}

}  // namespace evbal
