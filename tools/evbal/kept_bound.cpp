#include "tools/evbal/kept_bound.hpp"

#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "experiments/bound/bound_file.hpp"
#include "tools/evbal/runs_folder.hpp"

#include <algorithm>

namespace evbal {
namespace {

/// What a point of a bound must be to serve.
using Enough = bool (*)(const BoundPoint&);

/// Whether a bound has all that is asked for.
bool has_all(const DayBound& bound, const std::vector<double>& prices, Enough enough) {
  return std::all_of(prices.begin(), prices.end(), [&](double price) {
    return std::any_of(bound.points.begin(), bound.points.end(),
                       [&](const BoundPoint& point) { return point.price == price && enough(point); });
  });
}

DayBound kept(const Scenario& scenario, const std::vector<double>& prices, Enough enough,
              const std::function<bool(const BoundProgress&)>& stop) {
  const std::filesystem::path file = bound_file(bounds_folder(), bound_key(scenario));
  std::optional<DayBound> known = read_bound(file);
  if (!known || !has_all(*known, prices, enough)) {
    const DayBound found = day_bound(bound_day(scenario), prices, stop);
    known = known ? merged(*known, found) : found;
    std::filesystem::create_directories(file.parent_path());
    write_file(file, bound_csv(*known));
  }
  return *known;
}

}  // namespace

DayBound kept_bound(const Scenario& scenario, const std::vector<double>& prices,
                    const std::function<bool(const BoundProgress&)>& stop) {
  return kept(
      scenario, prices, [](const BoundPoint& point) { return point.complete(); }, stop);
}

DayBound kept_bound_alone(const Scenario& scenario, const std::vector<double>& prices) {
  return kept(
      scenario, prices, [](const BoundPoint& point) { return point.tight; },
      [](const BoundProgress& progress) {
        check_interrupt();
        return progress.rounding == Rounding::up;
      });
}

}  // namespace evbal
