#include "tools/report/runs_json.hpp"

#include "experiments/record/paired_run.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

/// The controller's name, with the directory's where two runs have the same.
std::vector<std::string> labels_of(const std::vector<ReportedRun>& runs) {
  std::vector<std::string> labels;
  for (const auto& run : runs) {
    const auto alike =
        std::count_if(runs.begin(), runs.end(), [&](const auto& other) { return other.controller == run.controller; });
    const auto folder = run.folder.has_filename() ? run.folder.filename() : run.folder.parent_path().filename();
    labels.push_back(alike == 1 ? run.controller : run.controller + " (" + folder.string() + ")");
  }
  return labels;
}

/// Step by step the regions' values, to the hundredth.
Json by_region_json(const RecordedRun& run) {
  Json columns;
  for (const char* name : {"supply", "demand", "lost", "queue_minutes"}) {
    Json& values = columns[name];
    for (const double value : run.by_region.at(name).reshaped()) {
      values.push_back(std::round(100.0 * value) / 100.0);
    }
  }
  return columns;
}

/// What the page shows of a fault: requested, said, seen; and step by step the regions on which it acted.
Json fault_json(const RecordedRun& run, const RecordedFault& fault) {
  const int steps = static_cast<int>(run.steps.at("step").size());
  const int ticks_per_step = std::max(1, run.ticks / std::max(1, steps));
  const int minutes_per_tick = run.step_minutes / ticks_per_step;
  std::set<int> regions;
  std::set<std::array<int, 2>> acts;
  for (const auto& [tick, of_tick] : fault.said) {
    for (const int region : of_tick) {
      if (region != no_region) {
        regions.insert(region);
        acts.insert({tick / ticks_per_step, region});
      }
    }
  }
  double total = 0.0;
  double largest = 0.0;
  for (const auto& [tick, amount] : fault.amount) {
    total += amount;
    largest = std::max(largest, amount, [](double a, double b) { return std::abs(a) < std::abs(b); });
  }
  Json json = {{"name", fault.name}, {"type", fault.type}, {"start", fault.start}, {"end", fault.end}};
  json["regions"] = regions;
  json["acts"] = acts;
  json["said_minutes"] = static_cast<int>(fault.said.size()) * minutes_per_tick;
  json["seen_minutes"] = static_cast<int>(fault.amount.size()) * minutes_per_tick;
  json["seen_regions"] = fault.seen_regions.size();
  json["amount"] = {{"largest", largest}, {"total", total}};
  json["evicted"] = fault.evicted;
  if (!fault.amount.empty()) {
    json["seen"] = {fault.amount.begin()->first * minutes_per_tick,
                    (fault.amount.rbegin()->first + 1) * minutes_per_tick};
  }
  return json;
}

Json minutes_json(const std::optional<int>& minutes) {
  return minutes ? Json(*minutes) : Json(nullptr);
}

/// A flagged field: [minute, reported, estimate, truth] of each report.
Json sensor_json(const RecordedRun& run, const RecordedSensor& sensor) {
  const int minutes_per_tick =
      run.step_minutes * static_cast<int>(run.steps.at("step").size()) / std::max(1, run.ticks);
  Json json = {{"region", sensor.region}, {"field", sensor.field}, {"kinds", sensor.kinds}};
  json["readings"] = Json::array();
  for (const SensorReading& reading : sensor.readings) {
    json["readings"].push_back({reading.tick * minutes_per_tick, reading.reported,
                                reading.estimate ? Json(*reading.estimate) : Json(nullptr),
                                reading.truth ? Json(*reading.truth) : Json(nullptr)});
  }
  return json;
}

/// What the faults cost, metric by metric.
Json costs_json(const RecordedRun& run, const RecordedRun& twin) {
  Json costs = Json::array();
  for (const auto& [metric, cost] : costs_of(run, twin)) {
    Json json = {{"metric", metric},         {"with", cost.with}, {"without", cost.without},
                 {"cost", cost.cost()},      {"area", cost.area}, {"recovered", minutes_json(cost.recovered)},
                 {"by_fault", Json::array()}};
    for (const auto& minutes : cost.by_fault) {
      json["by_fault"].push_back(minutes_json(minutes));
    }
    costs.push_back(json);
  }
  return costs;
}

/// The bound, and what it says of a run that drove so many km without passengers.
Json bound_json(const DayBound& bound, double km) {
  const auto pair = [](const Driving& driving) { return Json{driving.km, driving.lost}; };
  Json json = {{"km", km}, {"lost", fewest_lost(bound, km)}, {"down", Json::array()}, {"up", Json::array()}};
  for (const Driving& corner : bound_corners(bound)) {
    json["down"].push_back(pair(corner));
  }
  for (const BoundPoint& point : bound.points) {
    if (point.up) {
      json["up"].push_back(pair(*point.up));
    }
  }
  return json;
}

Json run_json(const ReportedRun& run, const std::string& label) {
  Json json = {{"label", label},
               {"controller", run.controller},
               {"folder", run.folder.string()},
               {"scenario", run.scenario},
               {"date", run.date},
               {"seed", std::to_string(run.seed)},
               {"transport", run.transport},
               {"digest", run.digest},
               {"regions", run.regions},
               {"fleet", run.fleet},
               {"solves", run.solves},
               {"fallbacks", run.fallbacks},
               {"solve_seconds_median", run.solve_seconds_median},
               {"wall_seconds", run.wall_seconds},
               {"totals", run.totals},
               {"steps", run.steps},
               {"timings", Json::array()},
               {"plan_costs", Json::array()},
               {"faults", Json::array()},
               {"sensors", Json::array()}};
  for (const auto& [term, cost] : run.plan_costs) {
    json["plan_costs"].push_back({{"term", term}, {"cost", cost}});
  }
  for (const auto& [process, legs] : run.timings) {
    for (const Leg& leg : legs) {
      json["timings"].push_back({{"process", process},
                                 {"leg", leg.name},
                                 {"times", leg.times},
                                 {"seconds", leg.seconds},
                                 {"longest", leg.longest}});
    }
  }
  for (const auto& fault : run.faults) {
    json["faults"].push_back(fault_json(run, fault));
  }
  for (const RecordedSensor& sensor : run.sensors) {
    json["sensors"].push_back(sensor_json(run, sensor));
  }
  if (run.without_faults) {
    json["without_faults"] = {{"steps", run.without_faults->steps}};
    json["costs"] = costs_json(run, *run.without_faults);
  }
  if (run.bound) {
    json["bound"] = bound_json(*run.bound, run.totals.at("rebalance_km") + run.totals.at("charge_km"));
  }
  return json;
}

}  // namespace

Json runs_json(const std::vector<ReportedRun>& runs, bool map) {
  const auto labels = labels_of(runs);
  Json all = Json::array();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    all.push_back(run_json(runs[i], labels[i]));
    if (map) {
      all.back()["by_region"] = by_region_json(runs[i]);
    }
  }
  return all;
}

Json windows_json(const std::vector<ReportedRun>& runs) {
  Json windows = Json::array();
  std::set<std::string> seen;
  for (const auto& run : runs) {
    for (const auto& fault : run.faults) {
      const Json json = {{"name", fault.name}, {"start", fault.start}, {"end", fault.end}};
      if (seen.insert(json.dump()).second) {
        windows.push_back(json);
      }
    }
  }
  return windows;
}

}  // namespace evbal
