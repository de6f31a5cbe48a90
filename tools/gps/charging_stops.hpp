#pragma once

#include "agents/world/geometry.hpp"
#include "tools/gps/fixes.hpp"

#include <map>
#include <optional>
#include <vector>

namespace evbal {

/// A stay at a station that counts as charging (ChargingRule).
struct ChargingStop {
  int station = 0;        ///< position in the list of stations
  long long arrival = 0;  ///< UTC seconds: first fix within reach
  long long start = 0;    ///< first fix that stands where the vehicle stands longest; it waits from arrival to then
  long long end = 0;      ///< last fix within reach
};

/// Finds stations near a place.
class StationMap {
 public:
  /// There is one station at least.
  StationMap(const std::vector<Station>& stations, double within_m);

  /// A place in metres around the stations' centre, as the other functions take it.
  LocalPoint local(LatLon place) const { return frame_.local(place); }

  /// Stations within reach, ascending.
  std::vector<int> around(LocalPoint place) const;

  /// Metres from a station, by its position in the list.
  double metres(int station, LocalPoint place) const { return distance(places_[station], place); }

 private:
  std::pair<int, int> square_of(LocalPoint place) const;

  LocalFrame frame_;
  double within_m_;
  std::vector<LocalPoint> places_;
  std::map<std::pair<int, int>, std::vector<int>> squares_;
};

/// Finds charging stops in the fixes of one vehicle. Where several stations are in reach, it charges at the one nearest
/// to where it stands longest.
class StopFinder {
 public:
  /// `stations` must outlive this.
  StopFinder(const StationMap& stations, const ChargingRule& rule) : stations_(stations), rule_(rule) {}

  /// The fix that follows in time; gives the stops that have ended, in the order of time.
  std::vector<ChargingStop> add(const Fix& fix);

  /// The stop that lasts to the end of the records, if there is one.
  std::vector<ChargingStop> finish() { return leave(); }

  /// Since when the vehicle has been in reach of stations: what it did since then is not yet known.
  std::optional<long long> open_since() const;

 private:
  /// Fixes in a row at the same place.
  struct Stand {
    LocalPoint place;
    long long from = 0;
    long long until = 0;
  };
  /// A stay within reach of a station: stands[first .. last].
  struct Stay {
    int station = 0;
    std::size_t first = 0;
    std::size_t last = 0;
  };

  std::vector<ChargingStop> leave();
  LocalPoint longest_stand(const Stay& stay) const;
  long long charge_start(const Stay& stay, LocalPoint spot) const;
  double seconds_at(std::size_t stand, const Stay& stay) const;

  const StationMap& stations_;
  ChargingRule rule_;
  std::optional<Fix> last_;
  std::vector<Stand> stands_;  ///< since the vehicle is in reach of a station
  std::vector<Stay> open_;
  std::vector<Stay> ended_;
};

}  // namespace evbal
