#include "experiments/record/summary.hpp"

#include "common/digest.hpp"
#include "common/version.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <set>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

double median(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

Json totals_json(const Totals& totals) {
  Json json;
  for (const auto& [name, value] : named(totals)) {
    const auto whole = static_cast<std::int64_t>(value);
    json[name] = static_cast<double>(whole) == value ? Json(whole) : Json(value);
  }
  return json;
}

Json solver_json(const RunHeader& header, const RunResult& result, std::span<const TickRecord> ticks) {
  std::vector<double> seconds;
  std::int64_t iterations = 0;
  double violation = 0.0;
  double gap = 0.0;
  for (const auto& record : ticks) {
    const auto& plan = record.exchange.plan;
    if (plan && !plan->provenance.engine.empty()) {
      seconds.push_back(plan->origin.seconds);
      iterations += plan->provenance.iterations;
      violation = std::max(violation, plan->provenance.max_violation);
      gap = std::max(gap, plan->provenance.gap);
    }
  }
  double total = 0.0;
  for (const double value : seconds) {
    total += value;
  }
  Json json = {{"engine", header.engine},  {"solves", seconds.size()},          {"fallbacks", result.fallbacks},
               {"iterations", iterations}, {"max_violation", violation},        {"max_gap", gap},
               {"seconds", total},         {"seconds_median", median(seconds)}, {"seconds_max", largest(seconds)}};
  if (const auto& check = result.cross_check) {
    json["cross_check"] = {{"engine", check->engine},
                           {"plans", check->plans},
                           {"unsolved", check->unsolved},
                           {"max_relative_difference", check->difference}};
  }
  return json;
}

Json processes_json(std::span<const TickRecord> ticks) {
  std::set<std::int64_t> agents;
  std::set<std::int64_t> coordinator;
  std::set<std::int64_t> faults;
  std::int64_t restarts = 0;
  for (const auto& record : ticks) {
    faults.insert(record.faults.origin.process_id);
    if (record.exchange.plan) {
      coordinator.insert(record.exchange.plan->origin.process_id);
    }
    for (const auto& said : record.exchange.departures) {
      agents.insert(said.origin.process_id);
    }
    restarts += std::count_if(record.exchange.incidents.begin(), record.exchange.incidents.end(),
                              [](const Incident& incident) { return incident.kind == "process ended"; });
  }
  for (auto* writers : {&agents, &coordinator, &faults}) {
    writers->erase(0);
    writers->erase(getpid());
  }
  return {{"agents", agents.size()},
          {"coordinator", coordinator.size()},
          {"faults", faults.size()},
          {"restarts", restarts}};
}

Json step_seconds_json(const DayClock& clock, std::span<const TickRecord> ticks, std::span<const double> tick_seconds) {
  const auto per_step = static_cast<std::size_t>(clock.step / clock.tick);
  std::vector<double> whole(ticks.size() / per_step);
  std::vector<double> without_solver(whole.size());
  for (std::size_t at = 0; at < whole.size() * per_step; ++at) {
    const auto& plan = ticks[at].exchange.plan;
    whole[at / per_step] += tick_seconds[at];
    without_solver[at / per_step] += tick_seconds[at] - (plan ? plan->origin.seconds : 0.0);
  }
  return {{"median", median(whole)}, {"max", largest(whole)}, {"median_without_solver", median(without_solver)}};
}

/// What packets suffered, and what it cost to exchange a tick's messages: seconds of the tick but the solver's. In the
/// first tick processes are still being started.
Json network_json(const NetworkConditions& network, std::span<const TickRecord> ticks,
                  std::span<const double> tick_seconds) {
  std::vector<double> exchange;
  for (std::size_t at = 1; at < ticks.size(); ++at) {
    const auto& plan = ticks[at].exchange.plan;
    exchange.push_back(tick_seconds[at] - (plan ? plan->origin.seconds : 0.0));
  }
  if (exchange.empty()) {
    exchange.push_back(0.0);
  }
  std::sort(exchange.begin(), exchange.end());
  const std::size_t late = exchange.size() - 1 - exchange.size() / 100;  // one in a hundred is later
  return {{"loss", network.loss},
          {"delay_ms", network.delay_ms},
          {"deterministic_in_time", false},
          {"exchange_seconds", {{"median", median(exchange)}, {"p99", exchange[late]}, {"max", exchange.back()}}}};
}

/// By process, in the order of `timings`, all agents as one.
Json timings_json(const std::vector<ProcessLegs>& timings) {
  std::map<std::string, std::map<std::string, Leg>> sums;
  std::vector<std::string> order;
  for (const auto& [process, legs] : timings) {
    const std::string name = process.starts_with("agent-") ? "agents" : process;
    if (!legs.empty() && !sums.contains(name)) {
      order.push_back(name);
    }
    for (const Leg& leg : legs) {
      Leg& sum = sums[name][leg.name];
      sum.times += leg.times;
      sum.seconds += leg.seconds;
      sum.longest = std::max(sum.longest, leg.longest);
    }
  }
  Json json = Json::object();
  for (const auto& process : order) {
    for (const auto& [name, leg] : sums[process]) {
      json[process][name] = {{"times", leg.times},
                             {"seconds", leg.seconds},
                             {"mean_ms", 1000.0 * leg.seconds / static_cast<double>(leg.times)},
                             {"longest_ms", 1000.0 * leg.longest}};
    }
  }
  return json;
}

std::int64_t fleet_of(const DayMetrics& day) {
  if (day.steps.empty()) {
    return 0;
  }
  const CityStep& last = day.steps.back();
  return last.stocks.vacant + last.stocks.low_battery + last.stocks.plugged + last.stocks.broken + last.under_way;
}

}  // namespace

std::string summary_json(const RunHeader& header, const DayMetrics& day, const RunResult& result,
                         std::span<const TickRecord> ticks, std::span<const double> tick_seconds,
                         const std::vector<ProcessLegs>& timings) {
  Json json = {{"scenario", header.scenario},
               {"date", header.date},
               {"seed", header.seed},
               {"controller", header.controller},
               {"transport", header.transport},
               {"digest", result.digest},
               {"scenario_digest", text_digest(header.resolved)},
               {"pack_digest", header.inputs.pack},
               {"model_digest", header.inputs.model},
               {"program", this_program()},
               {"day_start", time_of_day(header.frame.clock, 0)},
               {"steps", day.steps.size()},
               {"step_minutes", header.frame.clock.step},
               {"regions", header.region_names.size()},
               {"fleet", fleet_of(day)},
               {"fleet_conserved", day.fleet_conserved},
               {"totals", totals_json(day.totals)},
               {"solver", solver_json(header, result, ticks)},
               {"processes", processes_json(ticks)},
               {"step_seconds", step_seconds_json(header.frame.clock, ticks, tick_seconds)},
               {"wall_seconds", result.wall_seconds},
               {"timings", timings_json(timings)}};
  if (header.network) {
    json["network"] = network_json(*header.network, ticks, tick_seconds);
  }
  if (!header.inputs.coordinator.empty()) {
    json["coordinator_digest"] = header.inputs.coordinator;
  }
  if (header.security) {
    json["security"] = "on";
  }
  if (!header.dds_profiles.empty()) {
    json["dds_profiles"] = header.dds_profiles.string();
  }
  return json.dump(2) + "\n";
}

int count_fallbacks(std::span<const TickRecord> ticks) {
  return static_cast<int>(std::count_if(ticks.begin(), ticks.end(), [](const TickRecord& record) {
    return record.exchange.plan && record.exchange.plan->provenance.fallback != FallbackLevel::none;
  }));
}

}  // namespace evbal
