#include "experiments/search/moves.hpp"

#include "faults/schedule/draw.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

/// A value near to `now` or far from it, within `likely`; often one of its ends.
double varied(Range likely, double now, RandomStream& stream) {
  const double reach = 0.5 * (likely.high - likely.low) * stream.uniform();
  return std::clamp(now + reach * stream.normal(), likely.low, likely.high);
}

int varied_minutes(Range likely, int now, RandomStream& stream) {
  return static_cast<int>(std::lround(varied(likely, now, stream)));
}

/// Changes one fault of an entry, within what the entry leaves open.
class Variation {
 public:
  Variation(const Ingredients& ingredients, Pick& pick, RandomStream& stream)
      : context_(ingredients.context), request_(ingredients.entries[pick.entry]), fault_(pick.fault), stream_(stream) {}

  void start() {
    const Range hours = request_.start ? request_.start->likely()
                                       : Range{static_cast<double>(request_.arrivals.from),
                                               static_cast<double>(request_.arrivals.to - 1)};
    const int midnight = context_.clock.start;
    fault_.start = varied_minutes(hours, fault_.start + midnight, stream_) - midnight;
  }

  void duration() {
    fault_.duration = std::max(1, varied_minutes(request_.duration.likely(), fault_.duration, stream_));
    fault_.ramp = std::min(fault_.ramp, fault_.duration / 2);
  }

  void magnitude() { set_magnitudes(varied(request_.magnitude.quantity.likely(), drawn_magnitude(), stream_)); }

  /// Another number of regions, or one region in place of another.
  void regions() {
    const Target& target = request_.target;
    if (!target.pick) {
      return;
    }
    const double drawn = drawn_magnitude();
    const double of = target.share ? static_cast<double>(target.candidates.size()) : 1.0;
    const Range likely = target.pick->likely();
    const double now = static_cast<double>(fault_.regions.size());
    const long count = std::lround(varied({likely.low * of, likely.high * of}, now, stream_));
    const std::size_t wanted = static_cast<std::size_t>(std::max(1L, count));
    if (wanted == fault_.regions.size()) {
      drop_region();
    }
    while (fault_.regions.size() > wanted) {
      drop_region();
    }
    while (fault_.regions.size() < wanted) {
      add_region();
    }
    std::sort(fault_.regions.begin(), fault_.regions.end());
    set_magnitudes(drawn);
  }

 private:
  /// What was drawn for the magnitude, or would have been: the first region's tells.
  double drawn_magnitude() const {
    const double first = fault_.magnitudes.front();
    return request_.magnitude.fraction ? first / context_.points_per_region[fault_.regions.front()] : first;
  }

  void set_magnitudes(double drawn) {
    fault_.magnitudes.clear();
    for (const int region : fault_.regions) {
      fault_.magnitudes.push_back(magnitude_in(request_, context_, region, drawn));
    }
  }

  void drop_region() {
    fault_.regions.erase(fault_.regions.begin() + static_cast<std::ptrdiff_t>(stream_.below(fault_.regions.size())));
  }

  /// One that is not there yet; there is one, as no target asks for more than its candidates.
  void add_region() {
    std::vector<int> others;
    for (const int region : request_.target.candidates) {
      if (std::find(fault_.regions.begin(), fault_.regions.end(), region) == fault_.regions.end()) {
        others.push_back(region);
      }
    }
    fault_.regions.push_back(others[stream_.below(others.size())]);
  }

  const FaultContext& context_;
  const Request& request_;
  Fault& fault_;
  RandomStream& stream_;
};

/// A drawn fault of any entry; nothing if the draw has none.
std::optional<Pick> drawn(const Ingredients& ingredients, RandomStream& stream) {
  const std::size_t entry = stream.below(ingredients.entries.size());
  const std::vector<Fault> faults =
      draw_faults(ingredients.entries[entry], ingredients.context, {ingredients.seed, stream.bits()});
  return faults.empty() ? std::nullopt : std::optional(Pick{entry, faults[stream.below(faults.size())]});
}

/// A fault that may stand beside the others; nothing if none was found.
std::optional<Pick> another(const Ingredients& ingredients, const Picks& others, const MoveStock& stock,
                            RandomStream& stream) {
  constexpr std::uint64_t of = 4;  // times, of which only one draws anew
  const bool anew = stock.harmful.empty() || stream.below(of) == 0;
  std::optional<Pick> pick =
      anew ? drawn(ingredients, stream) : std::optional(stock.harmful[stream.below(stock.harmful.size())]);
  const bool once = pick && ingredients.entries[pick->entry].start;
  const bool there = once && std::ranges::any_of(others, [&](const Pick& other) { return other.entry == pick->entry; });
  return there ? std::nullopt : pick;
}

std::string add(const Ingredients& ingredients, Picks& picks, const MoveStock& stock, RandomStream& stream) {
  if (picks.size() < stock.most) {
    if (auto pick = another(ingredients, picks, stock, stream)) {
      picks.push_back(std::move(*pick));
    }
  }
  return "one more";
}

std::string swap(const Ingredients& ingredients, Picks& picks, std::size_t at, const MoveStock& stock,
                 RandomStream& stream) {
  const std::string change = picks[at].fault.name + ": another in its place";
  Picks others = picks;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(at));
  if (auto pick = another(ingredients, others, stock, stream)) {
    picks[at] = std::move(*pick);
  }
  return change;
}

/// Changes the schedule, perhaps to one that may not be or is the same, and says what was changed.
std::string change(const Ingredients& ingredients, Picks& picks, const MoveStock& stock, RandomStream& stream) {
  constexpr std::uint64_t kinds = 6;
  const std::uint64_t kind = stream.below(kinds);
  if (picks.empty() || kind == 0) {
    return add(ingredients, picks, stock, stream);
  }
  const std::size_t at = stream.below(picks.size());
  if (kind == 1) {
    return swap(ingredients, picks, at, stock, stream);
  }
  Variation vary(ingredients, picks[at], stream);
  const std::string name = picks[at].fault.name;
  switch (kind) {
    case 2:
      vary.start();
      return name + ": start";
    case 3:
      vary.duration();
      return name + ": duration";
    case 4:
      vary.regions();
      return name + ": regions";
    default:
      vary.magnitude();
      return name + ": magnitude";
  }
}

}  // namespace

RandomStream move_stream(const Ingredients& ingredients, std::size_t number, std::size_t attempt) {
  constexpr std::size_t index = 15;  // of 16; draws have lower ones
  return {ingredients.seed, Purpose::fault, {.region = 0, .tick = number, .index = 16 * attempt + index}};
}

std::optional<ChangedSchedule> moved(const Ingredients& ingredients, const Picks& picks, const MoveStock& stock,
                                     RandomStream& stream) {
  constexpr int attempts = 100;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Picks next = picks;
    const std::string words = change(ingredients, next, stock, stream);
    next = in_order(std::move(next), ingredients);
    if (next != picks && keeps_guard(next, ingredients)) {
      return ChangedSchedule{std::move(next), words};
    }
  }
  return std::nullopt;
}

}  // namespace evbal
