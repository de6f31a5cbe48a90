#pragma once

#include "coordinator/ambiguity/residual_distribution.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/forecast/seasonal.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// What is known of a series of counts per region: how to forecast it, and how wrong that is.
struct SeriesModel {
  SeasonalModel seasonal;       ///< the forecasts
  ResidualDistribution errors;  ///< the laws of their errors
};

/// Transitions from `start` (minute after midnight) until the next period.
struct Period {
  int start = 0;            ///< minute after midnight
  Transitions transitions;  ///< from then on
};

/// Of the trips that start in a region, the share that ends in another, or in the same.
struct TripShare {
  int origin = 0;       ///< region
  int destination = 0;  ///< region
  double share = 0.0;   ///< of the origin's trips, above 0; over all destinations they sum to one
};

/// Where trips go that start from `start` (minute after midnight) until the next period.
struct TripPeriod {
  int start = 0;                  ///< minute after midnight
  std::vector<TripShare> shares;  ///< by (origin, destination), each pair at most once
};

/// Everything that `evbal fit` estimates of a city (docs/model.md, sections 2 and 5).
struct CityModel {
  std::string city;                   ///< name of the pack that it was fitted to
  int day_start = 0;                  ///< minute after midnight at which the seasonal means start
  int step_minutes = 30;              ///< Delta
  std::vector<std::string> holidays;  ///< ISO dates on record that are like Sundays, ascending
  SeriesModel demand;                 ///< of r
  SeriesModel completions;            ///< of c
  std::vector<Period> periods;        ///< at least one, by start
  std::vector<TripPeriod> trips;      ///< at least one, by start
  /// By DayKind, N x steps: what one more vacant car in a region at the start of a step is worth until the day's end,
  /// in km of empty driving (docs/fit.md); 0 x 0 each if it was not computed.
  std::array<Eigen::MatrixXd, day_kinds> car_values;
  Turnover turnover;                  ///< of vehicles that serve twice in a step
  double mean_session_minutes = 0.0;  ///< of charging

  /// Number of regions.
  int regions() const { return demand.seasonal.regions(); }

  /// Of the day, from `day_start` on.
  int steps() const { return static_cast<int>(demand.seasonal.mean[0].cols()); }

  /// Steps that can be forecast at most.
  int leads() const { return demand.errors.leads(); }

  /// Of a date, ISO 8601.
  DayKind kind(const std::string& date) const;

  /// Those of the period that holds `minute` after midnight; the first period's before it starts.
  const Transitions& transitions_at(int minute) const;

  /// Likewise where the trips go that start then.
  const std::vector<TripShare>& trips_at(int minute) const;

  /// What a vacant car is worth in a region at `minute` after midnight, between the starts of two steps along a line: 0
  /// from the end of the day on, and at any time in a model without values.
  double car_value(DayKind kind, int region, double minute) const;
};

/// Reads a file that write_model wrote. Throws Error{bad_input} naming the file and the key that is missing, unknown,
/// repeated, of the wrong shape or out of range.
CityModel read_model(const std::filesystem::path& file);

/// Writes JSON that read_model gives back to the last bit. The file appears whole or not at all.
void write_model(const CityModel& model, const std::filesystem::path& file);

}  // namespace evbal
