#include "agents/world/factors.hpp"

#include "agents/world/geometry.hpp"
#include "agents/world/pack_table.hpp"
#include "common/decimal.hpp"
#include "common/files.hpp"
#include "common/random.hpp"
#include "common/table_text.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace evbal {
namespace {

constexpr double kMaxSpread = 100.0;  // km

/// "2008-06-03" as 20080603.
std::uint64_t number_of(const std::string& date) {
  std::uint64_t number = 0;
  for (const char c : date) {
    number = c == '-' ? number : 10 * number + static_cast<std::uint64_t>(c - '0');
  }
  return number;
}

/// Log-normal factors with mean 1 of each region on a day.
std::vector<double> region_factors(const CityFactors& factors, int regions, std::uint64_t day) {
  const double sigma2 = std::log1p(factors.region_deviation * factors.region_deviation);
  std::vector<double> all;
  for (int region = 0; region < regions; ++region) {
    const auto from = static_cast<std::uint64_t>(region);
    RandomStream random(factors.seed, Purpose::synthetic_city, {from, day, static_cast<std::uint64_t>(regions)});
    all.push_back(std::exp(std::sqrt(sigma2) * random.normal() - sigma2 / 2.0));
  }
  return all;
}

std::vector<TripCount> read_pairs(const std::filesystem::path& file, int regions) {
  PackTable table(file, "origin,destination,trips");
  std::vector<TripCount> pairs;
  long long total = 0;
  while (table.next()) {
    if (table.text(0) == "end") {
      if (parse_integer(table.text(2)) != total) {
        throw table.error("says `" + std::string(table.text(2)) + "`, but the trips sum to " + std::to_string(total));
      }
      return pairs;
    }
    const TripCount pair{table.integer(0, 0, regions - 1), table.integer(1, 0, regions - 1),
                         table.integer(2, 1, TripCount::most)};
    if (!pairs.empty() &&
        std::tie(pair.origin, pair.destination) <= std::tie(pairs.back().origin, pairs.back().destination)) {
      throw table.error("lines must ascend by origin, destination");
    }
    total += pair.trips;
    pairs.push_back(pair);
  }
  throw table.error("the last line `end,,TOTAL` is missing; the file is truncated");
}

Eigen::MatrixXd read_course(const std::filesystem::path& file, const City& city) {
  Eigen::MatrixXd course(static_cast<Eigen::Index>(city.days.size()), city.steps_per_day());
  PackTable table(file, "day,step,share");
  for (Eigen::Index day = 0; day < course.rows(); ++day) {
    for (Eigen::Index step = 0; step < course.cols(); ++step) {
      const std::string& date = city.days[day];
      if (!table.next() || table.text(0) != date || table.integer(1, 0, city.steps_per_day()) != step) {
        throw table.error("expected " + date + "," + std::to_string(step) + "; every step of every day needs a line");
      }
      course(day, step) = table.number(2, 0.0, 1.0);
    }
  }
  if (table.next()) {
    throw table.error("more lines than steps of all days");
  }
  return course;
}

std::vector<double> read_spreads(const std::filesystem::path& file, int regions) {
  PackTable table(file, "region,spread_km");
  std::vector<double> spreads;
  for (int region = 0; region < regions; ++region) {
    if (!table.next() || table.integer(0, 0, regions) != region) {
      throw table.error("expected region " + std::to_string(region) + "; every region needs a line");
    }
    spreads.push_back(table.number(1, 0.0, kMaxSpread));
  }
  if (table.next()) {
    throw table.error("more lines than regions");
  }
  return spreads;
}

}  // namespace

DemandDay drawn_day(const City& city, const std::string& date) {
  const CityFactors& factors = *city.factors;
  const auto position = std::lower_bound(city.days.begin(), city.days.end(), date) - city.days.begin();
  const std::uint64_t day_number = number_of(date);
  const std::vector<double> deviation = region_factors(factors, city.size(), day_number);
  DemandDay day{date, std::binary_search(city.holidays.begin(), city.holidays.end(), date), {}};
  day.steps.resize(city.steps_per_day());
  for (const TripCount& pair : factors.pairs) {
    RandomStream random(
        factors.seed, Purpose::synthetic_city,
        {static_cast<std::uint64_t>(pair.origin), day_number, static_cast<std::uint64_t>(pair.destination)});
    const double of_day = factors.share * pair.trips * deviation[pair.origin];
    for (int step = 0; step < city.steps_per_day(); ++step) {
      const auto trips =
          static_cast<int>(random.poisson(std::min(of_day * factors.course(position, step), 1.0 * TripCount::most)));
      if (trips > 0) {
        day.steps[step].push_back({pair.origin, pair.destination, trips});
      }
    }
  }
  return day;
}

void set_travel(City& city) {
  constexpr double kLeastKm = 0.1;
  constexpr double kLeastMinutes = 1.0;
  const CityFactors& factors = *city.factors;
  const int n = city.size();
  const LocalFrame frame(city.regions.front().centroid);
  std::vector<LocalPoint> centroids;
  for (const Region& region : city.regions) {
    centroids.push_back(frame.local(region.centroid));
  }
  city.km.resize(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double between = distance(centroids[i], centroids[j]) / 1000.0;
      const double km = factors.detour * std::hypot(between, factors.spread_km[i], factors.spread_km[j]);
      city.km(i, j) = std::max(kLeastKm, std::round(km * 100.0) / 100.0);
    }
  }
  city.minutes = (factors.start_minutes + factors.minutes_per_km * city.km.array()).max(kLeastMinutes);
}

CityFactors read_factors(const YamlValue& value, const City& city) {
  YamlMap map(value);
  CityFactors factors;
  factors.seed = map.require("seed").seed();
  factors.share = map.require("share").number(0.0, 1.0);
  factors.region_deviation = map.require("region_deviation").number(0.0, 2.0);
  factors.detour = map.require("detour").number(1.0, 3.0);
  factors.start_minutes = map.require("start").duration(0.0, 24.0 * 60.0);
  factors.minutes_per_km = map.require("minutes_per_km").number(0.0, 60.0);
  map.finish();
  factors.pairs = read_pairs(city.folder / "demand" / "pairs.csv", city.size());
  factors.course = read_course(city.folder / "demand" / "course.csv", city);
  factors.spread_km = read_spreads(city.folder / "spread.csv", city.size());
  return factors;
}

void write_factors(YamlWriter& yaml, const CityFactors& factors) {
  yaml.key("factors").begin_map().key("seed").number(factors.seed).key("share").number(factors.share);
  yaml.key("region_deviation").number(factors.region_deviation).key("detour").number(factors.detour);
  yaml.key("start").minutes(factors.start_minutes).key("minutes_per_km").number(factors.minutes_per_km).end_map();
}

void write_factor_tables(const City& city, const std::filesystem::path& folder) {
  const CityFactors& factors = *city.factors;
  std::string pairs = "origin,destination,trips\n";
  long long total = 0;
  for (const TripCount& pair : factors.pairs) {
    pairs += csv_row({decimal(pair.origin), decimal(pair.destination), decimal(pair.trips)});
    total += pair.trips;
  }
  write_file(folder / "demand" / "pairs.csv", pairs + csv_row({"end", "", decimal(total)}));
  std::string course = "day,step,share\n";
  for (Eigen::Index day = 0; day < factors.course.rows(); ++day) {
    for (Eigen::Index step = 0; step < factors.course.cols(); ++step) {
      course += csv_row({city.days[day], decimal(step), decimal(factors.course(day, step))});
    }
  }
  write_file(folder / "demand" / "course.csv", course);
  std::string spread = "region,spread_km\n";
  for (std::size_t region = 0; region < factors.spread_km.size(); ++region) {
    spread += csv_row({decimal(region), decimal(factors.spread_km[region])});
  }
  write_file(folder / "spread.csv", spread);
}

}  // namespace evbal
