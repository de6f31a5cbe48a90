#include "common/files.hpp"
#include "coordinator/planning/city_model.hpp"
#include "coordinator/planning/model_keys.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace evbal {
namespace {

using nlohmann::json;
using namespace model_keys;

json to_json(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (const auto& row : matrix.rowwise()) {
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

/// The same, with rows that are mostly 0 as their other numbers and their columns.
json sparse_to_json(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (const auto& row : matrix.rowwise()) {
    std::vector<Eigen::Index> columns;
    std::vector<double> values;
    for (Eigen::Index column = 0; column < row.size(); ++column) {
      if (row(column) != 0.0) {
        columns.push_back(column);
        values.push_back(row(column));
      }
    }
    if (2 * (columns.size() + 4) < static_cast<std::size_t>(row.size())) {
      rows.push_back({{"columns", columns}, {"values", values}});
    } else {
      rows.push_back(std::vector<double>(row.begin(), row.end()));
    }
  }
  return rows;
}

json to_json(const Eigen::VectorXd& vector) {
  return std::vector<double>(vector.begin(), vector.end());
}

json to_json(const ArmaModel& arma) {
  return {{"ar", to_json(arma.ar)}, {"ma", to_json(arma.ma)}, {"variance", arma.variance}};
}

json to_json(const std::array<Eigen::MatrixXd, day_kinds>& by_kind) {
  json out;
  for (std::size_t kind = 0; kind < kind_names.size(); ++kind) {
    out[kind_names[kind]] = to_json(by_kind[kind]);
  }
  return out;
}

json to_json(const SeriesModel& series) {
  json region = json::array();
  for (const ArmaModel& arma : series.seasonal.region) {
    region.push_back(to_json(arma));
  }
  std::vector<double> g1;
  std::vector<double> g2;
  for (const Thresholds& thresholds : series.errors.thresholds) {
    g1.push_back(thresholds.g1);
    g2.push_back(thresholds.g2);
  }
  return {{"mean", to_json(series.seasonal.mean)},
          {"city", to_json(series.seasonal.city)},
          {"region", region},
          {"deviation", to_json(series.errors.covariance.deviation)},
          {"factors", to_json(series.errors.covariance.factors)},
          {"g1", g1},
          {"g2", g2},
          {"alarm", series.errors.alarm}};
}

json to_json(const Period& period) {
  json out{{"start", period.start}};
  for (const auto& [key, matrix] : transition_keys) {
    out[key] = sparse_to_json(period.transitions.*matrix);
  }
  return out;
}

json to_json(const TripPeriod& period) {
  std::vector<int> from;
  std::vector<int> to;
  std::vector<double> share;
  for (const TripShare& trips : period.shares) {
    from.push_back(trips.origin);
    to.push_back(trips.destination);
    share.push_back(trips.share);
  }
  return {{"start", period.start}, {"from", from}, {"to", to}, {"share", share}};
}

json to_json(const Turnover& turnover) {
  return {{"phi", turnover.phi},
          {"variance_linear", turnover.demand.linear},
          {"variance_quadratic", turnover.demand.quadratic},
          {"same_step_dropoffs", sparse_to_json(turnover.same_step_dropoffs)}};
}

template <class AnyPeriod>
json all_to_json(const std::vector<AnyPeriod>& periods) {
  json all = json::array();
  for (const AnyPeriod& period : periods) {
    all.push_back(to_json(period));
  }
  return all;
}

}  // namespace

void write_model(const CityModel& model, const std::filesystem::path& file) {
  std::vector<std::pair<std::string, json>> entries{
      {"schema", schema},
      {"city", model.city},
      {"regions", model.regions()},
      {"steps", model.steps()},
      {"leads", model.leads()},
      {"day_start", model.day_start},
      {"step_minutes", model.step_minutes},
      {"holidays", model.holidays},
      {"mean_session_minutes", model.mean_session_minutes},
      {"demand", to_json(model.demand)},
      {"completions", to_json(model.completions)},
      {"turnover", to_json(model.turnover)},
      {"periods", all_to_json(model.periods)},
      {"trips", all_to_json(model.trips)},
  };
  if (model.car_values.front().size() > 0) {
    entries.emplace_back("car_values", to_json(model.car_values));
  }
  std::string text;
  for (const auto& [key, value] : entries) {
    text += (text.empty() ? "{\n\"" : ",\n\"") + std::string(key) + "\": " + value.dump();
  }
  write_file(file, text + "\n}\n");
}

}  // namespace evbal
