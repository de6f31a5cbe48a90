#pragma once

#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// What goes wrong, when and where (docs/faults.md): a schedule is asked for in YAML, drawn once from its own seed,
/// and from then on a list of faults without chance.
namespace evbal {

/// What a schedule may refer to: the simulated day, and the regions by their charging points and hosts.
struct FaultContext {
  DayClock clock;                                    ///< of the run
  std::vector<int> points_per_region;                ///< installed
  std::vector<std::vector<int>> regions_per_host{};  ///< of each host that the scenario names, ascending
};

/// One fault, drawn: nothing about it is open any more.
struct Fault {
  std::string name;                            ///< unique in its schedule
  EffectType type = EffectType::demand_scale;  ///< what it does
  std::vector<int> regions;                    ///< ascending; {no_region} if it acts on none
  std::vector<double> magnitudes;              ///< one for each region, see EffectType; 0 for types that have none
  int start = 0;                               ///< minute
  int duration = 0;                            ///< minutes, at least 1
  int ramp = 0;                                ///< minutes of rise at the start and of fall at the end
  OnStart on_start = OnStart::drain;           ///< cars at points that fail
  bool visible = true;                         ///< whether reports and forecasters are told
  int to = no_region;                          ///< see Effect, as the next three
  ReportField field = ReportField::none;       ///< of sensor faults
  ProcessRole process = ProcessRole::agent;    ///< of process faults
  NetworkTopic topic = NetworkTopic::all;      ///< of network faults

  /// Field by field.
  bool operator==(const Fault&) const = default;
};

/// Limits that a schedule must keep at every tick; one that does not is refused.
struct Guard {
  int max_active = 1000;       ///< faults at a time
  int min_working_points = 0;  ///< charging points of the whole city

  /// Field by field.
  bool operator==(const Guard&) const = default;
};

/// A drawn schedule. Faults are in the order of the request, repetitions of one by time; an Effect refers to them by
/// position. No two of a type touch one region (or field of its report, or topic) at a time, no two one process.
struct Schedule {
  std::uint64_t seed = 0;     ///< that it was drawn from
  Guard guard;                ///< limits that it keeps
  std::vector<Fault> faults;  ///< see above for their order

  /// Field by field.
  bool operator==(const Schedule&) const = default;
};

/// Reads a schedule and draws what it leaves open, as often as `runs` says: once, if that is left out. One with
/// `resolved: true` is taken as it stands. Asks `map` for the keys of a schedule only: the caller asks for its own and
/// calls finish(). Throws Error{bad_input} with file and line for whatever is unknown, out of range, or against the
/// guard, and if all runs would be the same.
std::vector<Schedule> read_schedules(YamlMap& map, const FaultContext& context);

/// Reads the key `faults` of a resolved scenario. Throws as read_schedules, and if anything is still to be drawn.
Schedule read_resolved(YamlMap& scenario, const FaultContext& context);

/// Writes the keys of a schedule that read_schedules gives back unchanged.
void write_schedule(YamlWriter& yaml, const Schedule& schedule, const DayClock& clock);

/// The effects that are active during a tick, of all families, by (fault, region). Pure.
Faults faults_at(const Schedule& schedule, const DayClock& clock, int tick);

/// Ticks [first, last) in which a fault acts: from the tick nearest to its start to the one nearest to its end, at
/// least one. `last` may lie beyond the day.
struct TickWindow {
  int first = 0;  ///< tick
  int last = 0;   ///< tick after the last

  /// Whether a tick lies within.
  bool holds(int tick) const { return first <= tick && tick < last; }
};
/// The ticks during which a fault is active.
TickWindow tick_window(const Fault& fault, const DayClock& clock);

}  // namespace evbal
