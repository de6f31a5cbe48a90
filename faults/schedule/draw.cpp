#include "faults/schedule/draw.hpp"

#include "common/random.hpp"
#include "faults/schedule/guard.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evbal {
namespace {

/// The fields that may be drawn. Values key streams: append, never renumber.
enum class Field : std::uint64_t { target, start, duration, ramp, magnitude };

/// Streams of one repetition of one fault.
class Draws {
 public:
  Draws(const DrawKey& key, const std::string& name, std::uint64_t repetition)
      : key_(key), name_(name_hash(name)), repetition_(repetition) {}

  RandomStream stream(Field field) const {
    constexpr std::uint64_t fields = 16;
    return {key_.seed,
            Purpose::fault,
            {.region = name_, .tick = key_.run, .index = repetition_ * fields + static_cast<std::uint64_t>(field)}};
  }

  double operator()(const Quantity& quantity, Field field) const {
    auto from = stream(field);
    return quantity.draw(from);
  }

  int whole(const Quantity& quantity, Field field) const {
    return static_cast<int>(std::lround((*this)(quantity, field)));
  }

 private:
  /// FNV-1a, 64 bits.
  static std::uint64_t name_hash(const std::string& name) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : name) {
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
    return hash;
  }

  DrawKey key_;
  std::uint64_t name_;
  std::uint64_t repetition_;
};

std::vector<int> draw_regions(const Target& target, const Draws& draws) {
  if (!target.pick) {
    return target.candidates;
  }
  auto stream = draws.stream(Field::target);
  std::vector<int> regions = target.candidates;
  const double drawn = target.pick->draw(stream) * (target.share ? static_cast<double>(regions.size()) : 1.0);
  const auto count = static_cast<std::size_t>(std::max(1L, std::lround(drawn)));
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(regions[i], regions[i + stream.below(regions.size() - i)]);
  }
  regions.resize(count);
  std::sort(regions.begin(), regions.end());
  return regions;
}

std::vector<double> draw_magnitudes(const Request& request, const std::vector<int>& regions,
                                    const FaultContext& context, const Draws& draws) {
  const double drawn = draws(request.magnitude.quantity, Field::magnitude);
  std::vector<double> magnitudes;
  magnitudes.reserve(regions.size());
  for (const int region : regions) {
    magnitudes.push_back(magnitude_in(request, context, region, drawn));
  }
  return magnitudes;
}

/// Minutes after midnight at which the fault strikes.
std::vector<int> draw_starts(const Request& request, const DrawKey& key) {
  const Draws draws(key, request.name, 0);
  if (request.start) {
    return {draws.whole(*request.start, Field::start)};
  }
  std::vector<int> starts;
  auto stream = draws.stream(Field::start);
  const double mean_gap = 60.0 / request.arrivals.per_hour;
  double at = request.arrivals.from + stream.exponential(mean_gap);
  while (at < request.arrivals.to) {
    starts.push_back(static_cast<int>(at));
    at += stream.exponential(mean_gap);
  }
  return starts;
}

Fault draw_fault(const Request& request, const FaultContext& context, int start, const Draws& draws) {
  Fault fault;
  fault.name = request.name;
  fault.type = request.type->effect;
  fault.regions = draw_regions(request.target, draws);
  fault.magnitudes = draw_magnitudes(request, fault.regions, context, draws);
  fault.start = start - context.clock.start;
  fault.duration = draws.whole(request.duration, Field::duration);
  fault.ramp = std::min(draws.whole(request.ramp, Field::ramp), fault.duration / 2);
  fault.on_start = request.on_start;
  fault.visible = request.visible;
  fault.to = request.to;
  fault.field = request.target.field;
  fault.process = request.target.process;
  fault.topic = request.target.topic;
  return fault;
}

}  // namespace

double magnitude_in(const Request& request, const FaultContext& context, int region, double drawn) {
  const FaultType& type = *request.type;
  if (!type.counts_points()) {
    return type.unit == MagnitudeUnit::number ? drawn : std::round(drawn);
  }
  const double points = context.points_per_region[region];
  return std::clamp(std::round(request.magnitude.fraction ? drawn * points : drawn), 1.0, points);
}

std::vector<Fault> draw_faults(const Request& request, const FaultContext& context, const DrawKey& key) {
  std::vector<Fault> faults;
  std::uint64_t repetition = 0;
  for (const int start : draw_starts(request, key)) {
    Fault fault = draw_fault(request, context, start, Draws(key, request.name, repetition++));
    if (!request.start) {
      fault.name.append("-").append(std::to_string(repetition));
    }
    const bool broken_already = std::any_of(faults.begin(), faults.end(), [&](const Fault& earlier) {
      return overlap(earlier, fault, context.clock).has_value();
    });
    if (!broken_already) {
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

}  // namespace evbal
