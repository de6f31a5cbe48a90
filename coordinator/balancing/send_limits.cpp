#include "coordinator/balancing/send_limits.hpp"

#include <algorithm>

namespace evbal {
namespace {

// Of one region, whose arcs lie between `first` and `last`.
void add_limits(const FleetState& state, std::vector<Arc> arcs, std::vector<SendLimit>& limits) {
  std::ranges::stable_sort(arcs, std::ranges::greater{}, &Arc::km);
  SendLimit limit{.from = arcs.front().from, .targets = {}, .most = 0.0};
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    limit.targets.push_back(arcs[i].to);
    limit.most = low_battery_reaching(state, limit.from, arcs[i].km);
    const double nearer =
        i + 1 < arcs.size() ? low_battery_reaching(state, limit.from, arcs[i + 1].km) : state.low_battery(limit.from);
    if (limit.most < nearer) {
      limits.push_back(limit);
    }
  }
}

}  // namespace

double low_battery_reaching(const FleetState& state, int region, double km) {
  const auto& reach = state.reach[static_cast<std::size_t>(region)];
  const auto short_of = std::ranges::lower_bound(reach, km) - reach.begin();
  return std::max(0.0, state.low_battery(region) - static_cast<double>(short_of));
}

std::vector<SendLimit> reach_limits(const FleetState& state, const std::vector<Arc>& arcs) {
  std::vector<SendLimit> limits;
  for (auto first = arcs.begin(); first != arcs.end();) {
    const auto last = std::find_if(first, arcs.end(), [&](const Arc& arc) { return arc.from != first->from; });
    add_limits(state, {first, last}, limits);
    first = last;
  }
  return limits;
}

}  // namespace evbal
