#include "tools/fit/fit_city.hpp"

#include "common/error.hpp"
#include "tools/fit/training_day.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

constexpr int leads = 2;                      ///< steps that plans look ahead (BalancingParameters::tau)
constexpr std::uint64_t training_seed = 101;  ///< of the passengers' minutes, batteries and sessions
/// Cars that a row of transitions is shrunk by.
constexpr double prior_cars = 50.0;
/// Minutes after midnight at which transitions change.
const std::vector<int> period_starts{5 * 60, 7 * 60, 10 * 60, 16 * 60, 19 * 60, 22 * 60};
constexpr std::array<int, 6> resample_sizes{10, 20, 50, 100, 500, 1000};

CountDay pickups(const City& city, const DemandDay& day) {
  CountDay out{day_kind(day.date, day.holiday),
               Eigen::MatrixXd::Zero(city.size(), static_cast<Eigen::Index>(day.steps.size()))};
  for (std::size_t step = 0; step < day.steps.size(); ++step) {
    for (const TripCount& pair : day.steps[step]) {
      out.counts(pair.origin, static_cast<Eigen::Index>(step)) += pair.trips;
    }
  }
  return out;
}

std::vector<DemandDay> demand_of(const City& city, const std::vector<std::string>& dates) {
  std::vector<DemandDay> days;
  days.reserve(dates.size());
  for (const std::string& date : dates) {
    days.push_back(read_demand(city, date));
  }
  return days;
}

std::vector<CountDay> pickups(const City& city, const std::vector<DemandDay>& days) {
  std::vector<CountDay> out;
  out.reserve(days.size());
  for (const DemandDay& day : days) {
    out.push_back(pickups(city, day));
  }
  return out;
}

Skill total_skill(const std::vector<HeldOutDay>& days) {
  Skill sum = days.at(0).skill;
  for (std::size_t d = 1; d < days.size(); ++d) {
    sum += days[d].skill;
  }
  return sum;
}

/// Written numbers stay short: a millionth of a vehicle is nothing.
Eigen::MatrixXd rounded(const Eigen::MatrixXd& matrix) {
  return (matrix * 1e6).array().round() / 1e6;
}

struct FittedSeries {
  SeriesModel model;
  Eigen::MatrixXd residuals;  ///< of `regions`' rows and all others
  Skill skill;
  SeasonalOrders orders;
};

void round(ArimaModel& arma) {
  arma.ar = rounded(arma.ar);
  arma.ma = rounded(arma.ma);
  arma.variance = std::round(arma.variance * 1e6) / 1e6;
}

FittedSeries fit_series(const std::vector<CountDay>& days, int step_minutes, const std::vector<int>& regions) {
  FittedSeries out;
  out.orders = choose_orders(days);
  const std::vector<HeldOutDay> held_out = leave_one_day_out(days, step_minutes, out.orders, leads);
  out.skill = total_skill(held_out);
  const Eigen::Index per_day = held_out[0].residuals.cols();
  out.residuals.resize(held_out[0].residuals.rows(), per_day * static_cast<Eigen::Index>(held_out.size()));
  for (std::size_t d = 0; d < held_out.size(); ++d) {
    out.residuals.middleCols(per_day * static_cast<Eigen::Index>(d), per_day) = held_out[d].residuals;
  }
  SeasonalModel& seasonal = out.model.seasonal;
  seasonal = fit_seasonal(days, step_minutes, out.orders);
  for (Eigen::MatrixXd& mean : seasonal.mean) {
    mean = rounded(mean);
  }
  round(seasonal.city);
  std::ranges::for_each(seasonal.region, round);
  ResidualLaw& errors = out.model.errors;
  errors = fit_residual_law(out.residuals, leads, regions, {});
  errors.covariance.deviation = rounded(errors.covariance.deviation);
  errors.covariance.factors = rounded(errors.covariance.factors);
  return out;
}

std::vector<int> all_regions(const City& city) {
  std::vector<int> regions(city.regions.size());
  std::iota(regions.begin(), regions.end(), 0);
  return regions;
}

std::vector<int> regions_with_points(const City& city) {
  std::vector<int> regions;
  const Eigen::VectorXi points = city.points();
  for (int i = 0; i < city.size(); ++i) {
    if (points(i) > 0) {
      regions.push_back(i);
    }
  }
  return regions;
}

/// Mean of the law with these quantiles at equally spaced probabilities, linear in between.
double mean_of_quantiles(const std::vector<double>& quantiles) {
  double sum = 0.0;
  for (std::size_t q = 1; q < quantiles.size(); ++q) {
    sum += (quantiles[q - 1] + quantiles[q]) / 2.0;
  }
  return sum / static_cast<double>(quantiles.size() - 1);
}

CityModel model_of_demand(const City& city, const std::vector<DemandDay>& days, const SeriesModel& demand) {
  CityModel model;
  model.city = city.name;
  model.day_start = city.day_start;
  model.step_minutes = city.step_minutes;
  model.holidays = city.holidays;
  model.demand = demand;
  model.mean_session_minutes = mean_of_quantiles(city.charging.session_quantiles);
  // `greedy` knows neither completions nor transitions; these stand in until the plant has played.
  const Eigen::Index n = city.size();
  const auto steps = static_cast<Eigen::Index>(days[0].steps.size());
  model.completions.seasonal.mean.fill(Eigen::MatrixXd::Zero(n, steps));
  model.completions.seasonal.step_minutes = city.step_minutes;
  model.completions.seasonal.region.resize(city.regions.size());
  model.completions.errors = fit_residual_law(Eigen::MatrixXd::Zero(n * leads, 2), leads, {}, {});
  const TransitionCounts unseen(city.size());
  model.periods = {{period_starts[0], transitions_of(unseen, unseen, 1.0)}};
  return model;
}

World training_world(const City& city, const DemandDay& day) {
  World world;
  world.city = city;
  world.day = day;
  world.clock.start = city.day_start;
  world.clock.step = city.step_minutes;
  world.clock.end = city.day_start + static_cast<int>(day.steps.size()) * city.step_minutes;
  world.seed = training_seed;
  return world;
}

Eigen::MatrixXd rows_of_regions(const Eigen::MatrixXd& residuals, const std::vector<int>& regions) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index block = 0; block < residuals.rows(); block += residuals.rows() / leads) {
    for (const int region : regions) {
      rows.push_back(block + region);
    }
  }
  return residuals(rows, Eigen::all);
}

Thresholds thresholds_at(int resample, const FittedSeries& series, const std::vector<int>& regions) {
  if (regions.empty()) {
    return {};
  }
  const Eigen::MatrixXd residuals = rows_of_regions(series.residuals, regions);
  const Covariance& full = series.model.errors.covariance;
  const Covariance own{rows_of_regions(full.deviation, regions), rows_of_regions(full.factors, regions)};
  return bootstrap_thresholds(residuals, own, {.resample = resample});
}

}  // namespace

CityFit fit_city(const City& city, const std::function<void(const std::string&)>& tell) {
  if (city.train_days.size() < 3) {
    throw bad_input(city.name + " has " + std::to_string(city.train_days.size()) +
                    " training days; three at least are needed");
  }
  const std::vector<DemandDay> days = demand_of(city, city.train_days);
  const std::vector<int> regions = all_regions(city);
  const std::vector<int> stations = regions_with_points(city);
  CityFit fit;
  tell("demand: " + std::to_string(days.size()) + " training days on record");
  const FittedSeries demand = fit_series(pickups(city, days), city.step_minutes, regions);
  fit.model = model_of_demand(city, days, demand.model);

  std::vector<CountDay> completions;
  std::vector<TransitionCounts> periods(period_starts.size(), TransitionCounts(city.size()));
  for (const DemandDay& day : days) {
    tell("plant: " + day.date + " under greedy");
    const TrainingDay played = play_training_day(training_world(city, day), fit.model, period_starts);
    completions.push_back({day_kind(day.date, day.holiday), played.completions});
    for (std::size_t period = 0; period < periods.size(); ++period) {
      periods[period] += played.transitions[period];
    }
    fit.served += played.served;
    fit.lost += played.lost;
  }

  tell("completions and transitions of the days played");
  const FittedSeries charged = fit_series(completions, city.step_minutes, stations);
  fit.model.completions = charged.model;
  const TransitionCounts whole_day = std::accumulate(periods.begin(), periods.end(), TransitionCounts(city.size()),
                                                     [](TransitionCounts sum, const auto& one) { return sum += one; });
  fit.model.periods.clear();
  for (std::size_t period = 0; period < periods.size(); ++period) {
    fit.model.periods.push_back({period_starts[period], transitions_of(periods[period], whole_day, prior_cars)});
  }

  tell("thresholds by resample size");
  for (const int resample : resample_sizes) {
    fit.thresholds.push_back(
        {resample, thresholds_at(resample, demand, regions), thresholds_at(resample, charged, stations)});
  }
  fit.demand = demand.skill;
  fit.completions = charged.skill;
  const SeasonalMeans rival = seasonal_means(pickups(city, days));
  std::vector<HeldOutDay> tested;
  for (const CountDay& day : pickups(city, demand_of(city, city.test_days))) {
    tested.push_back(hold_out(demand.model.seasonal, rival, day, leads));
  }
  fit.demand_test = total_skill(tested);
  return fit;
}

}  // namespace evbal
