#pragma once

#include "agents/world/city.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// What ingest_od reads.
struct OdSources {
  std::filesystem::path trips;     ///< table of trips of one day between cells (OdFormat)
  std::filesystem::path zones;     ///< polygons to merge (read_zones)
  std::filesystem::path stations;  ///< table of charging stations (StationFormat)
  std::filesystem::path notes;     ///< YAML (read_od_notes)
  std::filesystem::path like;      ///< pack of a city with days on record
  int regions = 54;                ///< to merge the zones into
};

/// What ingest_od makes.
struct OdCity {
  City city;           ///< of factors
  std::string report;  ///< what was read, dropped and why; one item a line
};

/// Makes a city of trips whose time of day is not on record. Regions: zones merged by their pick-ups. Pairs: the trips
/// as they are. Days, course of the day and how much a region's pick-ups differ from day to day: those of the pack
/// `like`, and so are the lengths of charging sessions. Stations: those on record, with their share of the points.
/// Throws Error{bad_input}.
OdCity ingest_od(const OdSources& sources);

}  // namespace evbal
