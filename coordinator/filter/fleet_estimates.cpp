#include "coordinator/filter/count_law.hpp"
#include "coordinator/filter/fleet_filter.hpp"

#include <algorithm>
#include <cmath>

// What is taken to be true in place of what is not believed, and what is told of it.

namespace evbal {
namespace {

constexpr std::size_t longest_delay = 12;  ///< reports, that a field can be late by
constexpr double least_expected = 1e-3;    ///< mean of a count that says anything
constexpr double of_a_count = 0.5;         ///< deviation of what is counted in another way
constexpr double rounding = 0.6;           ///< cars

int rounded(double count) {
  return static_cast<int>(std::lround(std::max(0.0, count)));
}

void add(FieldInnovations& sum, double count, double expected, double variance) {
  if (expected < least_expected || variance < least_expected) {
    return;
  }
  const UsualCounts usual = usual_counts(expected);
  ++sum.counts;
  sum.squares += (count - expected) * (count - expected) / variance;
  sum.within += count >= usual.low && count <= usual.high ? 1 : 0;
  sum.expected_within += usual.probability;
}

}  // namespace

FleetFilter::Estimate FleetFilter::estimate(int region, const News& news, const WindowOutlook& outlook,
                                            ReportField field) const {
  const Region& known = regions_[static_cast<std::size_t>(region)];
  const auto of_stock = [&](CarKind stock) -> Estimate {
    const int row = static_cast<int>(stock);
    return {std::max(0.0, known.stock->counts()(row)), std::sqrt(std::max(0.0, known.stock->covariance()(row, row)))};
  };
  const auto said = believed(region, news, field);
  switch (field) {
    case ReportField::vacant:
      return known.stock ? of_stock(CarKind::vacant) : Estimate{*said, 0.0};
    case ReportField::low_battery:
      return known.stock ? of_stock(CarKind::low_battery) : Estimate{*said, 0.0};
    case ReportField::plugged:
      return {static_cast<double>(news.plugged_since.size()), 0.0};
    case ReportField::points:
      return {static_cast<double>(news.points), 0.0};
    case ReportField::waiting:
    case ReportField::demand:
      return said ? Estimate{*said, 0.0} : passengers(region, news, outlook, field);
    case ReportField::completions:
      return {said.value_or(news.window.ended), of_a_count};
    default:
      return {said.value_or(known.last.chargeable), of_a_count};
  }
}

/// By the balance, if the cars are believed; else as forecast.
FleetFilter::Estimate FleetFilter::passengers(int region, const News& news, const WindowOutlook& outlook,
                                              ReportField field) const {
  const RegionCounts& before = regions_[static_cast<std::size_t>(region)].counts;
  const auto waiting = believed(region, news, ReportField::waiting);
  const auto demand = believed(region, news, ReportField::demand);
  const double usual = outlook.demand(region);
  if (!begun_ || !believes_cars(region, news)) {
    const PickUps gone = picked_up(region, news, outlook);
    return field == ReportField::demand
               ? Estimate{usual, std::sqrt(outlook.demand_dispersion * usual)}
               : Estimate{std::max(0.0, before.waiting + demand.value_or(usual) - gone.expected),
                          std::sqrt(1.0 + gone.variance)};
  }
  const bool vacant = news.report->vacant > 0;
  if (field == ReportField::waiting && vacant) {
    return {0.0, 0.0};
  }
  const RegionCounts cars{static_cast<double>(news.report->vacant), static_cast<double>(news.report->low_battery), 0.0,
                          waiting.value_or(vacant || field == ReportField::waiting ? 0.0 : before.waiting)};
  const Excess excess =
      excess_of(before, news.window, cars, field == ReportField::demand ? 0.0 : demand.value_or(usual));
  const double missing = excess.cars - excess.expected;
  return {std::max(0.0, field == ReportField::demand ? -missing : missing), std::sqrt(excess.variance + of_a_count)};
}

void FleetFilter::settle(int tick, int region, const News& news, const WindowOutlook& outlook) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  Fields now{};
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const Estimate is = estimate(region, news, outlook, static_cast<ReportField>(k + 1));
    now.at(k) = is.value;
    if (known.lies.at(k) && news.report != nullptr) {
      const int said = news.report->*measured.at(k).member;
      const bool counts_cars = index_of(ReportField::vacant) == k || index_of(ReportField::low_battery) == k;
      // What is off by a constant changes as it should; only after a jump can it be right again.
      const bool still_off = counts_cars && !known.doubt.jumped && std::abs(said - is.value) > rounding;
      known.lies.at(k)->hear(said, is.value, still_off ? 0.0 : is.deviation);
    }
  }
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (known.lies.at(k) && known.lies.at(k)->over()) {
      known.lies.at(k).reset();
      now.at(k) = news.report->*measured.at(k).member;
    }
  }
  if (believes_cars(region, news)) {
    known.stock.reset();
  }
  const auto value = [&](ReportField field) { return now.at(index_of(field)); };
  known.counts = {value(ReportField::vacant), value(ReportField::low_battery), value(ReportField::plugged),
                  value(ReportField::waiting)};
  known.past.push_back(now);
  if (known.past.size() > longest_delay) {
    known.past.pop_front();
  }
  known.broken = news.broken;
  known.heard.reset();
  if (news.report != nullptr) {
    known.heard = {static_cast<double>(news.report->vacant), static_cast<double>(news.report->low_battery), 0.0, 0.0};
  }
  Report& out = known.last;
  if (news.report != nullptr) {
    out = *news.report;
  }
  out.tick = tick;
  out.region = region;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    out.*measured.at(k).member = rounded(now.at(k));
  }
  if (news.report == nullptr) {
    out.demand = out.completions = 0;
  }
  out.chargeable = std::min(out.chargeable, out.vacant);
  out.plugged_since = news.plugged_since;
  out.reach_m.resize(std::min<std::size_t>(out.reach_m.size(), static_cast<std::size_t>(out.low_battery)));
  out.bound = news.bound;
}

FleetFilter::Result FleetFilter::result(const std::vector<News>& news) const {
  Result result;
  FieldInnovations vacant{.field = ReportField::vacant};
  FieldInnovations low{.field = ReportField::low_battery};
  FieldInnovations plugged{.field = ReportField::plugged};
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const Region& known = regions_[i];
    result.reports.push_back(known.last);
    for (std::size_t k = 0; k < measured.size(); ++k) {
      if (known.lies.at(k) && news[i].report != nullptr) {
        const Lie& lie = *known.lies.at(k);
        result.flags.push_back({static_cast<std::int32_t>(i), static_cast<ReportField>(k + 1), lie.kind(),
                                lie.last().reported, rounded(lie.last().estimate), false});
      }
    }
    if (const auto& excess = news[i].excess) {
      if (excess->slack == 0) {
        add(vacant, excess->cars, excess->expected, excess->variance);
      }
      add(low, excess->low, excess->expected_low, excess->variance_low);
      add(plugged, news[i].window.ended, news[i].may_end, news[i].may_end_variance);
    }
  }
  result.innovations = {vacant, low, plugged};
  return result;
}

}  // namespace evbal
