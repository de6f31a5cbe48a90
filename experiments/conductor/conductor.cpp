#include "experiments/conductor/conductor.hpp"

#include "agents/world/draws.hpp"
#include "common/error.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace evbal {
namespace {

/// Throws unless `holds`.
void require(bool holds, const World& world, int tick, int region, const std::string& what) {
  if (!holds) {
    throw run_failed("tick " + std::to_string(tick) + " (" + time_of_day(world.clock, world.clock.minute_of(tick)) +
                     "), region " + std::to_string(region) + " (" + world.city.regions[region].name + "): " + what);
  }
}

/// Every region that is due has spoken, of this tick and in its turn.
void check_complete(const Tick& tick, const Exchange& exchange) {
  const bool plan_due = tick.plan_due && !tick.unattended;
  const auto in_turn = [&](const auto& messages) {
    return std::equal(
        messages.begin(), messages.end(), tick.due.begin(), tick.due.end(),
        [&](const auto& message, int region) { return message.tick == tick.tick && message.region == region; });
  };
  if (!in_turn(exchange.departures) || (plan_due && !in_turn(exchange.reports)) ||
      plan_due != exchange.plan.has_value() || (exchange.plan && exchange.plan->tick != tick.tick)) {
    throw run_failed("tick " + std::to_string(tick.tick) + ": reports, plan or departures are missing");
  }
}

/// Nobody saw a fault that does not act on its region in this tick.
void check_observed(const World& world, const Tick& tick, const Departures& said) {
  for (const Observed& seen : said.observed) {
    const bool acts = std::any_of(tick.effects.begin(), tick.effects.end(), [&](const Effect& effect) {
      return effect.fault == seen.fault && effect.region == said.region;
    });
    require(acts, world, said.tick, said.region,
            "saw fault " + std::to_string(seen.fault) + ", which does not act there");
  }
}

/// With as many vehicles in every region as it was handed, plants + roads = fleet: each vehicle has one holder.
void check_vehicles_and_points(const World& world, const Eigen::VectorXi& installed, const Roads& roads,
                               const Departures& said) {
  const int here = said.vacant + said.low_battery + said.plugged + said.broken;
  const int handed = roads.held_by(said.region);
  require(here == handed, world, said.tick, said.region,
          "has " + std::to_string(here) + " vehicles, was handed " + std::to_string(handed));
  require(said.points <= installed[said.region], world, said.tick, said.region,
          std::to_string(said.points) + " points work, " + std::to_string(installed[said.region]) + " are installed");
  require(said.plugged <= said.points, world, said.tick, said.region,
          std::to_string(said.plugged) + " points in use, " + std::to_string(said.points) + " work");
}

/// Vehicles that a plan asks of a region.
struct Asked {
  std::int64_t vacant = 0;
  std::int64_t chargeable = 0;  ///< of these, told to charge where they stand
  std::int64_t low_battery = 0;
};

std::map<int, Asked> asked_by(const Plan& plan) {
  std::map<int, Asked> asked;
  for (const auto& move : plan.moves) {
    const bool charges = move.errand == Errand::charge;
    const bool stays = move.from == move.to;
    (charges && !stays ? asked[move.from].low_battery : asked[move.from].vacant) += move.count;
    asked[move.from].chargeable += charges && stays ? move.count : 0;
  }
  return asked;
}

void check_plan(const World& world, const Tick& tick, const Plan& plan, const std::vector<Report>& reports) {
  std::map<int, Asked> asked = asked_by(plan);
  std::set<int> estimated(tick.unheard.begin(), tick.unheard.end());
  for (const auto& rejection : plan.provenance.rejected) {
    estimated.insert(rejection.region);
  }
  for (const SensorFlag& flag : plan.provenance.flags) {
    if (flag.isolated) {
      estimated.insert(flag.region);
    }
  }
  for (const auto& report : reports) {
    if (estimated.contains(report.region)) {
      continue;
    }
    const Asked& from = asked[report.region];
    require(from.vacant <= report.vacant && from.low_battery <= report.low_battery, world, plan.tick, report.region,
            "is planned to send more vehicles than it reported");
    require(from.chargeable <= report.chargeable, world, plan.tick, report.region,
            "is planned to top up more vehicles than it reported");
  }
}

/// The effects of `before`, and `more`, as if they were `said`.
Faults with(const Faults& before, const Effect& more, Faults said) {
  said.effects = before.effects;
  said.effects.push_back(more);
  std::sort(said.effects.begin(), said.effects.end(),
            [](const Effect& a, const Effect& b) { return std::tie(a.fault, a.region) < std::tie(b.fault, b.region); });
  return said;
}

}  // namespace

Conductor::Conductor(const World& world, Players& players, std::function<void(const TickRecord&)> observe)
    : world_(world),
      players_(players),
      observe_(std::move(observe)),
      bounds_(bounds_of(world)),
      installed_(world.city.points()),
      shape_{world.seed, world.city.size(), players.regions_per_process()},
      roads_(draw_fleet(world)) {}

const Tick& Conductor::begin_tick() {
  now_ = {};
  now_.faults = hear_faults(next_);
  Attendance present = attendance(now_.faults.effects, shape_, next_, world_.clock.plan_due(next_));
  take_away(present.away);
  call(present.absent);
  now_.tick = announce(now_.faults, present);
  now_.seen = std::move(present.seen);
  return now_.tick;
}

void Conductor::end_tick(Exchange said) {
  now_.exchange = std::move(said);
  check_and_move(now_.tick, now_.exchange);
  open_.push_back(std::move(now_));
  ++next_;
  show();
}

void Conductor::end_day() {
  take_away({});
  call({});
  if (!open_.empty()) {
    throw run_failed("tick " + std::to_string(open_.front().tick.tick) +
                     ": not every region has said what became of it");
  }
}

Faults Conductor::hear_faults(int tick) {
  if (tick == injector_back_) {
    Absences others = away_;
    others.erase("faults");
    take_away(others);
  }
  Faults said = tick < injector_back_ ? heard_ : players_.faults(tick);
  said.tick = tick;
  refuse_garbage(said, bounds_, "the injector");
  const auto own = std::find_if(said.effects.begin(), said.effects.end(), [](const Effect& effect) {
    return family_of(effect.type) == FaultFamily::process && effect.process == ProcessRole::injector;
  });
  if (own != said.effects.end() && own->type == EffectType::process_slow) {
    return own->magnitude > report_deadline ? with(heard_, *own, said) : said;
  }
  if (own != said.effects.end() && tick >= injector_back_) {
    injector_back_ = tick + static_cast<int>(std::lround(own->magnitude));
  }
  heard_ = said;
  return said;
}

void Conductor::take_away(const Absences& away) {
  if (away != away_) {
    players_.take_away(away);
    away_ = away;
  }
}

void Conductor::call(const std::set<int>& absent) {
  std::set<int> back;
  std::set_difference(absent_.begin(), absent_.end(), absent.begin(), absent.end(), std::inserter(back, back.end()));
  absent_ = absent;
  for (TickRecord& record : open_) {
    Tick missed = record.tick;
    missed.due.clear();
    std::set<int> heard;
    for (const auto& said : record.exchange.departures) {
      heard.insert(said.region);
    }
    std::set_difference(back.begin(), back.end(), heard.begin(), heard.end(), std::back_inserter(missed.due));
    if (missed.due.empty()) {
      continue;
    }
    missed.unattended = true;
    Exchange said = players_.play(missed);
    check_and_move(missed, said);
    auto& all = record.exchange.departures;
    all.insert(all.end(), said.departures.begin(), said.departures.end());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.region < b.region; });
    auto& incidents = record.exchange.incidents;
    incidents.insert(incidents.end(), said.incidents.begin(), said.incidents.end());
  }
  show();
}

Tick Conductor::announce(const Faults& faults, const Attendance& present) {
  Tick tick;
  tick.tick = faults.tick;
  const bool plan_time = world_.clock.plan_due(tick.tick);
  tick.plan_due = plan_time && present.coordinator();
  for (int region = 0; region < world_.city.size(); ++region) {
    if (!present.absent.contains(region)) {
      tick.due.push_back(region);
      if (tick.plan_due && present.unheard.contains(region)) {
        tick.unheard.push_back(region);
      }
      if (plan_time && (!tick.plan_due || present.unplanned.contains(region))) {
        tick.unplanned.push_back(region);
      }
    }
  }
  const DayClock& clock = world_.clock;
  tick.arrivals = roads_.hand_out(clock.minute_of(tick.tick + 1), clock.minute_of(tick.tick), present.absent);
  tick.under_way = roads_.under_way();
  tick.effects = faults.effects;
  return tick;
}

void Conductor::check_and_move(const Tick& tick, const Exchange& exchange) {
  check_complete(tick, exchange);
  for (const auto& departures : exchange.departures) {
    refuse_garbage(departures, bounds_, "region " + std::to_string(departures.region));
    check_observed(world_, tick, departures);
    roads_.take(departures, world_.clock.minute_of(tick.tick + 1));
  }
  for (const auto& departures : exchange.departures) {
    check_vehicles_and_points(world_, installed_, roads_, departures);
  }
  for (const auto& report : exchange.reports) {
    refuse_garbage(report, bounds_, "region " + std::to_string(report.region));
  }
  if (exchange.plan) {
    refuse_garbage(*exchange.plan, bounds_, "the coordinator");
    check_plan(world_, tick, *exchange.plan, exchange.reports);
  }
}

void Conductor::show() {
  while (!open_.empty() && open_.front().exchange.departures.size() == world_.city.regions.size()) {
    observe_(open_.front());
    open_.pop_front();
  }
}

}  // namespace evbal
