#include "coordinator/filter/balance.hpp"

#include "coordinator/filter/count_law.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

// Of those for whom no car came in time, and of the others who waited; on training days.
constexpr double give_up_without_a_car = 0.75;
constexpr double give_up_before_a_car = 0.1;
constexpr double likeness = 0.01;     ///< correlation between two cars' coming out low, on training days
constexpr double least_noise = 0.01;  ///< variance of what no count tells, such as a car that was not sent off

/// Of how many come out low of the cars that come free: those of a place and hour are alike.
double variance_of_low(const RegionWindow& window) {
  const double free = come_free(window);
  return free * window.low_share * (1.0 - window.low_share) * (1.0 + likeness * std::max(0.0, free - 1.0));
}

constexpr double usual_surprise = 3.0;   ///< up to which an excess says nothing of who is wrong
constexpr double most_in_favour = 3.0;   ///< by one report
constexpr double of_the_forecast = 0.3;  ///< deviation of the forecast's own error, of its mean

}  // namespace

StockVector stock_of(const RegionCounts& counts, int occupied_due) {
  return {counts.vacant, static_cast<double>(occupied_due), counts.low_battery, counts.plugged};
}

double come_free(const RegionWindow& window) {
  return window.came_vacant + window.ended + window.dropped_off;
}

double given_up(const RegionCounts& before, const RegionWindow& window) {
  const double without = std::max(0.0, before.waiting - before.vacant - come_free(window));
  return give_up_without_a_car * without + give_up_before_a_car * (before.waiting - without);
}

StockChange stock_change(const RegionWindow& window, const PickUps& picked_up) {
  const double free = come_free(window);
  const double low = window.low_share * free;
  const double which = variance_of_low(window);
  const double began = window.begun_variance;
  const double ended = window.ended_variance;
  StockChange out;
  out.change << free - low - window.left_vacant - window.topped_up - picked_up.expected, 0.0,
      window.came_low + low + window.topped_up - window.left_low - window.begun, window.begun - window.ended;
  const double vacant = picked_up.variance + window.dropped_off + window.slack + which + ended + least_noise;
  out.noise << vacant, 0.0, -which, -ended,  //
      0.0, least_noise, 0.0, 0.0,            //
      -which, 0.0, which + began + least_noise, -began, -ended, 0.0, -began, began + ended + least_noise;
  return out;
}

double favours_passengers(const Excess& excess, double off, double demand, double forecast, double variance) {
  if (surprise(excess.cars, excess.expected, excess.slack) < usual_surprise) {
    return 0.0;
  }
  const double appeared = demand - excess.cars + excess.expected + (excess.cars > 0 ? excess.slack : 0);
  const double error = of_the_forecast * forecast;
  const double spread = 2.0 * (variance + error * error + 1.0);
  const double said = (demand - forecast) * (demand - forecast) / spread;
  const double implied = (appeared - forecast) * (appeared - forecast) / spread;
  const double by_forecast =
      appeared < -1.0 ? -most_in_favour : std::clamp(said - implied, -most_in_favour, most_in_favour);
  const double jump = excess.cars - excess.expected;
  return by_forecast + 0.5 * std::log((off * off + 1.0) / (jump * jump + 1.0));
}

Excess excess_of(const RegionCounts& before, const RegionWindow& window, const RegionCounts& reported, double demand) {
  const double picked_up = before.waiting + demand - reported.waiting;
  const double cars = before.vacant + before.low_battery + window.came_vacant + window.came_low + window.ended -
                      window.begun - window.left_vacant - window.left_low - picked_up;
  const double low = before.low_battery + window.came_low + window.topped_up - window.left_low - window.begun;
  const double lost = given_up(before, window);
  Excess excess;
  excess.cars = static_cast<int>(std::lround(reported.vacant + reported.low_battery - cars));
  excess.low = static_cast<int>(std::lround(reported.low_battery - low));
  excess.expected = window.dropped_off + lost;
  excess.variance_low = variance_of_low(window);
  excess.expected_low = window.low_share * come_free(window);
  excess.variance = window.dropped_off + lost + window.slack;
  excess.contradiction = reported.vacant > 0.0 && reported.waiting > 0.0;
  const double early = reported.vacant > 0.0 ? 0.0 : std::ceil(window.may_give_up * demand);
  excess.slack = window.slack + static_cast<int>(std::lround(before.waiting + early));
  return excess;
}

}  // namespace evbal
