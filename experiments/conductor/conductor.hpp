#pragma once

#include "agents/world/world.hpp"
#include "experiments/conductor/attendance.hpp"
#include "experiments/conductor/players.hpp"
#include "experiments/conductor/roads.hpp"

#include <deque>
#include <functional>
#include <set>

namespace evbal {

/// Conducts a day, tick by tick: begin_tick, then end_tick with what was said in it; after the last tick end_day.
///
/// Each tick is shown to `observe`, in turn, once all is known of it and it has passed its checks. What faults of
/// processes and of the network do is decided here (attendance.hpp): a region whose agent is away is not waited for,
/// and cars bound for it wait on the road; once its agent is back, at the day's end at the latest, it says what became
/// of it meanwhile. The checks: every vehicle is in the one region that was handed it or on the road, plants + roads =
/// fleet, points in use <= working points, nobody is planned to send more vehicles than it reported, if the plan
/// believes its report. Each function throws Error{run_failed} naming tick and region if one does not hold, and
/// whatever `players` throw; the day cannot go on then.
class Conductor {
 public:
  /// `world` and `players` must outlive it.
  Conductor(const World& world, Players& players, std::function<void(const TickRecord&)> observe);

  /// Whether every tick has been played.
  bool over() const { return next_ == world_.clock.ticks(); }

  /// The tick that is to be begun, or that is going on.
  int next() const { return next_; }

  /// Announces the next tick, which is to be played: `Players::play` gives what end_tick wants.
  const Tick& begin_tick();

  /// Ends the tick with all that was said in it.
  void end_tick(Exchange said);

  /// Has those who are still away say what became of their regions.
  void end_day();

 private:
  /// What the injector says; while it is away or late, what it last said goes on.
  Faults hear_faults(int tick);
  void take_away(const Absences& away);
  /// Takes note of who is absent now. Who is back first says what became of its region meanwhile.
  void call(const std::set<int>& absent);
  Tick announce(const Faults& faults, const Attendance& present);
  void check_and_move(const Tick& tick, const Exchange& exchange);
  /// Shows the ticks of which all is known, in their turn.
  void show();

  const World& world_;
  Players& players_;
  std::function<void(const TickRecord&)> observe_;
  MessageBounds bounds_;
  Eigen::VectorXi installed_;
  RunShape shape_;
  Roads roads_;
  int next_ = 0;                 ///< tick that is not over
  TickRecord now_;               ///< what is known of it once it has begun
  std::deque<TickRecord> open_;  ///< ticks of which somebody has not spoken yet
  std::set<int> absent_;         ///< regions
  Absences away_;
  Faults heard_;           ///< from the injector, and in time
  int injector_back_ = 0;  ///< tick
};

}  // namespace evbal
