#pragma once

#include "experiments/bound/bound_front.hpp"
#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// Bounds that were computed, kept for whoever shows a run of the same day.
namespace evbal {

/// A fingerprint of all that a scenario's bound comes from: the city's pack, day, seed, clock, number of vehicles,
/// patience and faults. Controllers, prices, batteries, chargers and top-up charging are no part of it, nor how often
/// plans are made.
/// Throws Error{bad_input} if the pack cannot be read.
std::string bound_key(const Scenario& scenario);

/// Where the bound of a scenario lies in a folder of bounds: KEY/bound.csv.
std::filesystem::path bound_file(const std::filesystem::path& bounds, const std::string& key);

/// bound.csv: a row a price.
///
///     price            km a lost passenger
///     bound            price x lost + km is at least this, in km
///     tight            yes, or no: the time ran out before the bound was the best of its network
///     down_km, down_lost   what cars do at the bound; empty if it is not tight
///     up_km, up_lost       the same with arrivals rounded up; empty if it was not found
///     passengers       who can be lost
///     capacity_lost, capacity_start, capacity_end   the capacity bound and its window, in minutes of the day
std::string bound_csv(const DayBound& bound);

/// Reads bound.csv back; nothing if there is no such file. Throws Error{bad_input} with file and line if it is
/// something else.
std::optional<DayBound> read_bound(const std::filesystem::path& file);

}  // namespace evbal
