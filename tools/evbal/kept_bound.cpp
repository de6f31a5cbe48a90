#include "tools/evbal/kept_bound.hpp"

#include "common/files.hpp"
#include "experiments/bound/bound_file.hpp"
#include "tools/evbal/runs_folder.hpp"

#include <algorithm>

namespace evbal {
namespace {

/// Whether a bound has all that is asked for.
bool has_all(const DayBound& bound, const std::vector<double>& prices) {
  return std::all_of(prices.begin(), prices.end(), [&](double price) {
    return std::any_of(bound.points.begin(), bound.points.end(),
                       [&](const BoundPoint& point) { return point.price == price && point.complete(); });
  });
}

}  // namespace

DayBound kept_bound(const Scenario& scenario, const std::vector<double>& prices,
                    const std::function<bool(const BoundProgress&)>& stop) {
  const std::filesystem::path file = bound_file(bounds_folder(), bound_key(scenario));
  std::optional<DayBound> known = read_bound(file);
  if (!known || !has_all(*known, prices)) {
    const DayBound found = day_bound(bound_day(scenario), prices, stop);
    known = known ? merged(*known, found) : found;
    std::filesystem::create_directories(file.parent_path());
    write_file(file, bound_csv(*known));
  }
  return *known;
}

}  // namespace evbal
