#include "experiments/search/shrink.hpp"

#include "experiments/search/moves.hpp"
#include "faults/schedule/fault_types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace evbal {
namespace {

/// What may be taken away of a fault.
enum class Part { all, region, end, start, magnitude };

/// Something that is taken away.
struct Cut {
  std::size_t pick = 0;   ///< position of the fault
  Part part = Part::all;  ///< of this fault
  int region = 0;         ///< which, of Part::region
};

/// What is taken away at a time.
struct Level {
  enum class Of { faults, regions, extent };

  Of of = Of::faults;
  double share = 0.0;  ///< of minutes and magnitudes, of Of::extent
};

constexpr Level whole_faults{Level::Of::faults};
constexpr Level whole_regions{Level::Of::regions};

/// Faults first: they get all of the harm that may be lost, so that few remain.
constexpr std::array<Level, 3> coarse{{whole_regions, {Level::Of::extent, 0.5}, {Level::Of::extent, 0.25}}};
constexpr std::array<Level, 3> fine{{whole_faults, whole_regions, {Level::Of::extent, 0.125}}};

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
  if (at != fault.regions.end()) {
    fault.magnitudes.erase(fault.magnitudes.begin() + (at - fault.regions.begin()));
    fault.regions.erase(at);
  }
}

/// Faults keep their places, also those without regions.
Picks without(Picks picks, const std::vector<Cut>& cuts, double share, const Ingredients& ingredients) {
  const DayClock& clock = ingredients.context.clock;
  for (const Cut& cut : cuts) {
    Fault& fault = picks[cut.pick].fault;
    switch (cut.part) {
      case Part::all:
        fault.regions.clear();
        break;
      case Part::region:
        cut_region(fault, cut.region);
        break;
      case Part::end:
        cut_end(fault, share, clock.tick);
        break;
      case Part::start:
        cut_start(fault, share, clock);
        break;
      case Part::magnitude:
        cut_magnitude(fault, share, ingredients.entries[picks[cut.pick].entry]);
        break;
    }
  }
  return picks;
}

Picks tidy(Picks picks, const Ingredients& ingredients) {
  std::erase_if(picks, [](const Pick& pick) { return pick.fault.regions.empty(); });
  return in_order(std::move(picks), ingredients);
}

std::vector<Cut> cuts_of(const Picks& picks, const Level& level) {
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < picks.size(); ++i) {
    switch (level.of) {
      case Level::Of::faults:
        cuts.push_back({i, Part::all});
        break;
      case Level::Of::regions:
        for (const int region : picks[i].fault.regions) {
          cuts.push_back({i, Part::region, region});
        }
        break;
      case Level::Of::extent:
        cuts.insert(cuts.end(), {{i, Part::end}, {i, Part::start}, {i, Part::magnitude}});
        break;
    }
  }
  return cuts;
}

std::vector<std::vector<Cut>> one_each(const std::vector<Cut>& cuts) {
  std::vector<std::vector<Cut>> single;
  for (const Cut& cut : cuts) {
    single.push_back({cut});
  }
  return single;
}

std::string words_of(const std::vector<Cut>& cuts, const Picks& picks) {
  static const std::array<const char*, 5> parts = {"gone", "less region ", "less end", "less start", "less magnitude"};
  std::string text;
  for (const Cut& cut : cuts) {
    text += (text.empty() ? "" : "; ") + picks[cut.pick].fault.name + ": " + parts[static_cast<std::size_t>(cut.part)] +
            (cut.part == Part::region ? std::to_string(cut.region) : "");
  }
  return text;
}

/// A schedule that becomes smaller.
class Shrinking {
 public:
  Shrinking(const Ingredients& ingredients, Trial found, const std::function<bool(double)>& enough, const Harms& harms,
            std::vector<Trial>& trials)
      : ingredients_(ingredients), now_(std::move(found)), enough_(enough), harms_(harms), trials_(trials) {}

  /// Takes away what can go at one level, more than once if need be; whether anything could.
  bool take_away(const Level& level) {
    const std::size_t before = now_.number;
    Picks picks = now_.picks;
    std::vector<Cut> cuts = cuts_of(picks, level);
    while (true) {
      const std::vector<Cut> harmless = harmless_of(cuts, picks, level.share);
      if (harmless.empty()) {
        return now_.number != before;
      }
      // Which fault is needed least changes as faults go, and few shall remain: only the best quarter at once.
      const std::size_t most = level.of == Level::Of::faults ? (harmless.size() + 3) / 4 : harmless.size();
      const std::vector<std::vector<Cut>> groups = groups_of(harmless, most);
      const std::vector<Trial> together = tried(groups, picks, level.share);
      // The last group can go: it was tried alone.
      std::size_t largest = 0;
      while (!enough_(together[largest].harm)) {
        ++largest;
      }
      picks = without(std::move(picks), groups[largest], level.share, ingredients_);
      now_ = together[largest];
      if (level.of == Level::Of::extent) {
        cuts = harmless;  // of the others, which are many, hardly one would go now
      }
    }
  }

  /// Takes the fault away that is needed least while one of the others changes; whether such a change was found.
  bool exchange() {
    if (now_.picks.size() < 2) {
      return false;
    }
    const std::vector<Trial> fewer = evaluated(changed(least_needed_away()));
    std::vector<Trial> as_bad;
    std::copy_if(fewer.begin(), fewer.end(), std::back_inserter(as_bad),
                 [&](const Trial& t) { return enough_(t.harm); });
    if (!as_bad.empty()) {
      now_ = most_harmful(as_bad);
    }
    return !as_bad.empty();
  }

  const Trial& now() const { return now_; }

 private:
  Trial least_needed_away() {
    return most_harmful(tried(one_each(cuts_of(now_.picks, whole_faults)), now_.picks, 0.0));
  }

  /// Schedules with as many faults as `trial`, made by moves as those of a search.
  std::vector<Trial> changed(const Trial& trial) const {
    constexpr std::size_t moves = 48;
    const MoveStock stock{.most = trial.picks.size(), .harmful = now_.picks};
    std::vector<Trial> results;
    for (std::size_t i = 1; i <= moves; ++i) {
      RandomStream stream = move_stream(ingredients_, trials_.size() + i, 0);
      if (auto move = moved(ingredients_, trial.picks, stock, stream)) {
        results.push_back({.stage = "shrink", .parent = trial.number, .change = move->change, .picks = move->picks});
      }
    }
    return results;
  }

  /// Those that can go alone, the least needed first.
  std::vector<Cut> harmless_of(const std::vector<Cut>& cuts, const Picks& picks, double share) {
    std::vector<std::pair<double, Cut>> harmless;
    const std::vector<Trial> alone = tried(one_each(cuts), picks, share);
    for (std::size_t i = 0; i < alone.size(); ++i) {
      if (alone[i].picks != now_.picks && enough_(alone[i].harm)) {
        harmless.emplace_back(alone[i].harm, cuts[i]);
      }
    }
    std::stable_sort(harmless.begin(), harmless.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Cut> sorted;
    for (const auto& [harm, cut] : harmless) {
      sorted.push_back(cut);
    }
    return sorted;
  }

  /// The first `most`, seven eighths of them, ... and the first alone.
  static std::vector<std::vector<Cut>> groups_of(const std::vector<Cut>& cuts, std::size_t most) {
    constexpr std::size_t steps = 8;
    std::vector<std::vector<Cut>> groups;
    for (std::size_t step = steps; step > 0; --step) {
      const std::size_t size = std::max<std::size_t>(1, most * step / steps);
      if (groups.empty() || size < groups.back().size()) {
        groups.emplace_back(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(size));
      }
    }
    return groups;
  }

  /// What is left of the faults without each of these.
  std::vector<Trial> tried(const std::vector<std::vector<Cut>>& groups, const Picks& picks, double share) {
    std::vector<Trial> results;
    for (const auto& cuts : groups) {
      results.push_back({.stage = "shrink",
                         .parent = now_.number,
                         .change = words_of(cuts, picks),
                         .picks = tidy(without(picks, cuts, share, ingredients_), ingredients_)});
    }
    return evaluated(std::move(results));
  }

  /// The schedules with their harm; known ones are not tried again.
  std::vector<Trial> evaluated(std::vector<Trial> results) {
    std::vector<Trial> unknown;
    for (const Trial& result : results) {
      if (find(trials_, result.picks) == nullptr && find(unknown, result.picks) == nullptr) {
        unknown.push_back(result);
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
  do {
    shrinking.take_away(whole_faults);
  } while (shrinking.exchange());
  for (const Level& level : coarse) {
    shrinking.take_away(level);
  }
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const Level& level : fine) {
      smaller = shrinking.take_away(level) || smaller;
    }
  }
  return shrinking.now();
}

}  // namespace evbal
