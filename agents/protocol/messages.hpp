#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

/// What is said in one tick (`architecture` of the docs): plain values, the same over DDS and in one process.
/// Regions count from 0; minutes count from the day's start; lists are in the order that each comment gives, so
/// that equal worlds give equal bytes.
///
/// To add a field, write one line here and one at the same place of agents/bus/evbal.idl; tests/bus/idl_test.cpp fails
/// if either is forgotten. RegionPlant::report() fills a report's; one that is measured also needs a ReportField and a
/// row in measured.hpp. Bus, journals, record, digests and bridge find the field by itself (reflection.hpp). Then
/// say in message_check.cpp which values cannot be, and at the end of this file if digests treat the field in another
/// way.
namespace evbal {

/// Who wrote a message and what it cost.
struct Origin {
  std::int64_t process_id = 0;  ///< of the writer, as the operating system counts
  double seconds = 0.0;         ///< CPU seconds spent on making it
};

/// A vehicle on its way from region to region.
struct Vehicle {
  std::int32_t id = 0;        ///< from 0, in the whole fleet
  std::int32_t sessions = 0;  ///< charging sessions begun so far; keys the stream of the next one
  double battery_kwh = 0.0;   ///< charge
};

/// Why a vehicle is on the road.
enum class Errand : std::uint8_t {
  passenger = 0,  ///< carries a passenger: occupied
  rebalance = 1,  ///< vacant, sent by a plan
  charge = 2,     ///< low-battery, sent to a station
};

/// A vehicle that the roads hand to a region.
struct Arrival {
  std::int32_t region = 0;            ///< where it arrives
  std::int32_t minute = 0;            ///< when it arrives
  Errand errand = Errand::passenger;  ///< why it comes
  Vehicle vehicle;                    ///< itself
};

/// Cars bound for a region that have not arrived yet.
struct UnderWay {
  std::int32_t region = 0;            ///< they are bound for
  std::int32_t minute = 0;            ///< when they arrive
  Errand errand = Errand::passenger;  ///< why they come
  std::int32_t count = 0;             ///< vehicles
};

/// What a fault does. Values are part of every digest: append, never renumber.
enum class EffectType : std::uint8_t {
  demand_scale = 0,        ///< magnitude: factor on the passengers who appear
  charger_outage = 1,      ///< magnitude: points that do not work
  demand_add = 2,          ///< magnitude: further passengers an hour
  demand_shift = 3,        ///< magnitude: share of the passengers who want to go to `to` instead
  charger_derate = 4,      ///< magnitude: factor on the charging power
  charger_block = 5,       ///< magnitude: points that work, but where nobody can plug in
  fleet_breakdown = 6,     ///< magnitude: vehicles that cannot be used
  fleet_drain = 7,         ///< magnitude: factor on the energy that trips from here cost
  travel_slow = 8,         ///< magnitude: factor on the minutes that trips from here take
  sensor_stuck = 9,        ///< the field says what it said when the fault began
  sensor_garbage = 10,     ///< the field says anything
  sensor_biased = 11,      ///< magnitude: is added to the field
  sensor_noisy = 12,       ///< magnitude: standard deviation of what is added
  sensor_delayed = 13,     ///< magnitude: minutes by which the field is late
  sensor_off = 14,         ///< the field says nothing
  process_kill = 15,       ///< the process is gone; magnitude: ticks until it is back
  process_pause = 16,      ///< the process stands still; magnitude: ticks until it goes on
  process_slow = 17,       ///< magnitude: minutes by which the process is late with all that it says
  network_drop = 18,       ///< magnitude: probability that a sample is lost
  network_delay = 19,      ///< magnitude: minutes by which samples are late
  network_partition = 20,  ///< nothing comes through between the region and the coordinator
  solver_fail = 21,        ///< no solve succeeds
  solver_starve = 22,      ///< magnitude: iterations that a solve may take
  charger_no_start = 23,   ///< magnitude: probability that a charging session does not start
  host_down = 24,          ///< like process_kill, for all processes of a host
};

/// Whom a fault acts on.
enum class FaultFamily {
  world,    ///< the plants
  sensor,   ///< what regions report
  process,  ///< agents, coordinator, injector
  network,  ///< samples between agents and coordinator
  solver,   ///< the coordinator's engine
};

/// The family that an effect belongs to.
constexpr FaultFamily family_of(EffectType type) {
  const bool world = type <= EffectType::travel_slow || type == EffectType::charger_no_start;
  return world                                   ? FaultFamily::world
         : type == EffectType::host_down         ? FaultFamily::process
         : type <= EffectType::sensor_off        ? FaultFamily::sensor
         : type <= EffectType::process_slow      ? FaultFamily::process
         : type <= EffectType::network_partition ? FaultFamily::network
                                                 : FaultFamily::solver;
}

/// What happens to the cars at points that fail.
enum class OnStart : std::uint8_t {
  drain = 0,  ///< sessions under way end as planned
  evict = 1,  ///< cars are unplugged and queue again
};

/// A number in a region's report that a sensor measures.
enum class ReportField : std::uint8_t {
  none = 0,
  vacant = 1,
  low_battery = 2,
  plugged = 3,
  points = 4,
  waiting = 5,
  demand = 6,
  completions = 7,
  chargeable = 8,
};

/// The processes that a fault may act on; an agent is named by its region.
enum class ProcessRole : std::uint8_t { agent = 0, coordinator = 1, injector = 2 };

/// What can be lost or late between a region and the coordinator.
enum class NetworkTopic : std::uint8_t { all = 0, report = 1, plan = 2 };

/// Stands for a region where there is none: faults of coordinator and injector.
constexpr std::int32_t no_region = -1;

/// One fault's effect on one region, or on the coordinator or the injector, during one tick.
struct Effect {
  std::int32_t fault = 0;                      ///< position in the resolved schedule
  EffectType type = EffectType::demand_scale;  ///< what it does
  std::int32_t region = 0;                     ///< of an agent its region; no_region for coordinator and injector
  double magnitude = 0.0;                      ///< see EffectType
  OnStart on_start = OnStart::drain;           ///< of charger_outage
  bool visible = true;                         ///< whether reports and forecasters are told
  std::int32_t to = no_region;                 ///< destination, of demand_shift
  ReportField field = ReportField::none;       ///< of sensor faults
  ProcessRole process = ProcessRole::agent;    ///< of process faults
  NetworkTopic topic = NetworkTopic::all;      ///< of network faults
};

/// Injector to conductor: the effects that are active during a tick.
struct Faults {
  std::int32_t tick = 0;        ///< from 0
  std::vector<Effect> effects;  ///< of all families, by (fault, region)
  Origin origin;                ///< who wrote it
};

/// Conductor to all: a tick begins.
struct Tick {
  std::int32_t tick = 0;                ///< from 0
  bool plan_due = false;                ///< and the coordinator is there
  std::vector<std::int32_t> due;        ///< regions that are waited for, ascending
  std::vector<std::int32_t> unheard;    ///< those of them whose report does not reach the coordinator in time
  std::vector<std::int32_t> unplanned;  ///< those that no plan reaches in time: they follow a rule of their own
  bool unattended = false;  ///< the agents that are due were gone when this tick was: their regions lived it alone
  std::vector<Arrival> arrivals;    ///< during this tick, by (region, minute, vehicle)
  std::vector<UnderWay> under_way;  ///< after those arrivals, by (region, minute, errand)
  std::vector<Effect> effects;      ///< by (fault, region)
};

/// Agent to coordinator, if a plan is due: the region before anything moves.
struct Report {
  std::int32_t tick = 0;                    ///< that the plan is due in
  std::int32_t region = 0;                  ///< that is reported
  std::int32_t vacant = 0;                  ///< vehicles without passengers, with charge enough
  std::int32_t low_battery = 0;             ///< waiting, in the queue or where there is no station
  std::int32_t plugged = 0;                 ///< vehicles at charging points
  std::int32_t points = 0;                  ///< working points, as far as they are visible
  std::int32_t waiting = 0;                 ///< passengers
  std::int32_t demand = 0;                  ///< passengers who appeared since the region's last report
  std::int32_t completions = 0;             ///< sessions that ended charged since the last report
  std::int32_t chargeable = 0;              ///< vacant vehicles with less than 85 % of their battery
  std::vector<std::int32_t> plugged_since;  ///< minute at which each plugged car began, ascending
  std::vector<std::int32_t> reach_m;  ///< metres that low-battery vehicles can still drive, of those that do not get
                                      ///< to every region; ascending
  std::vector<UnderWay> bound;        ///< arrivals of this tick and cars under way to here, by (minute, errand)
  Origin origin;                      ///< who wrote it
};

/// An order to send `count` vehicles: vacant ones to another region (rebalance), low-battery ones to another region
/// (charge), or, where the world knows top-up charging, vacant ones to the chargers of their own (charge, from == to).
struct Move {
  std::int32_t from = 0;              ///< region
  std::int32_t to = 0;                ///< region
  std::int32_t count = 0;             ///< vehicles, at least 1
  Errand errand = Errand::rebalance;  ///< rebalance or charge
};

/// How a plan came about when the first choice failed, best first.
enum class FallbackLevel : std::uint8_t {
  none = 0,     ///< the controller itself
  nominal = 1,  ///< the same problem without its worst cases
  shifted = 2,  ///< the last plan's next step
  hold = 3,     ///< nobody moves
};

/// A report that was not believed, or did not come.
struct Rejection {
  std::int32_t region = 0;  ///< that it says it is of
  std::string reason;       ///< in a few words

  /// Field by field.
  bool operator==(const Rejection&) const = default;
};

/// What a sensor that lies does, as far as its reports show.
enum class SensorFaultKind : std::uint8_t {
  silent = 0,   ///< says nothing, or what no sensor says
  stuck = 1,    ///< says the same all the time
  biased = 2,   ///< is off by about the same number
  noisy = 3,    ///< is off by a number that changes
  delayed = 4,  ///< says what was true some reports ago
};

/// A field of a region's report that the coordinator has found to lie.
struct SensorFlag {
  std::int32_t region = 0;                         ///< whose report it is
  ReportField field = ReportField::none;           ///< of the report
  SensorFaultKind kind = SensorFaultKind::silent;  ///< which explains best what was reported so far
  std::int32_t reported = 0;                       ///< what the field says
  std::int32_t estimate = 0;                       ///< what the coordinator takes to be true
  bool isolated = false;                           ///< whether the plan was made from the estimate

  /// Field by field.
  bool operator==(const SensorFlag&) const = default;
};

/// How well the coordinator foresees a count of the reports, over all regions whose count is believed.
struct FieldInnovations {
  ReportField field = ReportField::none;  ///< that is foreseen
  std::int32_t counts = 0;                ///< regions
  double squares = 0.0;                   ///< sum over them of (count - expected)^2 over the variance that is expected
  std::int32_t within = 0;                ///< of them, where 95 of 100 are expected
  double expected_within = 0.0;           ///< what is to be expected of `within`: counts are whole, so it is more
};

/// A part of a plan's objective.
struct PlanCost {
  std::string term;   ///< "km", "queue", "shortage", ...
  double cost = 0.0;  ///< km of empty driving that it weighs as much as
};

/// What made a plan and how good it is.
struct Provenance {
  std::string controller;                        ///< its name
  std::string engine;                            ///< its name; empty if nothing was solved
  FallbackLevel fallback = FallbackLevel::none;  ///< how far down the ladder
  std::string reason;                            ///< why there was a fallback; empty without
  double objective = 0.0;                        ///< km
  double lower_bound = 0.0;                      ///< km, on the objective
  double gap = 0.0;                              ///< relative, of the solve's certificate
  double max_violation = 0.0;                    ///< of any constraint, recomputed from the model
  std::int32_t iterations = 0;                   ///< of the engine
  double demand_widened = 1.0;        ///< by the innovation test: the largest factor on a region's standard deviation
  double completions_widened = 1.0;   ///< likewise
  std::vector<Rejection> rejected{};  ///< by region; these regions stand in the plan as the coordinator estimates them
  std::vector<PlanCost> costs{};      ///< the objective by term, which they sum to; none if nothing was solved
  std::vector<SensorFlag> flags{};    ///< by (region, field); none unless the scenario asks for them (`sensor_faults`)
  std::vector<FieldInnovations> innovations{};  ///< by field; likewise
};

/// Coordinator to all.
struct Plan {
  std::int32_t tick = 0;    ///< that it is made for
  std::vector<Move> moves;  ///< by (errand, from, to), counts at least 1
  Provenance provenance;    ///< what made it
  Origin origin;            ///< who wrote it
};

/// A vehicle that leaves a region.
struct Departure {
  std::int32_t minute = 0;            ///< when it leaves
  std::int32_t to = 0;                ///< region
  std::int32_t arrival_minute = 0;    ///< when it arrives
  Errand errand = Errand::passenger;  ///< why it leaves
  Vehicle vehicle;                    ///< with the charge it will arrive with
  double km = 0.0;                    ///< of the way
};

/// What became of a passenger, said in the tick in which it was settled.
struct Fate {
  std::int32_t appeared = 0;     ///< minute
  std::int32_t destination = 0;  ///< region
  std::int32_t waited = 0;       ///< minutes
  bool served = false;           ///< else lost
  std::int32_t vehicle = -1;     ///< who served, -1 if lost
};

/// What a fault was seen to do in a region during a tick.
struct Observed {
  std::int32_t fault = 0;  ///< position in the resolved schedule
  /// Passengers added, removed or redirected; points closed or blocked; vehicles out of order; kWh not charged, or lost
  /// on the road; further minutes of trips; what a report said too much
  double amount = 0.0;
  std::int32_t evicted = 0;  ///< vehicles
};

/// Agent to conductor: what left the region during a tick, and how it stands at the tick's end.
struct Departures {
  std::int32_t tick = 0;              ///< that was lived
  std::int32_t region = 0;            ///< that is told of
  std::vector<Departure> departures;  ///< by (minute, vehicle)
  std::vector<Fate> fates;            ///< by (minute settled, appeared, order of arrival)
  std::vector<Observed> observed;     ///< by fault
  std::int32_t refused = 0;           ///< vehicles that the plan asked for and the region did not have
  std::int32_t topped_up = 0;         ///< vacant vehicles that joined the queue for a charger because the plan said so
  std::int32_t demand = 0;            ///< passengers who appeared
  std::int32_t completions = 0;       ///< sessions that ended charged
  std::int32_t queue_minutes = 0;     ///< vehicle-minutes that low-battery cars waited in regions with stations
  std::int32_t stranded = 0;          ///< vehicles that arrived here with an empty battery
  double charged_kwh = 0.0;           ///< into all vehicles
  std::int32_t vacant = 0;            ///< these six at the tick's end
  std::int32_t low_battery = 0;       ///< vehicles that wait for a charger
  std::int32_t plugged = 0;           ///< vehicles at charging points
  std::int32_t points = 0;            ///< points that really work
  std::int32_t waiting = 0;           ///< passengers
  std::int32_t broken = 0;            ///< vehicles that are here and cannot be used
  Origin origin;                      ///< who wrote it
};

/// Fields that are recorded but no part of any digest: they differ between runs of the same day, or say in detail what
/// another field sums up.
inline constexpr std::tuple outside_digests{&Faults::origin,     &Report::origin,    &Plan::origin,
                                            &Departures::origin, &Provenance::costs, &Provenance::innovations};

/// Fields that digests take in only where they differ from their default, and then with their name: digests of days
/// without such a fault stay what they were before there was the field.
inline constexpr std::tuple rare_in_digests{&Effect::to,
                                            &Effect::field,
                                            &Effect::process,
                                            &Effect::topic,
                                            &Provenance::demand_widened,
                                            &Provenance::completions_widened,
                                            &Provenance::rejected,
                                            &Provenance::flags,
                                            &Departures::broken};

}  // namespace evbal
