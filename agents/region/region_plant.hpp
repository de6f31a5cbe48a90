#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/region/region_world.hpp"
#include "agents/region/sensors.hpp"
#include "agents/world/draws.hpp"
#include "agents/world/world.hpp"
#include "common/random.hpp"

#include <deque>
#include <vector>

namespace evbal {

/// A vehicle at a charging point.
struct Session {
  Vehicle vehicle;      ///< that is plugged in
  int since = 0;        ///< minute at which it was plugged in
  int ends = 0;         ///< minute at which it leaves if nothing happens
  bool started = true;  ///< whether it charges
};

/// A vehicle that cannot be used until its fault ends.
struct BrokenDown {
  Vehicle vehicle;  ///< that has broken down
  int fault = 0;    ///< position in the resolved schedule
};

/// All that a region carries from one tick to the next.
struct RegionState {
  std::vector<Vehicle> vacant;     ///< by (battery, id)
  std::deque<Vehicle> queue;       ///< low-battery, first come first; waiting for a plan where there is no station
  std::vector<Session> sessions;   ///< in the order in which they began
  std::vector<Passenger> waiting;  ///< in the order in which they appeared
  int drawn = 0;                   ///< passengers of the day who have had their minute
  int demand = 0;                  ///< passengers who appeared since the last report
  int completions = 0;             ///< sessions that ended charged since the last report
  std::vector<BrokenDown> broken;  ///< in the order in which they broke down
  SensorMemory sensors;            ///< what faulty sensors showed
};

/// What a vehicle in a region is doing.
enum class VehicleState { vacant, low_battery, plugged, broken };

/// A vehicle of the region.
struct VehiclePlace {
  int vehicle = 0;                            ///< its id
  VehicleState state = VehicleState::vacant;  ///< what it is doing
};

/// Share of the battery below which a vacant vehicle may be told to top up.
inline constexpr double chargeable_below = 0.85;

/// One region as it really is: whole vehicles, minute by minute. Per tick call begin, then report if a plan is due,
/// then live.
///
/// **Charge.** A passenger is served only by a car that can do the trip and then reach the station nearest to its
/// destination. A car is low-battery if it could not do so for 95 of 100 of the passengers who ask here during the day
/// (never more than half the battery is asked for), looked at whenever it becomes free. It waits for a point until it
/// has had a session. A session keeps its point for the minutes drawn, charges at full power until the battery is
/// full, and ends `completed` unless the car is still low; then the car queues again.
///
/// **A tick.** Vehicles break down and points fail (below) before the report. Then the plan's moves go, the farthest
/// first: vacant cars from the highest charge down, low-battery cars from the queue's tail, each only if it can get
/// there (and, if vacant, on to a station). In a world that knows top-up charging, vacant cars that are told to charge
/// here then join the queue, from the lowest charge up, if they are chargeable_below. Then for each minute: cars
/// arrive; sessions end; the queue's head plugs in; passengers appear; waiting passengers, first come first served, get
/// the car with the lowest sufficient charge, or are lost when their patience has run out; plugged cars gain a minute's
/// energy. A trip takes the mean minutes of its pair, rounded up, and costs its mean km, which the departing car's
/// battery already shows. It arrives in a later tick, so a shorter trip takes until this tick's end.
///
/// **Failing points.** Free points fail first. `evict` unplugs the cars that came last and puts them at the queue's
/// head; with `drain` a point in use fails when its session ends. `points` therefore counts max(points left, points in
/// use). A blocked point works, but nobody can plug in; it counts in reports as one that does not work, if they are
/// told.
///
/// **Sessions that do not start** take their point for five minutes, in which the car charges nothing. Then it is at
/// the queue's head and tries again. They are no sessions in any count but `plugged`.
///
/// **Demand faults.** With factor m at a passenger's minute, floor(m + u) passengers appear in the place of one, u
/// uniform and keyed by the passenger: the same passengers with and without the fault as far as it lets them. Added
/// ones are Poisson by the minute and go where one of the region's passengers, drawn evenly, goes on this day.
///
/// **Without a plan** that was due, low-battery cars of a region without points go to the nearest region that has some;
/// all others stay. **Unattended**, a region goes on but for dispatch: cars charge, passengers wait, nobody sets off.
///
/// **Vehicles that break down** are vacant ones, drawn evenly, as soon as there are any, and come back as they were. A
/// report that is not told counts them as vacant. Trips that cost more energy are begun as if they did not, unless the
/// region is told: the battery ends at 0 then, at worst.
class RegionPlant {
 public:
  /// Begins the day.
  explicit RegionPlant(RegionWorld world);

  /// Takes this region's arrivals and effects of the tick.
  void begin(const Tick& tick);

  /// The region before anything moves, as its sensors say. Counts restart: call it once where a plan is due.
  Report report();

  /// Sends off what the plan asks for as far as it is there, and lives through the tick's minutes. `plan` is null where
  /// none is due; one of another tick is refused as a whole.
  Departures live(const Plan* plan);

  /// Which region this is.
  int region() const { return world_.region; }

  /// Every vehicle that is here, by id.
  std::vector<VehiclePlace> census() const;

  /// All that it carries over to the next tick.
  const RegionState& state() const { return state_; }

 private:
  /// What the tick brings to this region.
  struct Incoming {
    std::vector<Arrival> arrivals;    ///< by (minute, vehicle)
    std::vector<UnderWay> under_way;  ///< by (minute, errand)
    std::vector<Effect> effects;      ///< by fault
    bool unplanned = false;           ///< see Tick, as the next
    bool unattended = false;
  };

  double factor(EffectType type, bool visible_only) const;  ///< of all effects of a type together
  int points_left(bool visible_only) const;
  int working_points(bool visible_only) const;
  int points_blocked(bool visible_only) const;
  std::vector<Vehicle> vacant_as_told() const;
  std::vector<std::int32_t> short_reach() const;
  bool starts(const Vehicle& vehicle, int minute);  ///< whether the session of one who plugs in does
  void fail_points();
  void break_down();
  void mend();
  void observe(EffectType type, double amount);  ///< adds to what the first effect of a type was seen to do
  void count_points();

  void send_by_own_rule();
  void send_off(const Plan& plan);
  double energy_for(const Move& move) const;
  int send(const Move& move);
  int send_vacant(int to, int count);
  int send_low_battery(int to, int count);
  int top_up(int count);
  void depart(Vehicle vehicle, int to, Errand errand, int minute);

  void live_minute(int minute);
  void arrive(int minute);
  void end_sessions(int minute);
  void plug_in(int minute);
  void appear(int minute);
  void serve_or_lose(int minute);
  void charge();

  int copies(double uniform);
  void add_passengers(int minute);
  Passenger redirected(Passenger passenger, RandomStream& stream);
  void settle(Vehicle vehicle);  ///< a free car is vacant or joins the queue
  bool try_serve(const Passenger& passenger, int minute);
  void close_books();

  RegionWorld world_;
  std::vector<double> trip_kwh_;  ///< to each region
  std::vector<double> need_kwh_;  ///< to each region and on to its nearest station
  std::vector<int> trip_minutes_;
  double reserve_kwh_ = 0.0;  ///< a car with less is low-battery

  RegionState state_;
  Incoming incoming_;
  Departures said_;  ///< of the tick under way
};

/// The plants of all regions, by region.
std::vector<RegionPlant> make_plants(const World& world);

}  // namespace evbal
