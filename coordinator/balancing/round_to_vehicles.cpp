#include "coordinator/balancing/round_to_vehicles.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace evbal {
namespace {

constexpr std::int64_t unit = 1'000'000;  // millionths of a vehicle

void expect_between_regions(const std::vector<Flow>& flows, int regions) {
  constexpr double most = 1e6;
  const auto is_region = [regions](int region) { return region >= 0 && region < regions; };
  for (const auto& [from, to, amount] : flows) {
    EVBAL_EXPECT(is_region(from) && is_region(to) && from != to, "flows between two regions");
    EVBAL_EXPECT(amount >= 0.0 && amount <= most, "amounts within [0, 1e6]");
  }
}

// Sorted by (from, to), each pair once.
std::vector<Flow> by_pair(std::vector<Flow> flows) {
  const auto pair = [](const Flow& flow) { return std::pair(flow.from, flow.to); };
  std::ranges::stable_sort(flows, {}, pair);
  std::vector<Flow> merged;
  for (const Flow& flow : flows) {
    if (!merged.empty() && pair(merged.back()) == pair(flow)) {
      merged.back().amount += flow.amount;
    } else {
      merged.push_back(flow);
    }
  }
  return merged;
}

// Amounts in millionths that add up to `most` at most; too much is cut in proportion.
std::vector<std::int64_t> millionths(std::span<const Flow> flows, std::int64_t most) {
  std::vector<std::int64_t> amounts;
  for (const auto& flow : flows) {
    amounts.push_back(std::llround(flow.amount * static_cast<double>(unit)));
  }
  const std::int64_t sum = std::reduce(amounts.begin(), amounts.end());
  if (sum > most) {
    const double cut = static_cast<double>(most) / static_cast<double>(sum);
    std::ranges::transform(amounts, amounts.begin(), [cut](std::int64_t amount) {
      return static_cast<std::int64_t>(cut * static_cast<double>(amount));
    });
  }
  return amounts;
}

// What limits leave of what one origin may send.
class Room {
 public:
  Room(const std::vector<SendLimit>& limits, int from) {
    std::ranges::copy_if(limits, std::back_inserter(left_),
                         [from](const SendLimit& limit) { return limit.from == from; });
  }

  std::int64_t to(int target) const {
    double room = std::numeric_limits<std::int32_t>::max();
    for (const SendLimit& limit : left_) {
      room = holds(limit, target) ? std::min(room, std::floor(limit.most)) : room;
    }
    return static_cast<std::int64_t>(std::max(0.0, room));
  }

  void take(int target, std::int64_t vehicles) {
    for (SendLimit& limit : left_) {
      limit.most -= holds(limit, target) ? static_cast<double>(vehicles) : 0.0;
    }
  }

 private:
  static bool holds(const SendLimit& limit, int target) {
    return std::ranges::find(limit.targets, target) != limit.targets.end();
  }

  std::vector<SendLimit> left_;
};

// Whole vehicles of one origin's flows.
std::vector<VehicleFlow> whole_row(std::span<const Flow> flows, std::int64_t available, Room room) {
  const auto amounts = millionths(flows, available * unit);
  std::vector<VehicleFlow> row;
  std::int64_t sent = 0;
  const auto send = [&](std::size_t i, std::int64_t vehicles) {
    const std::int64_t most = std::min(vehicles, room.to(row[i].to));
    row[i].vehicles += static_cast<int>(most);
    room.take(row[i].to, most);
    sent += most;
  };
  for (std::size_t i = 0; i < flows.size(); ++i) {
    row.push_back({flows[i].from, flows[i].to, 0});
    send(i, amounts[i] / unit);
  }
  const std::int64_t total = (std::reduce(amounts.begin(), amounts.end()) + unit / 2) / unit;
  std::vector<std::size_t> order(row.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return amounts[i] % unit; });
  for (std::size_t rank = 0; sent < total && rank < order.size(); ++rank) {
    send(order[rank], 1);
  }
  std::erase_if(row, [](const VehicleFlow& flow) { return flow.vehicles == 0; });
  return row;
}

}  // namespace

std::vector<VehicleFlow> round_to_vehicles(const std::vector<Flow>& flows, const Eigen::VectorXi& available,
                                           const std::vector<SendLimit>& limits) {
  expect_between_regions(flows, static_cast<int>(available.size()));
  EVBAL_EXPECT((available.array() >= 0).all(), "no region with less than no vehicles");
  const std::vector<Flow> pairs = by_pair(flows);
  std::vector<VehicleFlow> whole;
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = std::find_if(first, pairs.end(), [&](const Flow& flow) { return flow.from != first->from; });
    const auto row = whole_row({first, last}, available(first->from), {limits, first->from});
    whole.insert(whole.end(), row.begin(), row.end());
    first = last;
  }
  return whole;
}

}  // namespace evbal
