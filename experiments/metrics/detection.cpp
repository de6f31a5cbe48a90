#include "experiments/metrics/detection.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace evbal {
namespace {

constexpr int aftermath = 60;        ///< minutes after a lie in which its region's flags are no false alarms
constexpr int an_hour = 60;          ///< minutes
constexpr double a_large_lie = 5.0;  ///< cars or passengers

/// What one sensor fault does to one region.
struct LieWindow {
  int region = 0;
  ReportField field = ReportField::none;
  std::optional<int> first_false{};  ///< tick of the first report that it falsifies
  int last = 0;                      ///< tick in which it acts
  bool large = false;                ///< whether it becomes so within an hour
};

/// By how much it falsified a report.
double falsified_by(const TickRecord& record, const Effect& effect) {
  double amount = 0.0;
  for (const Departures& said : record.exchange.departures) {
    for (const Observed& seen : said.observed) {
      amount += said.region == effect.region && seen.fault == effect.fault ? seen.amount : 0.0;
    }
  }
  return amount;
}

std::vector<LieWindow> lies_of(const DayClock& clock, std::span<const TickRecord> ticks) {
  std::map<std::pair<int, int>, LieWindow> windows;  // by fault and region
  for (const TickRecord& record : ticks) {
    for (const Effect& effect : record.faults.effects) {
      if (family_of(effect.type) != FaultFamily::sensor) {
        continue;
      }
      LieWindow& window = windows[{effect.fault, effect.region}];
      window.region = effect.region;
      window.field = effect.field;
      window.last = record.tick.tick;
      const double amount = falsified_by(record, effect);
      if (!window.first_false && amount != 0.0) {
        window.first_false = record.tick.tick;
      }
      const int since =
          window.first_false ? clock.minute_of(record.tick.tick) - clock.minute_of(*window.first_false) : 0;
      window.large = window.large || (since <= an_hour && std::abs(amount) >= a_large_lie);
    }
  }
  std::vector<LieWindow> lies;
  lies.reserve(windows.size());
  for (const auto& [which, window] : windows) {
    lies.push_back(window);
  }
  return lies;
}

/// Ticks of plans that flag a field of a region, ascending.
using Flagged = std::map<std::pair<int, ReportField>, std::vector<int>>;

Flagged flags_of(std::span<const TickRecord> ticks) {
  Flagged flagged;
  for (const TickRecord& record : ticks) {
    if (record.exchange.plan) {
      for (const SensorFlag& flag : record.exchange.plan->provenance.flags) {
        flagged[{flag.region, flag.field}].push_back(record.tick.tick);
      }
    }
  }
  return flagged;
}

/// Minutes from a lie's first false report until a plan flags this field.
std::optional<int> minutes_until(const std::vector<int>& flagged, const LieWindow& lie, const DayClock& clock) {
  const auto first = std::ranges::lower_bound(flagged, *lie.first_false);
  return first == flagged.end() || *first > lie.last
             ? std::nullopt
             : std::optional(clock.minute_of(*first) - clock.minute_of(*lie.first_false));
}

void judge(const LieWindow& lie, const Flagged& flagged, const DayClock& clock, Detection& sum) {
  std::optional<int> seen;
  for (const auto& [what, at] : flagged) {
    const auto minutes = what.first == lie.region ? minutes_until(at, lie, clock) : std::nullopt;
    if (minutes) {
      seen = std::min(seen.value_or(*minutes), *minutes);
    }
    if (minutes && what.second == lie.field) {
      ++sum.found;
      sum.found_30 += *minutes <= 30 ? 1 : 0;
      sum.found_60 += *minutes <= an_hour ? 1 : 0;
      sum.large_found_60 += lie.large && *minutes <= an_hour ? 1 : 0;
      sum.minutes += *minutes;
    }
  }
  ++sum.lies;
  sum.large += lie.large ? 1 : 0;
  sum.seen_60 += seen && *seen <= an_hour ? 1 : 0;
}

}  // namespace

Detection detection(const DayClock& clock, std::span<const TickRecord> ticks) {
  const std::vector<LieWindow> lies = lies_of(clock, ticks);
  const Flagged flagged = flags_of(ticks);
  Detection sum;
  for (const LieWindow& lie : lies) {
    if (lie.first_false) {
      judge(lie, flagged, clock, sum);
    }
  }
  for (const auto& [what, at] : flagged) {
    const int region = what.first;
    int before = -clock.plan_every;
    for (const int tick : at) {
      const int minute = clock.minute_of(tick);
      const bool begins = minute - before > clock.plan_every;
      const bool explained = std::ranges::any_of(lies, [&](const LieWindow& lie) {
        return lie.region == region && lie.first_false && *lie.first_false <= tick &&
               minute <= clock.minute_of(lie.last) + aftermath;
      });
      sum.false_alarms += begins && !explained ? 1 : 0;
      before = minute;
    }
  }
  return sum;
}

}  // namespace evbal
