#pragma once

#include "agents/world/city.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

namespace evbal {

/// Keys of city.yaml that tools which make packs read as well (docs/city-packs.md). All throw Error{bad_input} with
/// file and line.

/// `day_start` and `step`, into `city`.
void read_clock(YamlMap& map, City& city);

/// The map of `days`, into `city`.
void read_days(const YamlValue& value, City& city);

/// The map of `fleet`.
FleetAssumption read_fleet(const YamlValue& value);

/// The word of a `fleet`'s `placement`.
FleetPlacement read_placement(const YamlValue& value);

/// Writes the key `placement`, unless it is the one that is taken if nothing is said.
void write_placement(YamlWriter& yaml, FleetPlacement placement);

/// The keys `power_kw` and `session_quantiles` of a map of `charging`.
ChargingAssumption read_charging(YamlMap& map);

/// How long a passenger waits, in minutes: at most a day.
double read_patience(const YamlValue& value);

/// How long a car charges, in minutes: from one to a day's.
double read_session_minutes(const YamlValue& value);

/// The map of `passengers`.
PassengerAssumption read_passengers(const YamlValue& value);

/// The list of `stations`, whose regions are named as in `regions`.
std::vector<Station> read_stations(const YamlValue& value, const std::vector<Region>& regions);

}  // namespace evbal
