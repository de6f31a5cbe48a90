#pragma once

#include "coordinator/filter/evidence.hpp"
#include "coordinator/filter/stock_filter.hpp"

#include <optional>

namespace evbal {

/// A region at a plan, as far as it is known: cars, and passengers who wait.
struct RegionCounts {
  double vacant = 0.0;       ///< cars
  double low_battery = 0.0;  ///< cars that wait for a charger
  double plugged = 0.0;      ///< cars
  double waiting = 0.0;      ///< passengers
};

/// Its stocks, with so many occupied cars due.
StockVector stock_of(const RegionCounts& counts, int occupied_due);

/// What is known to have happened in a region between two plans.
struct RegionWindow {
  double came_vacant = 0.0;     ///< cars that came with a passenger, or empty to serve
  double came_low = 0.0;        ///< cars that came to charge
  double left_vacant = 0.0;     ///< cars that were sent off to serve elsewhere, or broke down
  double left_low = 0.0;        ///< cars that were sent off to charge
  double topped_up = 0.0;       ///< vacant cars that were told to queue
  double ended = 0.0;           ///< charging sessions
  double ended_variance = 0.0;  ///< 0 if they were counted
  double begun = 0.0;           ///< charging sessions
  double begun_variance = 0.0;  ///< 0 if they were counted
  double dropped_off = 0.0;     ///< cars that are expected to have come on trips that began since the last plan
  double low_share = 0.0;       ///< of the cars that come free, those that come out low
  double may_give_up = 0.0;     ///< share of those who appear whose patience may end in the same window
  int slack = 0;                ///< vehicles of which nobody knows whether they broke down
};

/// Passengers who were picked up, and what is not known of them.
struct PickUps {
  double expected = 0.0;  ///< passengers
  double variance = 0.0;  ///< of their number
};

/// Cars that come free in a window, each of which may be low.
double come_free(const RegionWindow& window);

/// Those who are expected to have given up of those who waited.
double given_up(const RegionCounts& before, const RegionWindow& window);

/// What comes and goes in a window in which so many were picked up; the occupied cars due are left out.
struct StockChange {
  StockVector change = StockVector::Zero();  ///< cars that come less cars that go
  StockMatrix noise = StockMatrix::Zero();   ///< covariance of what is not known of it
};
/// See StockChange. Uncertain are pick-ups, drop-offs of short trips, who of the cars that come free is low, and
/// sessions that were not counted; each is an independent count whose variance grows with its mean.
StockChange stock_change(const RegionWindow& window, const PickUps& picked_up);

/// How much likelier it is, as a logarithm, that demand is wrong by an excess than that cars are, if so many passengers
/// are said to have appeared and the forecast has this mean and variance: by the passengers who then really appeared.
/// And by what cars would be off in all with this excess: wrong passengers add up, while wrong cars come back.
double favours_passengers(const Excess& excess, double off, double demand, double forecast, double variance);

/// Cars too many by a report of vacant and low-battery cars, of passengers who wait and who appeared.
Excess excess_of(const RegionCounts& before, const RegionWindow& window, const RegionCounts& reported, double demand);

}  // namespace evbal
