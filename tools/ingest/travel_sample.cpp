#include "tools/ingest/travel_sample.hpp"

#include "tools/ingest/time_pattern.hpp"
#include "tools/ingest/zone_places.hpp"
#include "tools/records/row_tally.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

namespace evbal {
namespace {

constexpr double kHourPrior = 50.0;        // weight of all trips against those of an hour
constexpr std::size_t kFewestTrips = 100;  // trips to fit to
constexpr double kShortestKm = 0.1;        // of a trip

struct SampleTrip {
  int hour = 0;
  double minutes = 0.0;
  double km = 0.0;
  double straight_km = 0.0;
};

class SampleReader {
 public:
  SampleReader(const SampleFormat& format, const std::vector<Zone>& zones)
      : format_(format),
        zones_(zones),
        names_(zones, format.table.decimal_comma ? ',' : '.'),
        no_time_("no time like " + time_example(format.pattern)),
        no_zone_(names_.no_zone()) {}

  /// A trip of a row with its zones, or what is wrong with it.
  RowFault read(const RawTable& row, SampleTrip& trip, int& from, int& to) {
    if (!row.whole()) {
      return row.fault();
    }
    const auto start = time_in(row, format_.start, format_.pattern, text_);
    const auto end = start ? time_in(row, format_.end, format_.pattern, text_) : std::nullopt;
    if (!end) {
      return {no_time_, text_};
    }
    for (const auto& [column, zone] : {std::pair(format_.from, &from), std::pair(format_.to, &to)}) {
      const Zone* found = names_.zone_of(row.text(column));
      if (found == nullptr) {
        return {no_zone_, row.text(column), false};
      }
      *zone = static_cast<int>(found - zones_.data());
    }
    const auto driven = row.number(format_.distance);
    if (!driven) {
      return {"no distance", row.text(format_.distance)};
    }
    trip.hour = static_cast<int>((*start % 86'400 + 86'400) % 86'400 / 3600);
    trip.minutes = static_cast<double>(*end - *start) / 60.0;
    trip.km = *driven * format_.km;
    return unlikely(row, trip);
  }

 private:
  RowFault unlikely(const RawTable& row, const SampleTrip& trip) const {
    if (trip.minutes < format_.shortest || trip.minutes > format_.longest) {
      return {trip.minutes < format_.shortest ? "too short in time" : "too long in time", row.text(format_.end.back()),
              false};
    }
    if (trip.km < kShortestKm || trip.km > format_.fastest_kmh * trip.minutes / 60.0) {
      return {trip.km < kShortestKm ? "under 100 m" : "too fast", row.text(format_.distance), false};
    }
    return {};
  }

  const SampleFormat& format_;
  const std::vector<Zone>& zones_;
  ZonePlaces names_;
  std::string no_time_;
  std::string no_zone_;
  std::string text_;
};

/// Sums over trips.
struct TravelTotals {
  double trips = 0.0;
  double km = 0.0;
  double straight_km = 0.0;
  double minutes = 0.0;
  double km2 = 0.0;
  double km_minutes = 0.0;

  void add(const SampleTrip& trip) {
    trips += 1.0;
    km += trip.km;
    straight_km += trip.straight_km;
    minutes += trip.minutes;
    km2 += trip.km * trip.km;
    km_minutes += trip.km * trip.minutes;
  }

  TravelLaw law() const { return least_squares(trips, km, minutes, km2, km_minutes); }
};

void fit_hours(const std::vector<SampleTrip>& trips, const TravelTotals& all, TravelSample& fit) {
  std::array<TravelTotals, 24> by_hour;
  for (const SampleTrip& trip : trips) {
    by_hour.at(trip.hour).add(trip);
  }
  const double prior = kHourPrior / all.trips;
  for (std::size_t hour = 0; hour < by_hour.size(); ++hour) {
    const TravelTotals& sums = by_hour[hour];
    const double expected = fit.law.start * sums.trips + fit.law.per_km * sums.km;
    fit.hours[hour] = {static_cast<int>(sums.trips),
                       (sums.minutes + prior * all.minutes) / (expected + prior * all.minutes),
                       (sums.km + prior * all.km) / (sums.straight_km + prior * all.straight_km)};
  }
}

std::string report_of(long long read, const Dropped& dropped, std::size_t used, const TravelSample& fit) {
  std::array<char, 200> line{};
  std::string text = "sample rows read: " + std::to_string(read) + "\n" + dropped.report();
  std::snprintf(line.data(), line.size(), "trips of the sample used: %zu, minutes = %.2f + %.2f * km, detour %.3f\n",
                used, fit.law.start, fit.law.per_km, fit.detour);
  text += line.data();
  text += "  hour  trips  minutes over the law's  detour\n";
  for (std::size_t hour = 0; hour < fit.hours.size(); ++hour) {
    const HourOfTravel& one = fit.hours[hour];
    std::snprintf(line.data(), line.size(), "  %4zu  %5d  %22.3f  %6.3f\n", hour, one.trips, one.pace, one.detour);
    text += line.data();
  }
  return text;
}

}  // namespace

TravelSample fit_travel(const std::filesystem::path& table, const SampleFormat& format, const std::vector<Zone>& zones,
                        const std::function<double(int from, int to)>& straight_km) {
  SampleReader reader(format, zones);
  Dropped dropped;
  std::vector<SampleTrip> trips;
  TravelTotals all;
  long long read = 0;
  try {
    RawTable rows(table, format.table);
    RowTally tally(rows, dropped);
    for (; rows.next(); ++read) {
      SampleTrip trip;
      int from = 0;
      int to = 0;
      if (!tally.keeps(reader.read(rows, trip, from, to))) {
        continue;
      }
      trip.straight_km = straight_km(from, to);
      trips.push_back(trip);
      all.add(trip);
    }
    tally.finish();
    if (trips.size() < kFewestTrips) {
      throw bad_input(table.string(), 0,
                      "has " + std::to_string(trips.size()) + " trips that count; a hundred at least are needed");
    }
  } catch (const Error& error) {
    throw with_report(error, dropped.report());
  }
  TravelSample fit;
  fit.law = all.law();
  fit.detour = all.straight_km > 0.0 ? all.km / all.straight_km : 1.0;
  fit_hours(trips, all, fit);
  fit.report = report_of(read, dropped, trips.size(), fit);
  return fit;
}

}  // namespace evbal
