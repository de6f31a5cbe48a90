#include "experiments/conductor/attendance.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <string>

namespace evbal {
namespace {

/// Gathers the attendance effect by effect.
class Roll {
 public:
  Roll(const RunShape& run, int tick, bool plan_due) : run_(run), tick_(tick), plan_due_(plan_due) {}

  void add(const Effect& effect) {
    switch (effect.type) {
      case EffectType::process_kill:
      case EffectType::host_down:
        take_away(effect, Absence::killed);
        break;
      case EffectType::process_pause:
        take_away(effect, Absence::paused);
        break;
      case EffectType::process_slow:
        slow_down(effect);
        break;
      case EffectType::network_drop:
        lose(effect, [&](NetworkTopic topic) { return drawn(effect, topic) < effect.magnitude; });
        break;
      case EffectType::network_delay:
        lose(effect, [&](NetworkTopic) { return effect.magnitude > report_deadline; });
        break;
      case EffectType::network_partition:
        lose(effect, [](NetworkTopic) { return true; });
        break;
      default:
        break;
    }
  }

  Attendance attendance;

 private:
  std::vector<int> hosted_with(int region) const {
    const int first = region / run_.regions_per_process * run_.regions_per_process;
    std::vector<int> regions;
    for (int i = first; i < std::min(first + run_.regions_per_process, run_.regions); ++i) {
      regions.push_back(i);
    }
    return regions;
  }

  void take_away(const Effect& effect, Absence how) {
    std::string name = effect.process == ProcessRole::coordinator ? "coordinator" : "faults";
    if (effect.process == ProcessRole::agent) {
      name = "agent-" + std::to_string(effect.region / run_.regions_per_process);
      const auto regions = hosted_with(effect.region);
      attendance.absent.insert(regions.begin(), regions.end());
    }
    if (how == Absence::killed) {
      attendance.away[name] = how;
    } else {
      attendance.away.emplace(name, how);
    }
    see(effect, 1.0);
  }

  void slow_down(const Effect& effect) {
    if (!plan_due_ || effect.magnitude <= report_deadline || effect.process == ProcessRole::injector) {
      see(effect, 0.0);
      return;
    }
    if (effect.process == ProcessRole::coordinator) {
      for (int region = 0; region < run_.regions; ++region) {
        attendance.unplanned.insert(region);
      }
      see(effect, 1.0);
      return;
    }
    const auto regions = hosted_with(effect.region);
    attendance.unheard.insert(regions.begin(), regions.end());
    attendance.unplanned.insert(regions.begin(), regions.end());
    see(effect, static_cast<double>(regions.size()));
  }

  template <class IsLost>
  void lose(const Effect& effect, IsLost is_lost) {
    const bool report = plan_due_ && effect.topic != NetworkTopic::plan && is_lost(NetworkTopic::report);
    const bool plan = plan_due_ && effect.topic != NetworkTopic::report && is_lost(NetworkTopic::plan);
    if (report) {
      attendance.unheard.insert(effect.region);
    }
    if (plan) {
      attendance.unplanned.insert(effect.region);
    }
    see(effect, (report ? 1.0 : 0.0) + (plan ? 1.0 : 0.0));
  }

  double drawn(const Effect& effect, NetworkTopic topic) const {
    const auto number = [](auto value) { return static_cast<std::uint64_t>(value); };
    return RandomStream(run_.seed, Purpose::lost_sample,
                        {.region = number(effect.region),
                         .tick = number(tick_),
                         .index = (number(effect.fault) << 8U) + number(topic)})
        .uniform();
  }

  void see(const Effect& effect, double amount) {
    attendance.seen.push_back({effect.region, {.fault = effect.fault, .amount = amount}});
  }

  RunShape run_;
  int tick_;
  bool plan_due_;
};

}  // namespace

Attendance attendance(const std::vector<Effect>& effects, const RunShape& run, int tick, bool plan_due) {
  Roll roll(run, tick, plan_due);
  for (const Effect& effect : effects) {
    roll.add(effect);
  }
  return std::move(roll.attendance);
}

}  // namespace evbal
