#include "coordinator/bridge/move_check.hpp"

#include "agents/protocol/words.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

std::optional<MoveComplaint> take_count(const Move& move, int& left, const char* which) {
  if (move.count < 1 || move.count > left) {
    return MoveComplaint{"count", "region " + std::to_string(move.from) + " has " + std::to_string(left) + " " + which +
                                      " vehicles left to send; give 1 at least and no more, not " +
                                      std::to_string(move.count)};
  }
  left -= move.count;
  return std::nullopt;
}

}  // namespace

MoveCheck::MoveCheck(const std::vector<Report>& reports, const std::vector<Rejection>& rejected, const City& city)
    : regions_(city.size()), top_up_(city.charging.top_up) {
  for (const auto& report : reports) {
    left_[report.region] = {report.vacant, report.low_battery, top_up_ ? report.chargeable : 0};
  }
  constexpr int any = std::numeric_limits<int>::max();
  for (const auto& rejection : rejected) {
    left_[rejection.region] = {any, any, top_up_ ? any : 0};
  }
}

std::optional<MoveComplaint> MoveCheck::take(const Move& move) {
  for (const auto& [field, region] : {std::pair("from", move.from), std::pair("to", move.to)}) {
    if (region < 0 || region >= regions_) {
      return MoveComplaint{
          field, "a region from 0 to " + std::to_string(regions_ - 1) + " is expected, not " + std::to_string(region)};
    }
  }
  if (move.errand != Errand::rebalance && move.errand != Errand::charge) {
    return MoveComplaint{"errand", "`rebalance` or `charge` is expected"};
  }
  if (move.from == move.to && (move.errand == Errand::rebalance || !top_up_)) {
    return MoveComplaint{"to", "another region than `from` is expected"};
  }
  return take(move, left_[move.from]);
}

std::optional<MoveComplaint> MoveCheck::take(const Move& move, Left& left) const {
  if (move.errand == Errand::charge && move.from != move.to) {
    return take_count(move, left.low_battery, "low-battery");
  }
  auto complaint = take_count(move, left.vacant, "vacant");
  if (!complaint && move.errand == Errand::charge) {
    complaint = take_count(move, left.chargeable, "chargeable");
  }
  return complaint;
}

std::string sort_moves(std::vector<Move>& moves) {
  const auto key = [](const Move& move) { return std::tuple(move.errand, move.from, move.to); };
  std::ranges::sort(moves, {}, key);
  const auto twice = std::ranges::adjacent_find(moves, {}, key);
  return twice == moves.end() ? ""
                              : std::string(word(twice->errand)) + " from " + std::to_string(twice->from) + " to " +
                                    std::to_string(twice->to) + " is given twice; give it once with the sum";
}

}  // namespace evbal
