#pragma once

#include "tools/ingest/travel.hpp"
#include "tools/ingest/zones.hpp"
#include "tools/records/raw_table.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// How a table of single trips between zones is laid out, and which of its trips count (docs/ingest.md).
struct SampleFormat {
  TableFormat table;               ///< separator, header and columns
  std::vector<std::size_t> start;  ///< columns that tell together when the trip starts, as clocks show it
  std::vector<std::size_t> end;    ///< and when it ends
  std::string pattern;             ///< of both times, as time_like takes it
  std::size_t from = 0;            ///< column, zone
  std::size_t to = 0;              ///< column, zone
  std::size_t distance = 0;        ///< column, driven distance
  double km = 1.0;                 ///< of one unit of it
  double shortest = 1.0;           ///< minutes; shorter trips are dropped
  double longest = 120.0;          ///< minutes; longer trips are dropped
  double fastest_kmh = 120.0;      ///< faster trips are dropped
};

/// One hour of the day, against all.
struct HourOfTravel {
  int trips = 0;        ///< of the sample that start in it
  double pace = 1.0;    ///< minutes of a trip, over those of the law at its km
  double detour = 1.0;  ///< driven over straight km
};

/// How a city is driven through, fitted to single trips.
struct TravelSample {
  TravelLaw law;                       ///< of all trips: minutes by driven km
  double detour = 1.0;                 ///< of all trips: driven over straight km
  std::array<HourOfTravel, 24> hours;  ///< drawn towards all trips as if by 50 more
  std::string report;                  ///< what was read, dropped and fitted; one item a line
};

/// Reads a table and fits travel to it: minutes by least squares, the detour as the ratio of sums. `straight_km` tells
/// the distance that is expected between two zones. Throws Error{bad_input} with what was dropped, also with fewer than
/// a hundred trips.
TravelSample fit_travel(const std::filesystem::path& table, const SampleFormat& format, const std::vector<Zone>& zones,
                        const std::function<double(int from, int to)>& straight_km);

}  // namespace evbal
