#include "experiments/search/shrink.hpp"

#include "faults/schedule/fault_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace evbal {
namespace {

/// A part of a fault that may be taken away.
struct Cut {
  enum class Part { region, end, start, magnitude };

  std::size_t pick = 0;      ///< position of the fault
  Part part = Part::region;  ///< what is taken away
  int region = 0;            ///< which, of regions
};

/// What is taken away at a time: whole regions, or such a share of minutes and magnitudes.
struct Level {
  bool regions = false;
  double share = 0.0;
};

constexpr std::array<Level, 4> levels{{{true, 0.0}, {false, 0.5}, {false, 0.25}, {false, 0.125}}};

/// Whole ticks, at least one; 0 if not even one would be left.
int minutes_to_cut(const Fault& fault, double share, int tick) {
  const int minutes = tick * std::max(1, static_cast<int>(fault.duration * share / tick));
  return fault.duration - minutes >= tick ? minutes : 0;
}

void cut_end(Fault& fault, double share, int tick) {
  fault.duration -= minutes_to_cut(fault, share, tick);
  fault.ramp = std::min(fault.ramp, fault.duration / 2);
}

/// Not beyond the day's end, where faults may still last.
void cut_start(Fault& fault, double share, const DayClock& clock) {
  const int minutes = minutes_to_cut(fault, share, clock.tick);
  if (fault.start + minutes < clock.minutes()) {
    fault.start += minutes;
    fault.duration -= minutes;
    fault.ramp = std::min(fault.ramp, fault.duration / 2);
  }
}

/// A number closer to what changes nothing by this share, but not there: for that the region goes. At least by a
/// twentieth of the farthest that its entry likely gives, so that it comes to an end.
double closer(double number, double share, const Request& request) {
  constexpr double least = 0.05;
  constexpr double digits = 100.0;
  const double neutral = request.type->neutral;
  const Range likely = request.magnitude.quantity.likely();
  const double farthest = std::max(std::abs(likely.low - neutral), std::abs(likely.high - neutral));
  const double distance = std::abs(number - neutral);
  const double left = distance - std::max(share * distance, least * farthest);
  const double rounded = std::round((number > neutral ? neutral + left : neutral - left) * digits) / digits;
  return left > 0.0 && std::abs(rounded - neutral) < distance ? rounded : number;
}

/// Fewer iterations of a solver are no less of a fault: they stay.
void cut_magnitude(Fault& fault, double share, const Request& request) {
  if (request.type->unit == MagnitudeUnit::none || fault.type == EffectType::solver_starve) {
    return;
  }
  for (double& magnitude : fault.magnitudes) {
    magnitude = request.type->unit == MagnitudeUnit::number
                    ? closer(magnitude, share, request)
                    : std::max(1.0, magnitude - std::max(1.0, std::floor(magnitude * share)));
  }
}

void cut_region(Fault& fault, int region) {
  const auto at = std::find(fault.regions.begin(), fault.regions.end(), region);
  fault.magnitudes.erase(fault.magnitudes.begin() + (at - fault.regions.begin()));
  fault.regions.erase(at);
}

Picks without(Picks picks, const std::vector<Cut>& cuts, double share, const Ingredients& ingredients) {
  const DayClock& clock = ingredients.context.clock;
  for (const Cut& cut : cuts) {
    Fault& fault = picks[cut.pick].fault;
    switch (cut.part) {
      case Cut::Part::region:
        cut_region(fault, cut.region);
        break;
      case Cut::Part::end:
        cut_end(fault, share, clock.tick);
        break;
      case Cut::Part::start:
        cut_start(fault, share, clock);
        break;
      case Cut::Part::magnitude:
        cut_magnitude(fault, share, ingredients.entries[picks[cut.pick].entry]);
        break;
    }
  }
  std::erase_if(picks, [](const Pick& pick) { return pick.fault.regions.empty(); });
  return in_order(std::move(picks), ingredients);
}

std::vector<Cut> cuts_of(const Picks& picks, const Level& level) {
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < picks.size(); ++i) {
    if (level.regions) {
      for (const int region : picks[i].fault.regions) {
        cuts.push_back({i, Cut::Part::region, region});
      }
    } else {
      cuts.push_back({i, Cut::Part::end});
      cuts.push_back({i, Cut::Part::start});
      cuts.push_back({i, Cut::Part::magnitude});
    }
  }
  return cuts;
}

std::string words_of(const std::vector<Cut>& cuts, const Picks& picks) {
  static const std::array<const char*, 4> parts = {"region ", "end", "start", "magnitude"};
  std::string text;
  for (const Cut& cut : cuts) {
    text += (text.empty() ? "" : "; ") + picks[cut.pick].fault.name + ": less " +
            parts[static_cast<std::size_t>(cut.part)] +
            (cut.part == Cut::Part::region ? std::to_string(cut.region) : "");
  }
  return text;
}

/// A schedule that becomes smaller.
class Shrinking {
 public:
  Shrinking(const Ingredients& ingredients, Trial found, const std::function<bool(double)>& enough, const Harms& harms,
            std::vector<Trial>& trials)
      : ingredients_(ingredients), now_(std::move(found)), enough_(enough), harms_(harms), trials_(trials) {}

  /// Takes away what can go at one level; whether anything could.
  bool take_away(const Level& level) {
    std::vector<std::vector<Cut>> single;
    for (const Cut& cut : cuts_of(now_.picks, level)) {
      single.push_back({cut});
    }
    std::vector<std::pair<double, Cut>> harmless;
    const std::vector<Trial> alone = tried(single, level.share);
    for (std::size_t i = 0; i < alone.size(); ++i) {
      if (alone[i].picks != now_.picks && enough_(alone[i].harm)) {
        harmless.emplace_back(alone[i].harm, single[i].front());
      }
    }
    if (harmless.empty()) {
      return false;
    }
    std::stable_sort(harmless.begin(), harmless.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    now_ = largest_of(groups_of(harmless), level.share);
    return true;
  }

  const Trial& now() const { return now_; }

 private:
  /// The first of all, half of them, a quarter, ... and the first alone.
  static std::vector<std::vector<Cut>> groups_of(const std::vector<std::pair<double, Cut>>& cuts) {
    std::vector<std::vector<Cut>> groups;
    for (std::size_t size = cuts.size(); size > 0; size /= 2) {
      groups.emplace_back();
      for (std::size_t i = 0; i < size; ++i) {
        groups.back().push_back(cuts[i].second);
      }
    }
    return groups;
  }

  /// Without the largest group that can go; the last one can.
  Trial largest_of(const std::vector<std::vector<Cut>>& groups, double share) {
    const std::vector<Trial> together = tried(groups, share);
    return *std::find_if(together.begin(), together.end(), [&](const Trial& trial) { return enough_(trial.harm); });
  }

  /// What is left without each of these; known schedules are not tried again.
  std::vector<Trial> tried(const std::vector<std::vector<Cut>>& groups, double share) {
    std::vector<Trial> results;
    std::vector<Trial> unknown;
    for (const auto& cuts : groups) {
      results.push_back({.stage = "shrink",
                         .parent = now_.number,
                         .change = words_of(cuts, now_.picks),
                         .picks = without(now_.picks, cuts, share, ingredients_)});
      if (find(trials_, results.back().picks) == nullptr && find(unknown, results.back().picks) == nullptr) {
        unknown.push_back(results.back());
        unknown.back().number = trials_.size() + unknown.size();
      }
    }
    if (!unknown.empty()) {
      const std::vector<double> harm = harms_(unknown);
      for (std::size_t i = 0; i < unknown.size(); ++i) {
        unknown[i].harm = harm[i];
      }
      trials_.insert(trials_.end(), unknown.begin(), unknown.end());
    }
    for (auto& result : results) {
      result = *find(trials_, result.picks);
    }
    return results;
  }

  static const Trial* find(const std::vector<Trial>& trials, const Picks& picks) {
    const auto at = std::find_if(trials.begin(), trials.end(), [&](const Trial& t) { return t.picks == picks; });
    return at == trials.end() ? nullptr : &*at;
  }

  const Ingredients& ingredients_;
  Trial now_;
  const std::function<bool(double)>& enough_;
  const Harms& harms_;
  std::vector<Trial>& trials_;
};

}  // namespace

Trial shrink(const Ingredients& ingredients, const Trial& found, const std::function<bool(double)>& enough,
             const Harms& harms, std::vector<Trial>& trials) {
  Shrinking shrinking(ingredients, found, enough, harms, trials);
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const Level& level : levels) {
      while (shrinking.take_away(level)) {
        smaller = true;
      }
    }
  }
  return shrinking.now();
}

}  // namespace evbal
