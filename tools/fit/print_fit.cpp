#include "tools/fit/print_fit.hpp"

#include "tools/fit/trip_shares.hpp"
#include "tools/fit/turnover_fit.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace evbal {
namespace {

double percent(double part, double whole) {
  return whole > 0.0 ? 100.0 * part / whole : 0.0;
}

/// Error left of the seasonal mean's and the last value's, at each lead.
void print_skill(const char* series, const char* days, const std::vector<HeldOutDay>& held_out) {
  if (held_out.empty()) {
    return;
  }
  const Skill skill = skill_of(held_out);
  const auto worse = (skill.forecast.rowwise().sum().array() > skill.seasonal_mean.rowwise().sum().array()).count();
  std::printf("%-12s %-22s", series, days);
  for (const auto* rival : {&skill.seasonal_mean, &skill.last_value}) {
    std::printf("  ");
    for (Eigen::Index lead = 0; lead < skill.forecast.cols(); ++lead) {
      std::printf(" %6.1f", percent(skill.forecast.col(lead).sum(), rival->col(lead).sum()));
    }
  }
  std::printf("   %td of %td\n", worse, skill.forecast.rows());
}

void print_region(const SeriesFit& fit, std::size_t region) {
  const ArmaOrder& order = fit.orders.region[region];
  const auto i = static_cast<int>(region);
  const bool thin = is_thin(fit.orders, i);
  if (thin) {
    std::printf("   %-8s", "mean");
  } else {
    std::printf("   (%d,%d) ", order.p, order.q);
  }
  for (const auto* days : {&fit.training, &fit.test}) {
    if (thin || days->empty()) {
      std::printf(" %6s %6s", "-", "-");
      continue;
    }
    const Skill skill = skill_of(*days);
    std::printf(" %6.1f %6.1f", percent(skill.forecast(i, 0), skill.seasonal_mean(i, 0)),
                percent(skill.forecast(i, 0), skill.last_value(i, 0)));
  }
}

void print_skills(const City& city, const CityFit& fit) {
  const std::array<std::pair<const char*, const SeriesFit*>, 2> series{
      {{"demand", &fit.demand}, {"completions", &fit.completions}}};
  std::printf("\nsquared forecast error by steps ahead, in %% of the seasonal mean's and of the last value's; regions");
  std::printf(" worse than their seasonal mean\n");
  for (const auto& [name, of] : series) {
    print_skill(name, "training, left out", of->training);
    print_skill(name, "test", of->test);
  }
  for (const auto& [name, of] : series) {
    std::printf("%s of the city: order (%d,%d); %zu regions are too thin and keep their seasonal mean\n", name,
                of->orders.city.p, of->orders.city.q, of->orders.thin.size());
  }
  std::printf(
      "\none step ahead, by region: order; training and test, each in %% of the seasonal mean's and of the last");
  std::printf(" value's\n%-12s   %-36s   %s\n", "", "demand", "completions");
  for (std::size_t region = 0; region < city.regions.size(); ++region) {
    std::printf("%-12s", city.regions[region].name.c_str());
    for (const auto& [name, of] : series) {
      print_region(*of, region);
    }
    std::printf("\n");
  }
}

struct PaperRow {
  double g1 = 0.0;
  double g2 = 0.0;
};
constexpr std::array<PaperRow, 6> paper{
    {{1.504, 3.715}, {.964, 2.832}, {.576, 2.006}, {.399, 1.768}, {.296, 1.374}, {.176, 1.317}}};

void print_thresholds(const char* series, const SeriesFit& fit) {
  if (fit.thresholds.empty()) {
    return;
  }
  std::printf("\nthresholds of %s; held-out coverage of 1000 draws from the test days, 75 %% promised\n", series);
  std::printf("%6s  %18s  %8s  %18s  %22s  %14s\n", "N_B", "g1", "sqrt g1", "g2", "covered, %: g1 g2 both",
              "paper: g1 g2");
  for (std::size_t row = 0; row < fit.thresholds.size(); ++row) {
    const auto& [resample, thresholds, test] = fit.thresholds[row];
    const auto& [value, error] = thresholds;
    std::printf("%6d  %8.4f +- %6.4f  %8.4f  %8.4f +- %6.4f  ", resample, value.g1, error.g1, std::sqrt(value.g1),
                value.g2, error.g2);
    if (test) {
      std::printf("%10.1f %5.1f %5.1f", 100.0 * test->g1, 100.0 * test->g2, 100.0 * test->both);
    } else {
      std::printf("%22s", "");
    }
    std::printf("  %8.3f %5.3f\n", paper.at(row).g1, paper.at(row).g2);
  }
}

/// Of the innovation test: its alarm, and how many regions a day exceed it.
void print_alarm(const char* series, const SeriesFit& fit) {
  std::printf("%-12s alarm %6.2f, exceeded in", series, fit.model.errors.alarm);
  const std::array<std::pair<const char*, const std::vector<HeldOutDay>*>, 2> both{
      {{"training", &fit.training}, {"test", &fit.test}}};
  for (const auto& [name, days] : both) {
    std::printf(" %.1f regions a %s day", alarms_a_day(fit.model, *days), name);
  }
  std::printf("\n");
}

void print_turnover(const CityFit& fit) {
  const Turnover& turnover = fit.model.turnover;
  std::printf("\nturnover on training days; taken: phi %.1f\n", turnover.phi);
  for (const PhiTrial& trial : fit.phi) {
    std::printf("phi %.1f: %d lost, %.0f idle km, cost %.0f\n", trial.phi, trial.lost, trial.idle_km, trial.cost);
  }
  const auto leads = static_cast<int>(turnover.demand.linear.size());
  for (int lead = 0; lead < leads; ++lead) {
    const auto k = static_cast<std::size_t>(lead);
    std::printf("variance of demand around its forecast m, step %d: %.3f m + %.4f m^2\n", lead + 1,
                turnover.demand.linear[k], turnover.demand.quadratic[k]);
  }
  std::printf("its probability integral transform, %% in each tenth (10 if the distribution is right)\n");
  const std::array<std::pair<const char*, const std::vector<HeldOutDay>*>, 2> both{
      {{"training", &fit.demand.training}, {"test", &fit.demand.test}}};
  for (const auto& [name, days] : both) {
    const Eigen::MatrixXd shares = integral_transform(*days, turnover.demand, leads);
    for (int lead = 0; lead < leads && !days->empty(); ++lead) {
      std::printf("%-9s step %d ", name, lead + 1);
      for (const double share : shares.col(lead)) {
        std::printf(" %5.1f", 100.0 * share);
      }
      std::printf("\n");
    }
  }
}

/// How many pairs of regions a period's trips have, and how many trips stay in their region.
void print_trips(const CityModel& model) {
  std::printf("\nwhere trips go, by period from\n");
  for (const TripPeriod& period : model.trips) {
    std::printf("%02d:%02d  %zu pairs of regions; %.1f %% of a region's trips end in it, on average\n",
                period.start / 60, period.start % 60, period.shares.size(),
                100.0 * share_within(period, model.regions()));
  }
}

}  // namespace

void print_fit(const City& city, const CityFit& fit) {
  std::printf("greedy on the training days: %d served, %d lost (%.1f %%)\n", fit.served, fit.lost,
              percent(fit.lost, fit.served + fit.lost));
  print_skills(city, fit);
  print_thresholds("demand", fit.demand);
  print_thresholds("completions", fit.completions);
  std::printf("\ninnovation test: mean square of the innovations of three steps, of a region or of the city\n");
  print_alarm("demand", fit.demand);
  print_alarm("completions", fit.completions);
  print_turnover(fit);
  print_trips(fit.model);
}

}  // namespace evbal
