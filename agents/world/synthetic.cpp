#include "agents/world/synthetic.hpp"

#include "agents/world/geometry.hpp"
#include "common/contract.hpp"
#include "common/random.hpp"

#include <chrono>
#include <cmath>

namespace evbal {
namespace {

constexpr LatLon kOrigin{37.75, -122.45};
constexpr double kCell = 3000.0;       // metres between grid corners
constexpr double kDetour = 1.3;        // driven over straight distance
constexpr double kWithin = 0.5;        // mean distance within a region, in cells
constexpr double kStartMinutes = 3.0;  // a trip's minutes: start + per km
constexpr double kMinutesPerKm = 2.2;
constexpr double kGravityKm = 8.0;      // trips thin out by e over this distance
constexpr double kDaySpread = 0.10;     // of the logarithm of a day's demand
constexpr double kRegionSpread = 0.15;  // of the logarithm of a region's demand on a day
constexpr int kDayStart = 5 * 60;

/// Streams of one seed are told apart by what they draw.
enum class Draw : std::uint64_t { corner, region, day, region_day, count };

RandomStream stream(const SyntheticOptions& options, Draw draw, std::uint64_t region, std::uint64_t tick = 0) {
  return {options.seed, Purpose::synthetic_city, {region, tick, static_cast<std::uint64_t>(draw)}};
}

/// To the nearest 1 / `parts`, so that it is short in a file.
double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

double bump(double hour, double peak, double width) {
  const double z = (hour - peak) / width;
  return std::exp(-0.5 * z * z);
}

/// Where trips of a region tend to start in the morning (home) and in the evening (work).
struct Character {
  double home = 1.0;
  double work = 1.0;
};

std::vector<Region> grid_regions(const SyntheticOptions& options) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(options.regions)));
  const LocalFrame frame(kOrigin);
  const auto corner = [&](int column, int row) {
    auto random = stream(options, Draw::corner, column, row);
    const double east = (column + random.uniform(-0.25, 0.25)) * kCell;
    const double north = (row + random.uniform(-0.25, 0.25)) * kCell;
    const LatLon point = frame.global({east, north});
    return LatLon{rounded(point.lat, 1e5), rounded(point.lon, 1e5)};
  };
  std::vector<Region> regions;
  for (int i = 0; i < options.regions; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    Region region{"r" + std::to_string(i + 1), {}, {}};
    region.outline = {
        {corner(column, row), corner(column + 1, row), corner(column + 1, row + 1), corner(column, row + 1)}};
    for (const LatLon point : region.outline.front()) {
      region.centroid.lat += point.lat / 4.0;
      region.centroid.lon += point.lon / 4.0;
    }
    region.centroid = {rounded(region.centroid.lat, 1e5), rounded(region.centroid.lon, 1e5)};
    regions.push_back(std::move(region));
  }
  return regions;
}

void add_travel(City& city) {
  const int n = city.size();
  const LocalFrame frame(kOrigin);
  city.km.resize(n, n);
  city.minutes.resize(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double straight =
          i == j ? kWithin * kCell
                 : distance(frame.local(city.regions[i].centroid), frame.local(city.regions[j].centroid));
      city.km(i, j) = rounded(kDetour * straight / 1000.0, 100.0);
      city.minutes(i, j) = rounded(kStartMinutes + kMinutesPerKm * city.km(i, j), 10.0);
    }
  }
}

void add_days(const SyntheticOptions& options, City& city) {
  using std::chrono::days;
  constexpr std::chrono::sys_days kFirst = std::chrono::year(2024) / 1 / 1;
  for (int i = 0; i < options.train_days + options.test_days; ++i) {
    const std::chrono::year_month_day date(kFirst + days(i));
    const auto two = [](unsigned number) { return (number < 10 ? "-0" : "-") + std::to_string(number); };
    city.days.push_back(std::to_string(static_cast<int>(date.year())) + two(static_cast<unsigned>(date.month())) +
                        two(static_cast<unsigned>(date.day())));
    (i < options.train_days ? city.train_days : city.test_days).push_back(city.days.back());
  }
}

/// Spread over the regions at equal distances by index; points shared out evenly, the first stations get the rest.
void add_stations(const SyntheticOptions& options, City& city) {
  for (int s = 0; s < options.stations; ++s) {
    const int region = s * options.regions / options.stations;
    const int points = options.points / options.stations + (s < options.points % options.stations ? 1 : 0);
    city.stations.push_back({"s" + std::to_string(s + 1), region, points, city.regions[region].centroid});
  }
}

/// Share of the day's trips that start at `hour`, up to a factor.
double time_profile(double hour, bool weekend) {
  return weekend ? 0.25 + 0.5 * bump(hour, 13.0, 3.0) + bump(hour, 21.0, 2.0)
                 : 0.25 + 0.9 * bump(hour, 8.5, 1.2) + 1.1 * bump(hour, 18.0, 1.8);
}

/// Mean trips of every pair within each step of an average day; the sum over all is 1.
std::vector<Eigen::MatrixXd> mean_shares(const City& city, const std::vector<Character>& characters, bool weekend) {
  const int n = city.size();
  std::vector<Eigen::MatrixXd> shares;
  double total = 0.0;
  for (int step = 0; step < city.steps_per_day(); ++step) {
    const double hour = (city.day_start + (step + 0.5) * city.step_minutes) / 60.0;
    const double morning = bump(hour, 7.0, 4.0);
    Eigen::MatrixXd pairs(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double out = morning * characters[i].home + (1.0 - morning) * characters[i].work;
        const double in = morning * characters[j].work + (1.0 - morning) * characters[j].home;
        pairs(i, j) = out * in * std::exp(-city.km(i, j) / kGravityKm);
      }
    }
    pairs *= time_profile(hour, weekend) / pairs.sum();
    total += pairs.sum();
    shares.push_back(std::move(pairs));
  }
  for (auto& pairs : shares) {
    pairs /= total;
  }
  return shares;
}

DemandDay draw_day(const SyntheticOptions& options, const City& city, const std::vector<Eigen::MatrixXd>& shares,
                   int number) {
  DemandDay day{city.days[number], false, {}};
  const double level = options.trips_per_day * std::exp(kDaySpread * stream(options, Draw::day, 0, number).normal());
  std::vector<double> region_level;
  region_level.reserve(city.regions.size());
  for (int i = 0; i < city.size(); ++i) {
    region_level.push_back(level * std::exp(kRegionSpread * stream(options, Draw::region_day, i, number).normal()));
  }
  for (int step = 0; step < city.steps_per_day(); ++step) {
    auto& counts = day.steps.emplace_back();
    for (int i = 0; i < city.size(); ++i) {
      auto random = stream(options, Draw::count, i, number * city.steps_per_day() + step);
      for (int j = 0; j < city.size(); ++j) {
        const auto trips = static_cast<int>(random.poisson(region_level[i] * shares[step](i, j)));
        if (trips > 0) {
          counts.push_back({i, j, trips});
        }
      }
    }
  }
  return day;
}

}  // namespace

SyntheticCity synthetic_city(const SyntheticOptions& options) {
  EVBAL_EXPECT(options.regions >= 1 && options.train_days + options.test_days >= 1, "at least one region and one day");
  EVBAL_EXPECT(options.stations <= options.regions && options.points >= options.stations,
               "at most one station a region, each with a point");
  SyntheticCity synthetic;
  City& city = synthetic.city;
  city.name = options.name;
  city.source = "generated: evbal ingest synthetic, seed " + std::to_string(options.seed);
  city.day_start = kDayStart;
  city.regions = grid_regions(options);
  city.fleet = {options.vehicles, options.battery_kwh, 5.5, 0.3, 0.9};
  city.charging = {50.0, {12.0, 16.0, 20.0, 25.0, 32.0}};
  city.passengers = {8.0, 20.0};
  add_travel(city);
  add_days(options, city);
  add_stations(options, city);

  std::vector<Character> characters;
  for (int i = 0; i < options.regions; ++i) {
    auto random = stream(options, Draw::region, i);
    characters.push_back({std::exp(0.6 * random.normal()), std::exp(0.6 * random.normal())});
  }
  const auto weekday = mean_shares(city, characters, false);
  const auto weekend = mean_shares(city, characters, true);
  for (int number = 0; number < options.train_days + options.test_days; ++number) {
    synthetic.days.push_back(draw_day(options, city, number % 7 < 5 ? weekday : weekend, number));
  }
  return synthetic;
}

}  // namespace evbal
