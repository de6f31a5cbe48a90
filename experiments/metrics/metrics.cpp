#include "experiments/metrics/metrics.hpp"

#include "experiments/metrics/columns.hpp"
#include "experiments/metrics/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace evbal {
namespace {

std::vector<RegionStep> count_regions(std::span<const TickRecord> window, int step, std::size_t regions) {
  std::vector<RegionStep> rows(regions);
  for (std::size_t i = 0; i < regions; ++i) {
    rows[i].step = step;
    rows[i].region = static_cast<int>(i);
  }
  for (const auto& record : window) {
    for (const auto& said : record.exchange.departures) {
      auto& row = rows[static_cast<std::size_t>(said.region)];
      row.flows += flows_of(said);
      row.stocks = stocks_of(said);
    }
  }
  return rows;
}

/// By how many the vehicles on the road grew during a tick.
std::int64_t set_off_less_arrived(const TickRecord& record) {
  std::int64_t vehicles = -static_cast<std::int64_t>(record.tick.arrivals.size());
  for (const auto& said : record.exchange.departures) {
    vehicles += static_cast<std::int64_t>(said.departures.size());
  }
  return vehicles;
}

bool fleet_conserved(std::span<const TickRecord> ticks) {
  std::int64_t under_way = 0;
  std::optional<std::int64_t> fleet;
  for (const auto& record : ticks) {
    under_way += set_off_less_arrived(record);
    std::int64_t vehicles = under_way;
    for (const auto& said : record.exchange.departures) {
      vehicles += said.vacant + said.low_battery + said.plugged + said.broken;
    }
    if (vehicles != fleet.value_or(vehicles)) {
      return false;
    }
    fleet = vehicles;
  }
  return true;
}

/// Vehicles per region after the executed dispatch of a tick.
struct Dispatched {
  std::vector<double> supply;
  std::vector<double> low_battery;
};

/// Those who are there when a tick's plan is made. Not as reported, for reports may be wrong, but as they stood when
/// the tick before ended, less those that broke down since, evicted ones in the queue. Nobody has said yet how they
/// stand at the day's start: there the reports must do.
Dispatched before_dispatch(std::span<const TickRecord> ticks, std::size_t at, std::size_t regions) {
  Dispatched there{std::vector<double>(regions), std::vector<double>(regions)};
  if (at == 0) {
    for (const auto& report : ticks[at].exchange.reports) {
      there.supply[static_cast<std::size_t>(report.region)] = report.vacant;
      there.low_battery[static_cast<std::size_t>(report.region)] = report.low_battery;
    }
    return there;
  }
  for (const auto& before : ticks[at - 1].exchange.departures) {
    const auto region = static_cast<std::size_t>(before.region);
    there.supply[region] += before.vacant + before.broken;
    there.low_battery[region] += before.low_battery;
  }
  for (const auto& said : ticks[at].exchange.departures) {
    const auto region = static_cast<std::size_t>(said.region);
    there.supply[region] -= said.broken;
    for (const auto& observed : said.observed) {
      there.low_battery[region] += observed.evicted;
    }
  }
  return there;
}

Dispatched after_dispatch(std::span<const TickRecord> ticks, std::size_t at, std::size_t regions) {
  Dispatched there = before_dispatch(ticks, at, regions);
  for (const auto& said : ticks[at].exchange.departures) {
    there.supply[static_cast<std::size_t>(said.region)] -= said.topped_up;
    there.low_battery[static_cast<std::size_t>(said.region)] += said.topped_up;
    for (const auto& departure : said.departures) {
      if (departure.errand != Errand::passenger) {
        auto& count = departure.errand == Errand::rebalance ? there.supply : there.low_battery;
        count[static_cast<std::size_t>(said.region)] -= 1.0;
        count[static_cast<std::size_t>(departure.to)] += 1.0;
      }
    }
  }
  return there;
}

Unfairness unfairness_after(const Dispatched& there, std::span<const TickRecord> window, std::span<const int> points) {
  std::vector<double> demand(points.size());
  std::vector<double> drop_offs(points.size());
  std::vector<double> completions(points.size());
  for (const auto& record : window) {
    for (const auto& said : record.exchange.departures) {
      demand[static_cast<std::size_t>(said.region)] += said.demand;
      completions[static_cast<std::size_t>(said.region)] += said.completions;
    }
    for (const auto& arrival : record.tick.arrivals) {
      drop_offs[static_cast<std::size_t>(arrival.region)] += arrival.errand == Errand::passenger ? 1.0 : 0.0;
    }
  }
  return unfairness({demand, there.supply, drop_offs, completions, there.low_battery, points});
}

/// Fills what the step's plans left behind: the unfairness of the city and the supply of each region.
void judge_plans(const MetricsFrame& frame, std::span<const TickRecord> ticks, CityStep& city,
                 std::span<RegionStep> regions) {
  const auto per_step = static_cast<std::size_t>(frame.clock.step / frame.clock.tick);
  const std::size_t first = static_cast<std::size_t>(city.step) * per_step;
  int plans = 0;
  int judged = 0;
  for (std::size_t at = first; at < first + per_step; ++at) {
    if (!ticks[at].tick.plan_due) {
      continue;
    }
    const Dispatched there = after_dispatch(ticks, at, regions.size());
    ++plans;
    for (std::size_t i = 0; i < regions.size(); ++i) {
      regions[i].supply += there.supply[i];
      regions[i].low_battery_present += there.low_battery[i];
    }
    if (at + per_step <= ticks.size()) {
      city.unfairness += unfairness_after(there, ticks.subspan(at, per_step), frame.points);
      ++judged;
    }
  }
  city.unfairness = city.unfairness / std::max(judged, 1);
  for (auto& region : regions) {
    region.supply /= std::max(plans, 1);
    region.low_battery_present /= std::max(plans, 1);
  }
}

double share_lost(const Flows& flows) {
  const std::int64_t settled = flows.served + flows.lost;
  return settled > 0 ? static_cast<double>(flows.lost) / static_cast<double>(settled) : 0.0;
}

double p90_regional_loss(std::span<const RegionStep> rows, std::size_t regions) {
  std::vector<Flows> by_region(regions);
  for (const auto& row : rows) {
    by_region[static_cast<std::size_t>(row.region)] += row.flows;
  }
  std::vector<double> losses;
  for (const auto& flows : by_region) {
    if (flows.served + flows.lost > 0) {
      losses.push_back(share_lost(flows));
    }
  }
  return quantile(std::move(losses), 0.9);
}

Totals totals_of(const MetricsFrame& frame, const DayMetrics& day) {
  Totals totals;
  for (const auto& step : day.steps) {
    totals.flows += step.flows;
    totals.unfairness += step.unfairness;
    totals.idle_km += step.idle_km;
  }
  const auto per = [](auto amount, std::int64_t count) {
    return static_cast<double>(amount) / static_cast<double>(std::max<std::int64_t>(count, 1));
  };
  const Flows& flows = totals.flows;
  totals.unserved_ratio = share_lost(flows);
  totals.p90_regional_loss = p90_regional_loss(day.regions, frame.points.size());
  totals.passenger_wait_min = per(flows.wait_minutes, flows.served);
  totals.charger_wait_min = static_cast<double>(flows.queue_minutes);
  totals.charger_wait_min_per_session = per(flows.queue_minutes, flows.completions);
  totals.idle_km_per_served = per(totals.idle_km, flows.served);
  return totals;
}

}  // namespace

Flows flows_of(const Departures& said) {
  Flows flows{.demand = said.demand,
              .completions = said.completions,
              .queue_minutes = said.queue_minutes,
              .stranded = said.stranded,
              .refused = said.refused,
              .top_ups = said.topped_up,
              .charged_kwh = said.charged_kwh};
  for (const auto& fate : said.fates) {
    ++(fate.served ? flows.served : flows.lost);
    flows.wait_minutes += fate.served ? fate.waited : 0;
  }
  for (const auto& departure : said.departures) {
    switch (departure.errand) {
      case Errand::passenger:
        flows.passenger_km += departure.km;
        break;
      case Errand::rebalance:
        flows.rebalance_km += departure.km;
        ++flows.rebalance_moves;
        break;
      case Errand::charge:
        flows.charge_km += departure.km;
        ++flows.charge_moves;
        break;
    }
  }
  return flows;
}

Stocks stocks_of(const Departures& said) {
  return {.vacant = said.vacant,
          .low_battery = said.low_battery,
          .plugged = said.plugged,
          .points = said.points,
          .waiting = said.waiting,
          .broken = said.broken};
}

Flows& Flows::operator+=(const Flows& other) {
  demand += other.demand;
  served += other.served;
  lost += other.lost;
  wait_minutes += other.wait_minutes;
  completions += other.completions;
  queue_minutes += other.queue_minutes;
  stranded += other.stranded;
  refused += other.refused;
  rebalance_moves += other.rebalance_moves;
  charge_moves += other.charge_moves;
  top_ups += other.top_ups;
  rebalance_km += other.rebalance_km;
  charge_km += other.charge_km;
  passenger_km += other.passenger_km;
  charged_kwh += other.charged_kwh;
  return *this;
}

Stocks& Stocks::operator+=(const Stocks& other) {
  vacant += other.vacant;
  low_battery += other.low_battery;
  plugged += other.plugged;
  points += other.points;
  waiting += other.waiting;
  broken += other.broken;
  return *this;
}

DayMetrics measure(const MetricsFrame& frame, std::span<const TickRecord> ticks) {
  DayMetrics day;
  const std::size_t regions = frame.points.size();
  const auto per_step = static_cast<std::size_t>(frame.clock.step / frame.clock.tick);
  std::int64_t under_way = 0;
  for (std::size_t at = 0; at + per_step <= ticks.size(); at += per_step) {
    const auto window = ticks.subspan(at, per_step);
    std::vector<RegionStep> rows = count_regions(window, static_cast<int>(at / per_step), regions);
    CityStep city{.step = static_cast<int>(at / per_step)};
    for (const auto& row : rows) {
      city.flows += row.flows;
      city.stocks += row.stocks;
    }
    for (const auto& record : window) {
      under_way += set_off_less_arrived(record);
    }
    city.under_way = under_way;
    city.idle_km = city.flows.rebalance_km + frame.beta * city.flows.charge_km;
    judge_plans(frame, ticks, city, rows);
    day.steps.push_back(city);
    day.regions.insert(day.regions.end(), rows.begin(), rows.end());
  }
  day.totals = totals_of(frame, day);
  day.totals.detection = detection(frame.clock, ticks);
  day.fleet_conserved = fleet_conserved(ticks);
  return day;
}

std::vector<std::pair<std::string, double>> named(const Totals& totals) {
  std::vector<std::pair<std::string, double>> values;
  columns([&](const char* name, auto value) { values.emplace_back(name, static_cast<double>(value)); }, totals);
  return values;
}

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  columns([&](const char* name, auto) { names.emplace_back(name); }, Totals{});
  return names;
}

}  // namespace evbal
