#include "faults/schedule/schedule.hpp"

#include "agents/protocol/words.hpp"
#include "common/decimal.hpp"
#include "faults/schedule/draw.hpp"
#include "faults/schedule/entry.hpp"
#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/guard.hpp"
#include "faults/schedule/request.hpp"
#include "faults/schedule/target.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

double read_drawn(const YamlValue& value, const FaultType& type, int points) {
  switch (type.unit) {
    case MagnitudeUnit::count:
      return type.counts_points() ? value.integer(1, points)
                                  : value.integer(static_cast<int>(type.range.low), static_cast<int>(type.range.high));
    case MagnitudeUnit::minutes:
      return value.whole_minutes();
    case MagnitudeUnit::number:
    case MagnitudeUnit::none:
      break;
  }
  return value.number(type.range.low, type.range.high);
}

std::vector<double> read_magnitudes(YamlMap& map, const FaultType& type, const std::vector<int>& regions,
                                    const FaultContext& context) {
  if (type.unit == MagnitudeUnit::none) {
    return std::vector<double>(regions.size(), 0.0);
  }
  const auto value = map.require(type.magnitude);
  const auto items = value.items();
  if (items.size() != regions.size()) {
    throw value.error("expected one magnitude for each of the target's regions, " + std::to_string(regions.size()));
  }
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    magnitudes.push_back(read_drawn(items[i], type, type.counts_points() ? context.points_per_region[regions[i]] : 0));
  }
  return magnitudes;
}

int read_ramp(const YamlValue& value, int duration) {
  const double ramp = value.duration();
  if (ramp != std::floor(ramp) || 2.0 * ramp > duration) {
    throw value.error("`" + value.text() + "` must be whole minutes, at most half of the duration");
  }
  return static_cast<int>(ramp);
}

Fault read_fault(const YamlValue& entry, const FaultContext& context) {
  YamlMap map(entry);
  Fault fault;
  fault.name = read_name(map);
  const FaultType& type = fault_types()[map.require("type").one_of(fault_type_names())];
  fault.type = type.effect;
  const Target target = read_target(map, type, context);
  if (target.pick) {
    throw map.require("target").error("the target is still to be drawn; give its regions");
  }
  fault.regions = target.candidates;
  fault.field = target.field;
  fault.process = target.process;
  fault.topic = target.topic;
  fault.magnitudes = read_magnitudes(map, type, fault.regions, context);
  if (type.to) {
    fault.to = map.require("to").integer(0, static_cast<int>(context.points_per_region.size()) - 1);
  }
  const auto start = map.require("start");
  fault.start = start.time_of_day() - context.clock.start;
  if (fault.start < 0 || fault.start >= context.clock.minutes()) {
    throw start.error("`" + start.text() + "` is outside of the day; give a time from " +
                      time_of_day(context.clock, 0) + ", before " +
                      time_of_day(context.clock, context.clock.minutes()));
  }
  fault.duration = map.require(type.duration).whole_minutes();
  if (type.ramp) {
    fault.ramp = read_ramp(map.require("ramp"), fault.duration);
  }
  if (type.on_start) {
    fault.on_start = static_cast<OnStart>(map.require("on_start").one_of(words<OnStart>()));
  }
  if (type.may_be_invisible()) {
    fault.visible = map.require("visible").boolean();
  }
  map.finish();
  return fault;
}

void write_magnitudes(YamlWriter& yaml, const Fault& fault, const FaultType& type) {
  yaml.key(type.magnitude).begin_list(YamlWriter::Layout::one_line);
  for (const double magnitude : fault.magnitudes) {
    yaml.word(decimal(magnitude) + (type.unit == MagnitudeUnit::minutes ? "min" : ""));
  }
  yaml.end_list();
}

void write_fault(YamlWriter& yaml, const Fault& fault, const DayClock& clock) {
  const FaultType& type = fault_type(fault.type);
  yaml.begin_map().key("name").text(fault.name).key("type").word(type.name);
  if (type.target != TargetKind::engine) {
    yaml.key("target");
    write_target(yaml, fault);
  }
  if (type.unit != MagnitudeUnit::none) {
    write_magnitudes(yaml, fault, type);
  }
  if (type.to) {
    yaml.key("to").number(fault.to);
  }
  yaml.key("start").text(time_of_day(clock, fault.start)).key(type.duration).minutes(fault.duration);
  if (type.ramp) {
    yaml.key("ramp").minutes(fault.ramp);
  }
  if (type.on_start) {
    yaml.key("on_start").word(std::string(word(fault.on_start)));
  }
  if (type.may_be_invisible()) {
    yaml.key("visible").boolean(fault.visible);
  }
  yaml.end_map();
}

/// How many schedules are drawn.
int read_runs(const YamlValue& value, bool resolved) {
  if (resolved) {
    throw value.error("nothing is left to draw in a resolved list of faults; leave `runs` out");
  }
  constexpr int most = 10'000;
  return value.integer(1, most);
}

/// Faults that keep the guard.
std::vector<Fault> checked(const std::vector<PlacedFault>& placed, const Guard& guard, const FaultContext& context) {
  check_guard(guard, placed, context);
  std::vector<Fault> faults;
  faults.reserve(placed.size());
  for (const auto& fault : placed) {
    faults.push_back(fault.fault);
  }
  return faults;
}

std::vector<Fault> draw_all(const std::vector<YamlValue>& entries, const Guard& guard, const FaultContext& context,
                            const DrawKey& key) {
  std::vector<PlacedFault> placed;
  for (const auto& entry : entries) {
    for (auto& fault : draw_faults(read_request(entry, context), context, key)) {
      placed.push_back({std::move(fault), entry});
    }
  }
  return checked(placed, guard, context);
}

/// Draws `runs` schedules. What is wrong with a later one is said with its number.
std::vector<Schedule> draw_runs(const std::vector<YamlValue>& entries, const Schedule& head,
                                const FaultContext& context, int runs) {
  std::vector<Schedule> schedules(static_cast<std::size_t>(runs), head);
  for (int run = 0; run < runs; ++run) {
    try {
      schedules[run].faults = draw_all(entries, head.guard, context, {head.seed, static_cast<std::uint64_t>(run)});
    } catch (const Error& error) {
      throw run == 0 ? error
                     : Error(error.status(), std::string(error.what()) + " (in draw " + std::to_string(run + 1) +
                                                 " of " + std::to_string(runs) + ")");
    }
  }
  return schedules;
}

}  // namespace

std::vector<Schedule> read_schedules(YamlMap& map, const FaultContext& context) {
  map.require("schema").integer(1, 1);
  const auto resolved_key = map.find("resolved");
  const bool resolved = resolved_key && resolved_key->boolean();
  Schedule head;
  if (const auto seed = map.find("seed")) {
    head.seed = seed->seed();
  }
  if (const auto guard = map.find("guard")) {
    head.guard = read_guard(*guard);
  }
  const auto given = map.find("runs");
  const int runs = given ? read_runs(*given, resolved) : 1;
  const auto entries = map.require("faults").items();
  if (!resolved) {
    auto schedules = draw_runs(entries, head, context, runs);
    if (runs > 1 && std::all_of(schedules.begin(), schedules.end(),
                                [&](const Schedule& schedule) { return schedule == schedules.front(); })) {
      throw given->error(
          "the faults leave nothing to draw, all runs would be the same; leave `runs` out, or give a "
          "distribution or `pick`");
    }
    return schedules;
  }
  std::vector<PlacedFault> placed;
  placed.reserve(entries.size());
  for (const auto& entry : entries) {
    placed.push_back({read_fault(entry, context), entry});
  }
  head.faults = checked(placed, head.guard, context);
  return {head};
}

Schedule read_resolved(YamlMap& scenario, const FaultContext& context) {
  YamlMap map(scenario.require("faults"));
  const auto resolved = map.require("resolved");
  if (!resolved.boolean()) {
    throw resolved.error("the faults must be drawn already; give a resolved scenario");
  }
  auto schedules = read_schedules(map, context);
  map.finish();
  return schedules.front();
}

void write_schedule(YamlWriter& yaml, const Schedule& schedule, const DayClock& clock) {
  yaml.key("schema").number(1).key("resolved").boolean(true).key("seed").number(schedule.seed);
  yaml.key("guard").begin_map(YamlWriter::Layout::one_line).key("max_active").number(schedule.guard.max_active);
  yaml.key("min_working_points").number(schedule.guard.min_working_points).key("overlap").word("reject").end_map();
  yaml.key("faults").begin_list();
  for (const auto& fault : schedule.faults) {
    write_fault(yaml, fault, clock);
  }
  yaml.end_list();
}

}  // namespace evbal
