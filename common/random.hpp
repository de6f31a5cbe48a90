#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace evbal {

/// What a random stream is for. Values are part of every recorded result: append, never renumber.
enum class Purpose : std::uint32_t {
  passenger = 1,           ///< minute, patience of a passenger
  poisson_demand = 2,      ///< number of passengers of an origin-destination pair
  extra_passenger = 3,     ///< passengers that a demand fault adds
  fleet = 4,               ///< start region and charge of a vehicle
  session = 5,             ///< length of a charging session
  fault = 6,               ///< times, targets and magnitudes of a fault schedule
  bootstrap = 7,           ///< resampling of residuals
  synthetic_city = 8,      ///< generated cities
  demand_sample = 9,       ///< samples of the demand that a controller plans for
  added_passenger = 10,    ///< passengers whom a demand fault adds by the hour
  shifted_passenger = 11,  ///< who is redirected by a demand fault
  breakdown = 12,          ///< which vehicle breaks down
  sensor = 13,             ///< what a sensor says that does not measure
  resampled_day = 14,      ///< days drawn for an interval
  lost_sample = 15,        ///< what the network loses
  trip_end = 16,           ///< places of trip ends that are known by zone only
  lost_packet = 17,        ///< what the network loses below the middleware
  thinned_count = 18,      ///< which of the trips on record a pack takes
  ingested_day = 19,       ///< trips of a day, where records have means only
  verified_day = 20,       ///< days of a study that are played again
  session_start = 21,      ///< which charging sessions do not start
};

/// The place of a draw: who draws, when, and for which of several like things.
struct StreamKey {
  std::uint64_t region = 0;  ///< that it is drawn for
  std::uint64_t tick = 0;    ///< that it is drawn in
  std::uint64_t index = 0;   ///< among the draws of one region and tick
};

/// Counter-based random stream (Philox 4x64, Random123) keyed by (seed, purpose, region, tick, index).
/// Two streams with different keys are independent; equal keys give equal draws on every machine and in
/// every process, so no stream is ever shared. Distributions are written from the bits.
class RandomStream {
 public:
  /// Equal arguments give equal numbers.
  RandomStream(std::uint64_t seed, Purpose purpose, StreamKey key);

  /// The next 64 random bits.
  std::uint64_t bits();

  /// Uniform on [0, 1), 53 bits.
  double uniform();

  /// Uniform on [low, high).
  double uniform(double low, double high);

  /// Uniform on 0..n-1, n >= 1, without bias.
  std::uint64_t below(std::uint64_t n);

  /// Standard normal (Box-Muller, one of the pair).
  double normal();

  /// Exponential with the given mean > 0.
  double exponential(double mean);

  /// Poisson with mean in [0, 1e6], by inversion in blocks.
  std::uint64_t poisson(double mean);

  /// Index drawn with probability proportional to non-negative `weights`, of which one at least is positive.
  std::size_t weighted(std::span<const double> weights);

 private:
  std::array<std::uint64_t, 2> key_;
  std::array<std::uint64_t, 4> counter_;
  std::array<std::uint64_t, 4> block_{};
  unsigned used_ = 4;
};

}  // namespace evbal
