#include "tools/fit/fit_city.hpp"

#include "common/error.hpp"
#include "common/parallel.hpp"
#include "tools/fit/car_values.hpp"
#include "tools/fit/training_day.hpp"
#include "tools/fit/trip_shares.hpp"
#include "tools/fit/turnover_fit.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <numeric>

namespace evbal {
namespace {

constexpr std::uint64_t training_seed = 101;  ///< of the passengers' minutes, batteries and sessions

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

/// Mean of the distribution with these quantiles at equally spaced probabilities, linear in between.
double mean_of_quantiles(const std::vector<double>& quantiles) {
  double sum = 0.0;
  for (std::size_t q = 1; q < quantiles.size(); ++q) {
    sum += (quantiles[q - 1] + quantiles[q]) / 2.0;
  }
  return sum / static_cast<double>(quantiles.size() - 1);
}

/// What `greedy` has to know of a city; it knows neither completions, transitions nor turnover.
CityModel model_of_demand(const City& city, const std::vector<DemandDay>& training, int leads,
                          const SeriesModel& demand) {
  CityModel model;
  model.city = city.name;
  model.day_start = city.day_start;
  model.step_minutes = city.step_minutes;
  model.holidays = city.holidays;
  model.demand = demand;
  model.mean_session_minutes = mean_of_quantiles(city.charging.session_quantiles);
  const Eigen::Index n = city.size();
  model.completions.seasonal.step_minutes = city.step_minutes;
  model.completions.seasonal.mean.fill(Eigen::MatrixXd::Zero(n, city.steps_per_day()));
  model.completions.seasonal.region.resize(city.regions.size());
  model.completions.errors = fit_residual_distribution(Eigen::MatrixXd::Zero(n * leads, 2), leads, {}, {});
  const TransitionCounts unseen(city.size());
  model.periods = {{transition_periods()[0], transitions_of(unseen, unseen, 1.0)}};
  model.trips = trip_shares(city, training);
  model.turnover = {{{1.0}, {0.0}}, 0.0, Eigen::MatrixXd::Zero(n, n)};
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

PlanningSettings under(const std::string& controller, int leads) {
  PlanningSettings settings;
  settings.controller = controller;
  settings.engine.name = "cuts";
  settings.balancing.tau = std::min(settings.balancing.tau, leads);
  return settings;
}

/// Training days that phi is tried on: a plan's work grows faster than the number of regions.
std::size_t days_of_phi(const City& city) {
  return city.size() <= 200 ? 3 : 1;
}

/// Plays days spread over the training days under `turnover` with several phi; all else equal.
std::vector<PhiTrial> try_phi(const City& city, const std::vector<DemandDay>& training, const CityModel& model) {
  constexpr std::array<double, 4> tried{0.4, 0.6, 0.8, 1.0};
  const std::size_t days = days_of_phi(city);
  const PlanningSettings settings = under("turnover", model.leads());
  std::vector<TrainingDay> played(tried.size() * days);
  parallel_for(played.size(), [&](std::size_t i) {
    CityModel with_phi = model;
    with_phi.turnover.phi = tried.at(i / days);
    const DemandDay& day = training[(i % days + 1) * training.size() / (days + 1)];
    played[i] = play_training_day(training_world(city, day), with_phi, settings, transition_periods());
  });
  std::vector<PhiTrial> trials;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    PhiTrial& trial = trials.emplace_back(PhiTrial{.phi = tried.at(i)});
    for (std::size_t day = 0; day < days; ++day) {
      trial.lost += played[i * days + day].lost;
      trial.idle_km += played[i * days + day].idle_km;
    }
    trial.cost = trial.idle_km + settings.balancing.p_shortage * trial.lost;
  }
  return trials;
}

Eigen::MatrixXd rounded(const Eigen::MatrixXd& matrix) {
  return (matrix * 1e6).array().round() / 1e6;
}

}  // namespace

CityFit fit_city(const City& city, int leads, const std::function<void(const std::string&)>& tell,
                 const std::vector<Period>& transitions) {
  if (city.train_days.size() < 3) {
    throw bad_input(city.name + " has " + std::to_string(city.train_days.size()) +
                    " training days; three at least are needed");
  }
  const std::vector<DemandDay> training = demand_of(city, city.train_days);
  const std::vector<DemandDay> test = demand_of(city, city.test_days);
  CityFit fit;
  tell("demand: " + std::to_string(training.size()) + " training days on record");
  const SeriesDays demand{pickups(city, training), pickups(city, test)};
  fit.demand = fit_series(demand, city.step_minutes, leads, all_regions(city));
  fit.model = model_of_demand(city, training, leads, fit.demand.model);

  tell("plant: training and test days under greedy");
  const PlanningSettings greedy = under("greedy", leads);
  SeriesDays completions;
  completions.training.resize(training.size());
  completions.test.resize(test.size());
  std::vector<TransitionCounts> periods(transition_periods().size(), TransitionCounts(city.size()));
  std::mutex adding;
  parallel_for(training.size() + test.size(), [&](std::size_t i) {
    const bool trains = i < training.size();
    const DemandDay& day = trains ? training[i] : test[i - training.size()];
    const TrainingDay played = play_training_day(training_world(city, day), fit.model, greedy, transition_periods());
    CountDay& count = trains ? completions.training[i] : completions.test[i - training.size()];
    count = {day_kind(day.date, day.holiday), played.completions};
    if (trains) {
      const std::lock_guard lock(adding);  // whole numbers: the order of adding does not matter
      for (std::size_t period = 0; period < periods.size(); ++period) {
        periods[period] += played.transitions[period];
      }
      fit.served += played.served;
      fit.lost += played.lost;
    }
  });

  tell("completions and transitions of the days played");
  fit.completions = fit_series(completions, city.step_minutes, leads, regions_with_points(city));
  fit.model.completions = fit.completions.model;
  fit.model.periods = transitions.empty() ? periods_of(periods) : transitions;
  fit.model.turnover.demand = fit_count_variance(fit.demand.training, leads);
  fit.model.turnover.same_step_dropoffs = rounded(same_step_dropoffs(city, training, city.step_minutes));
  if (city.size() * city.steps_per_day() <= most_car_values) {
    tell("values of cars: a day of each kind, planned at once");
    parallel_for(fit.model.car_values.size(), [&](std::size_t kind) {
      fit.model.car_values[kind] = car_values(city, fit.model, static_cast<DayKind>(kind));
    });
  }
  tell("turnover on " + std::to_string(days_of_phi(city)) + " of the training days, with several phi");
  fit.phi = try_phi(city, training, fit.model);
  fit.model.turnover.phi = std::ranges::min_element(fit.phi, {}, &PhiTrial::cost)->phi;
  return fit;
}

}  // namespace evbal
