#pragma once

#include "agents/protocol/tick_record.hpp"
#include "common/clock.hpp"
#include "experiments/metrics/detection.hpp"
#include "experiments/metrics/fairness.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// What a day came to: pure functions of what was said in its ticks (docs/metrics.md).
/// Only executed moves count: the departures that agents reported, not the plans.
namespace evbal {

/// What the metrics must know beside the ticks.
struct MetricsFrame {
  DayClock clock;           ///< of the run
  std::vector<int> points;  ///< installed charging points of each region
  double beta = 1.0;        ///< price of a low-battery vehicle's km against a vacant one's, as the controllers have it
};

/// Adds up over time and over regions.
struct Flows {
  std::int64_t demand = 0;           ///< passengers who appeared
  std::int64_t served = 0;           ///< in the step in which they were picked up
  std::int64_t lost = 0;             ///< in the step in which their patience ended
  std::int64_t wait_minutes = 0;     ///< that the served passengers waited
  std::int64_t completions = 0;      ///< charging sessions that ended charged
  std::int64_t queue_minutes = 0;    ///< vehicle-minutes that low-battery vehicles waited where there is a station
  std::int64_t stranded = 0;         ///< vehicles that arrived with an empty battery
  std::int64_t refused = 0;          ///< vehicles that plans asked for and regions did not have
  std::int64_t rebalance_moves = 0;  ///< vacant vehicles that plans sent off
  std::int64_t charge_moves = 0;     ///< low-battery vehicles that plans sent off
  std::int64_t top_ups = 0;          ///< vacant vehicles that plans had charge where they stood
  double rebalance_km = 0.0;         ///< of moves that set off, counted in the region they left
  double charge_km = 0.0;            ///< likewise, to chargers
  double passenger_km = 0.0;         ///< with passengers
  double charged_kwh = 0.0;          ///< into all vehicles

  /// Adds another, number by number.
  Flows& operator+=(const Flows& other);
};

/// How things stand at a step's end; adds up over regions.
struct Stocks {
  std::int64_t vacant = 0;       ///< vehicles
  std::int64_t low_battery = 0;  ///< vehicles that wait for a charger
  std::int64_t plugged = 0;      ///< vehicles at charging points
  std::int64_t points = 0;       ///< working
  std::int64_t waiting = 0;      ///< passengers
  std::int64_t broken = 0;       ///< vehicles that cannot be used

  /// Adds another, number by number.
  Stocks& operator+=(const Stocks& other);
};

/// What a region's tick adds to its flows.
Flows flows_of(const Departures& said);

/// How a region stands at its tick's end.
Stocks stocks_of(const Departures& said);

/// A row of regions.csv.
struct RegionStep {
  int step = 0;                      ///< from 0
  int region = 0;                    ///< from 0
  Flows flows{};                     ///< of the step
  Stocks stocks{};                   ///< at its end
  double supply = 0.0;               ///< S: vacant vehicles after the executed dispatch, mean over the step's plans
  double low_battery_present = 0.0;  ///< Y: low-battery vehicles likewise
};

/// A row of steps.csv.
struct CityStep {
  int step = 0;                ///< from 0
  Flows flows{};               ///< of all regions
  Stocks stocks{};             ///< of all regions
  std::int64_t under_way = 0;  ///< vehicles on the road at the step's end
  double idle_km = 0.0;        ///< J_D: rebalance_km + beta charge_km
  Unfairness unfairness{};     ///< mean over the step's plans
};

/// What a day comes to.
struct Totals {
  Flows flows{};  ///< of the day
  /// J_D of the day.
  double idle_km = 0.0;
  Unfairness unfairness{};          ///< sum over the steps
  double unserved_ratio = 0.0;      ///< lost / (served + lost)
  double p90_regional_loss = 0.0;   ///< 90th percentile of lost / (served + lost) over regions with passengers
  double passenger_wait_min = 0.0;  ///< mean of the served passengers
  double charger_wait_min = 0.0;    ///< vehicle-minutes in all
  double charger_wait_min_per_session = 0.0;  ///< over completed sessions
  double idle_km_per_served = 0.0;            ///< km a served passenger
  Detection detection{};                      ///< of sensors that lie
};

/// A day, step by step and in all.
struct DayMetrics {
  std::vector<CityStep> steps;      ///< by step
  std::vector<RegionStep> regions;  ///< by (step, region)
  Totals totals;                    ///< of the day
  bool fleet_conserved = true;      ///< vehicles in regions and on the road add up to the same number after every tick
};

/// Measures the whole steps among `ticks`, which start at tick 0 and leave none out.
///
/// Unfairness is taken for every plan: S_i and Y_i are the vacant and low-battery vehicles in region i before it (as
/// they really are, whatever was reported) plus the vehicles that moves of that tick bring minus those that they take
/// away; those that top up count as low-battery; demand and completions are those of the following step length (a
/// window that would reach past the last tick is left out). A step takes the mean over its plans, a day the sum over
/// its steps, so that `plan_every` does not change the scale.
DayMetrics measure(const MetricsFrame& frame, std::span<const TickRecord> ticks);

/// The totals by the names that summary.json and a scenario's `expect` use.
std::vector<std::pair<std::string, double>> named(const Totals& totals);

/// The names that `named` gives.
std::vector<std::string> metric_names();

}  // namespace evbal
