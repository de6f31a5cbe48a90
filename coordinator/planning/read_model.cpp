#include "coordinator/planning/city_model.hpp"
#include "coordinator/planning/json_reader.hpp"
#include "coordinator/planning/model_keys.hpp"
#include "coordinator/planning/report_check.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

using nlohmann::json;
using namespace model_keys;

// No city comes near these; far beyond them a problem has numbers that no solver can scale.
constexpr double most_a_minute = most_passengers_a_minute;  // mean count of a region
constexpr double most_deviation = 1e3;                      // of errors in units of their scale, 1 for Poisson counts
constexpr double most_threshold = 1e4;                      // g1, g2
constexpr double most_square = most_deviation * most_deviation;
constexpr double most_coefficient = 10.0;  // of autoregressions and moving averages that die away
constexpr double most_value = 1e6;         // of a car, in km

struct Shape {
  int regions = 0;
  int steps = 0;
  int leads = 0;
  int step_minutes = 0;
};

Eigen::VectorXd read_vector(JsonObject& in, const char* key, double low, double high) {
  const std::vector<double> numbers = in.numbers(key, low, high);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

ArmaModel read_arma(JsonObject in) {
  ArmaModel arma;
  arma.ar = read_vector(in, "ar", -most_coefficient, most_coefficient);
  arma.ma = read_vector(in, "ma", -most_coefficient, most_coefficient);
  arma.variance = in.number("variance", 0.0, most_square);
  if (!stationary(arma.ar)) {
    throw in.error("ar", "an autoregression that dies away is expected");
  }
  if (!invertible(arma.ma)) {
    throw in.error("ma", "a moving average that can be inverted is expected");
  }
  in.finish();
  return arma;
}

/// A number for each region and step of a day of each kind.
std::array<Eigen::MatrixXd, day_kinds> read_by_kind(JsonObject in, const Shape& shape, double most) {
  std::array<Eigen::MatrixXd, day_kinds> by_kind;
  for (std::size_t kind = 0; kind < kind_names.size(); ++kind) {
    by_kind[kind] = in.matrix(kind_names[kind], shape.regions, shape.steps, 0.0, most);
  }
  in.finish();
  return by_kind;
}

SeriesModel read_series(JsonObject in, const Shape& shape) {
  SeriesModel series;
  series.seasonal.step_minutes = shape.step_minutes;
  const double most_mean = most_a_minute * shape.step_minutes;
  series.seasonal.mean = read_by_kind(in.object("mean"), shape, most_mean);
  series.seasonal.city = read_arma(in.object("city"));
  for (JsonObject& region : in.objects("region")) {
    series.seasonal.region.push_back(read_arma(region));
  }
  if (series.seasonal.region.size() != static_cast<std::size_t>(shape.regions)) {
    throw in.error("region", "one for each of the " + std::to_string(shape.regions) + " regions is expected");
  }
  const Eigen::Index size = static_cast<Eigen::Index>(shape.regions) * shape.leads;
  series.errors.covariance.deviation = read_vector(in, "deviation", 0.0, most_deviation);
  if (series.errors.covariance.deviation.size() != size) {
    throw in.error("deviation", std::to_string(size) + " numbers are expected");
  }
  series.errors.covariance.factors = in.matrix("factors", size, -most_deviation, most_deviation);
  if (series.errors.covariance.factors.cols() > size) {
    throw in.error("factors", "at most " + std::to_string(size) + " columns are expected");
  }
  const auto g1 = in.numbers("g1", 0.0, most_threshold);
  const auto g2 = in.numbers("g2", 0.0, most_threshold);
  if (g1.size() != static_cast<std::size_t>(shape.leads) || g2.size() != g1.size()) {
    throw in.error("g1", std::to_string(shape.leads) + " numbers are expected, and as many of g2");
  }
  for (std::size_t lead = 0; lead < g1.size(); ++lead) {
    series.errors.thresholds.push_back({g1[lead], g2[lead]});
  }
  series.errors.alarm = in.number("alarm", 0.0, most_square);
  in.finish();
  return series;
}

Turnover read_turnover(JsonObject in, const Shape& shape) {
  Turnover turnover;
  turnover.phi = in.number("phi", 0.0, 1.0);
  turnover.demand.linear = in.numbers("variance_linear", 0.0, 100.0);
  turnover.demand.quadratic = in.numbers("variance_quadratic", 0.0, 100.0);
  if (turnover.demand.linear.empty() || turnover.demand.linear.size() != turnover.demand.quadratic.size()) {
    throw in.error("variance_linear", "one number at least is expected, and as many of variance_quadratic");
  }
  turnover.same_step_dropoffs = in.matrix("same_step_dropoffs", shape.regions, shape.regions, 0.0, 1.0);
  if (!(turnover.same_step_dropoffs.rowwise().sum().array() <= 1.0 + 1e-6 * shape.regions).all()) {
    throw in.error("same_step_dropoffs", "the shares of one region's trips add up to more than one");
  }
  in.finish();
  return turnover;
}

void check_rows(const JsonObject& in, const char* key, const Eigen::MatrixXd& sum) {
  if (!((sum.rowwise().sum().array() - 1.0).abs() < 1e-9).all()) {
    throw in.error(key, "the rows of one state's transitions do not sum to one");
  }
}

Period read_period(JsonObject in, const Shape& shape) {
  Period period{in.integer("start", 0, 24 * 60), {}};
  Transitions& t = period.transitions;
  for (const auto& [key, matrix] : transition_keys) {
    t.*matrix = in.matrix(key, shape.regions, shape.regions, 0.0, 1.0);
  }
  check_rows(in, "vacant_to_vacant", t.vacant_to_vacant + t.vacant_to_occupied + t.vacant_to_low_battery);
  check_rows(in, "occupied_to_vacant", t.occupied_to_vacant + t.occupied_to_occupied);
  in.finish();
  return period;
}

std::vector<int> read_regions(JsonObject& in, const char* key, const Shape& shape) {
  std::vector<int> regions;
  for (const double number : in.numbers(key, 0.0, shape.regions - 1.0)) {
    if (number != std::floor(number)) {
      throw in.error(key, "numbers of regions are expected");
    }
    regions.push_back(static_cast<int>(number));
  }
  return regions;
}

TripPeriod read_trip_period(JsonObject in, const Shape& shape) {
  TripPeriod period{in.integer("start", 0, 24 * 60), {}};
  const std::vector<int> from = read_regions(in, "from", shape);
  const std::vector<int> to = read_regions(in, "to", shape);
  const std::vector<double> share = in.numbers("share", 0.0, 1.0);
  if (to.size() != from.size() || share.size() != from.size()) {
    throw in.error("from", "as many numbers are expected as of `to` and of `share`");
  }
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(shape.regions);
  for (std::size_t pair = 0; pair < from.size(); ++pair) {
    period.shares.push_back({from[pair], to[pair], share[pair]});
    sum(from[pair]) += share[pair];
  }
  const auto not_before = [](const TripShare& a, const TripShare& b) {
    return std::pair(a.origin, a.destination) >= std::pair(b.origin, b.destination);
  };
  if (std::ranges::adjacent_find(period.shares, not_before) != period.shares.end()) {
    throw in.error("from", "pairs by ascending `from` and `to` are expected, each once");
  }
  if (!((sum.array() - 1.0).abs() < 1e-9).all()) {
    throw in.error("share", "the shares of each region's trips are to sum to one");
  }
  in.finish();
  return period;
}

/// Periods by ascending start, at least one.
template <class ReadPeriod>
auto read_periods(JsonObject& in, const char* key, const ReadPeriod& read) {
  std::vector<decltype(read(in))> periods;
  for (JsonObject& period : in.objects(key)) {
    periods.push_back(read(period));
  }
  const auto not_later = [](const auto& a, const auto& b) { return a.start >= b.start; };
  if (periods.empty() || std::ranges::adjacent_find(periods, not_later) != periods.end()) {
    throw in.error(key, "one at least is expected, by ascending start");
  }
  return periods;
}

}  // namespace

CityModel read_model(const std::filesystem::path& file) {
  const json root = parse_json(file);
  JsonObject in(root, file.string(), "");
  if (in.integer("schema", 1, 1000) != schema) {
    throw in.error("schema", std::to_string(schema) + " is expected; make the model anew by `evbal fit`");
  }
  CityModel model;
  model.city = in.text("city");
  model.day_start = in.integer("day_start", 0, 24 * 60);
  model.step_minutes = in.integer("step_minutes", 1, 24 * 60);
  model.holidays = in.texts("holidays");
  std::sort(model.holidays.begin(), model.holidays.end());
  for (const std::string& date : model.holidays) {
    if (!is_date(date)) {
      throw in.error("holidays", "`" + date + "` is no date; write it as 2008-06-03");
    }
  }
  const Shape shape{in.integer("regions", 1, 10000), in.integer("steps", 1, 24 * 60), in.integer("leads", 1, 48),
                    model.step_minutes};
  if (model.day_start + shape.steps * model.step_minutes > 24 * 60) {
    throw in.error("day_start", "a day of " + std::to_string(shape.steps) + " steps that ends by midnight is expected");
  }
  model.demand = read_series(in.object("demand"), shape);
  model.completions = read_series(in.object("completions"), shape);
  model.periods = read_periods(in, "periods", [&](const JsonObject& period) { return read_period(period, shape); });
  model.trips = read_periods(in, "trips", [&](const JsonObject& period) { return read_trip_period(period, shape); });
  if (in.has("car_values")) {
    model.car_values = read_by_kind(in.object("car_values"), shape, most_value);
  }
  model.turnover = read_turnover(in.object("turnover"), shape);
  model.mean_session_minutes = in.number("mean_session_minutes", 1.0, 24.0 * 60.0);
  in.finish();
  return model;
}

}  // namespace evbal
