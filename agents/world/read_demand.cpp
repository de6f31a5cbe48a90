#include "agents/world/city.hpp"
#include "agents/world/factors.hpp"
#include "agents/world/pack_table.hpp"

#include <algorithm>
#include <tuple>

namespace evbal {
namespace {

/// The lines up to `end,,,TOTAL`.
std::vector<std::vector<TripCount>> read_counts(PackTable& table, const City& city) {
  const int n = city.size();
  std::vector<std::vector<TripCount>> steps(city.steps_per_day());
  std::tuple<int, int, int> before(-1, -1, -1);
  long long total = 0;
  while (table.next()) {
    if (table.text(0) == "end") {
      if (parse_integer(table.text(3)) != total) {
        throw table.error("says `" + std::string(table.text(3)) + "`, but the trips sum to " + std::to_string(total));
      }
      return steps;
    }
    const int step = table.integer(0, 0, city.steps_per_day() - 1);
    const TripCount count{table.integer(1, 0, n - 1), table.integer(2, 0, n - 1), table.integer(3, 1, TripCount::most)};
    const std::tuple<int, int, int> key(step, count.origin, count.destination);
    if (key <= before) {
      throw table.error("lines must ascend by step, origin, destination");
    }
    before = key;
    total += count.trips;
    steps[step].push_back(count);
  }
  throw table.error("the last line `end,,,TOTAL` is missing; the file is truncated");
}

}  // namespace

DemandDay read_demand(const City& city, const std::string& date) {
  if (!std::binary_search(city.days.begin(), city.days.end(), date)) {
    std::string known;
    for (const auto& day : city.days) {
      known += (known.empty() ? "" : ", ") + day;
    }
    throw bad_input("city " + city.name + " has no day `" + date + "`; choose one of " + known);
  }
  if (city.factors) {
    return drawn_day(city, date);
  }
  PackTable table(city.folder / "demand" / (date + ".csv"), "step,origin,destination,trips");
  const bool holiday = std::binary_search(city.holidays.begin(), city.holidays.end(), date);
  DemandDay day{date, holiday, read_counts(table, city)};
  if (table.next()) {
    throw table.error("nothing may follow the line `end,,,TOTAL`");
  }
  return day;
}

}  // namespace evbal
