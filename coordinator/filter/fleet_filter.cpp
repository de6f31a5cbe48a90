#include "coordinator/filter/fleet_filter.hpp"

#include "coordinator/filter/count_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace evbal {
namespace {

constexpr int most_passengers = 1'000'000;  ///< that a report can speak of
// Of the cars that came free, by report, in the share that comes out low.
constexpr double kept_in_city = 0.6;
constexpr double kept_in_region = 0.9;
constexpr double unknown = 1e4;           ///< variance of a count of which nothing is known
constexpr double suspicion_enough = 3.0;  ///< of one region before all others: 20 to 1
constexpr double most_suspicion = 6.0;    ///< by one report
constexpr double first_doubt = 0.3;  ///< variance of a count that was just found to be wrong, beside the evidence's
constexpr double certain_deviations = 2.0;  ///< of that balance, beyond which it says that somebody lies
constexpr double least_deviation = 0.7;     ///< of that balance
constexpr double most_deviations = 3.0;     ///< of the fleet's balance, if the estimates are to be trusted with it

int value_of(const Report& report, ReportField field) {
  return report.*measured.at(index_of(field)).member;
}

ReportField field_at(std::size_t index) {
  return static_cast<ReportField>(index + 1);
}

/// By how much likelier a count becomes, as a logarithm, if `gained` of it are a lie; one report convinces nobody
/// alone.
double likelier(int count, int gained, double expected, int slack) {
  return std::clamp(log_probability(count - gained, expected, slack) - log_probability(count, expected, slack),
                    -most_suspicion, most_suspicion);
}

StockVector stock_of(const RegionCounts& counts, const std::vector<UnderWay>& bound) {
  return {counts.vacant, static_cast<double>(count_of(bound, Errand::passenger)), counts.low_battery, counts.plugged};
}

}  // namespace

FleetFilter::FleetFilter(FilterModel model) : model_(std::move(model)) {
  regions_.resize(static_cast<std::size_t>(model_.points.size()));
  for (Eigen::Index i = 0; i < model_.points.size(); ++i) {
    regions_[static_cast<std::size_t>(i)].last.region = static_cast<std::int32_t>(i);
    regions_[static_cast<std::size_t>(i)].last.points = model_.points(i);
  }
}

FleetFilter::Result FleetFilter::observe(const Tick& tick, int minute,
                                         const std::vector<std::optional<Report>>& reports,
                                         const std::vector<Move>& moves, const WindowOutlook& outlook) {
  std::vector<News> news = news_of(tick, minute, reports, moves, outlook);
  const int n = static_cast<int>(regions_.size());
  for (int i = 0; i < n; ++i) {
    notice_impossible(i, news[static_cast<std::size_t>(i)]);
    follow(i, news[static_cast<std::size_t>(i)], outlook);
  }
  find_lies(news);
  learn(news);
  balance_fleet(news);
  unexplained_ = surplus(news).value;
  for (int i = 0; i < n; ++i) {
    settle(tick.tick, i, news[static_cast<std::size_t>(i)], outlook);
  }
  last_ = {minute, {}, {}, Eigen::VectorXd(n), Eigen::VectorXd(n), {}};
  for (int i = 0; i < n; ++i) {
    last_.bound.push_back(std::move(news[static_cast<std::size_t>(i)].bound));
    last_.vacant(i) = regions_[static_cast<std::size_t>(i)].counts.vacant;
    last_.low_battery(i) = regions_[static_cast<std::size_t>(i)].counts.low_battery;
    last_.estimated.push_back(regions_[static_cast<std::size_t>(i)].stock.has_value());
  }
  unplanned_ = tick.unplanned;
  begun_ = true;
  return result(news);
}

Eigen::VectorXd FleetFilter::variance() const {
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(model_.points.size());
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].stock) {
      variance(static_cast<Eigen::Index>(i)) = regions_[i].stock->covariance()(0, 0);
    }
  }
  return variance;
}

/// What the field says, if it is believed.
std::optional<double> FleetFilter::believed(int region, const News& news, ReportField field) const {
  const bool lies = regions_[static_cast<std::size_t>(region)].lies.at(index_of(field)).has_value();
  return news.report == nullptr || lies ? std::nullopt : std::optional<double>(value_of(*news.report, field));
}

bool FleetFilter::believes_cars(int region, const News& news) const {
  return believed(region, news, ReportField::vacant) && believed(region, news, ReportField::low_battery);
}

/// By who waited, who appeared and who waits now, where that is believed; no more than there can be cars.
PickUps FleetFilter::picked_up(int region, const News& news, const WindowOutlook& outlook) const {
  const RegionCounts& before = regions_[static_cast<std::size_t>(region)].counts;
  if (!news.present) {
    return {};
  }
  const RegionWindow& window = news.window;
  const double cars = std::max(0.0, before.vacant + window.came_vacant + window.ended - window.left_vacant);
  const auto appeared = believed(region, news, ReportField::demand);
  const auto waiting = believed(region, news, ReportField::waiting);
  const double demand = appeared.value_or(outlook.demand(region));
  const double lost = given_up(before, window);
  const double wanted = before.waiting + demand - waiting.value_or(0.0) - lost;
  return {std::clamp(wanted, 0.0, cars), lost + (appeared ? 0.0 : outlook.demand_dispersion * demand) +
                                             (waiting ? 0.0 : std::max(1.0, wanted - cars))};
}

/// A number that cannot be, or not beside what is listed and announced, is a lie at once.
void FleetFilter::notice_impossible(int region, const News& news) {
  if (news.report == nullptr) {
    return;
  }
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const ReportField field = field_at(k);
    const int value = value_of(*news.report, field);
    const bool cars = field == ReportField::vacant || field == ReportField::low_battery ||
                      field == ReportField::plugged || field == ReportField::chargeable;
    const bool possible = value >= 0 && value <= (cars ? model_.vehicles : most_passengers) &&
                          (field != ReportField::plugged || value == std::ssize(news.plugged_since)) &&
                          (field != ReportField::points || value == news.points);
    if (!possible && !regions_[static_cast<std::size_t>(region)].lies.at(k)) {
      disbelieve(region, news, field);
    }
  }
}

void FleetFilter::follow(int region, News& news, const WindowOutlook& outlook) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  if (believes_cars(region, news)) {
    const auto waiting = believed(region, news, ReportField::waiting);
    const auto demand = believed(region, news, ReportField::demand);
    if (begun_ && !known.stock && waiting && demand) {
      const RegionCounts reported{static_cast<double>(news.report->vacant),
                                  static_cast<double>(news.report->low_battery), 0.0, *waiting};
      news.excess = excess_of(known.counts, news.window, reported, *demand);
      known.evidence.add(*news.excess);
    }
    known.stock.reset();
    return;
  }
  known.evidence.clear();
  if (!begun_) {
    known.stock.emplace(StockVector::Zero(), StockVector::Constant(unknown));
  } else {
    if (!known.stock) {
      known.stock.emplace(stock_of(known.counts, news.bound), StockVector::Zero());
    }
    const StockChange now = stock_change(news.window, picked_up(region, news, outlook));
    known.stock->predict(now.change, now.noise);
  }
  std::array<std::optional<double>, stocks> seen;
  seen.at(static_cast<int>(CarKind::vacant)) = believed(region, news, ReportField::vacant);
  seen.at(static_cast<int>(CarKind::low_battery)) = believed(region, news, ReportField::low_battery);
  seen.at(static_cast<int>(CarKind::occupied_due)) = count_of(news.bound, Errand::passenger);
  if (news.report != nullptr) {
    seen.at(static_cast<int>(CarKind::plugged)) = static_cast<double>(news.plugged_since.size());
  }
  known.stock->observe(seen);
}

/// The share of cars that come out low, from the regions whose reports tell it.
void FleetFilter::learn(const std::vector<News>& news) {
  double all_free = 0.0;
  double all_low = 0.0;
  for (std::size_t i = 0; i < news.size(); ++i) {
    if (news[i].excess && believes_cars(static_cast<int>(i), news[i])) {
      const double free = come_free(news[i].window);
      const double low = std::clamp(static_cast<double>(news[i].excess->low), 0.0, free);
      regions_[i].low_share.add(free, low, kept_in_region);
      all_free += free;
      all_low += low;
    }
  }
  low_share_.add(all_free, all_low, kept_in_city);
}

/// Cars too many by all that is believed and estimated, against the fleet.
FleetFilter::Estimate FleetFilter::surplus(const std::vector<News>& news) const {
  double cars = -model_.vehicles;
  double variance = 0.0;
  for (std::size_t i = 0; i < news.size(); ++i) {
    const Region& known = regions_[i];
    for (const Errand errand : {Errand::passenger, Errand::rebalance, Errand::charge}) {
      cars += count_of(news[i].bound, errand);
    }
    cars += news[i].broken;
    variance += news[i].broken;
    if (known.stock) {
      cars += total(known.stock->counts());
      variance += total_variance(known.stock->covariance());
    } else {
      cars += news[i].report->vacant + news[i].report->low_battery + static_cast<double>(news[i].plugged_since.size());
    }
  }
  return {cars, std::sqrt(variance)};
}

/// Whom the evidence accuses. Where there is enough by itself it is a number of cars, unless the city's cars come out
/// better without: then it is a number of passengers. Where there is less, it is a number of cars that explains what
/// the city has gained or lost.
std::vector<std::pair<int, ReportField>> FleetFilter::accused(const std::vector<News>& news) const {
  const auto evidence_of = [&](int region) -> const Evidence& {
    return regions_[static_cast<std::size_t>(region)].evidence;
  };
  std::vector<int> open;
  const Estimate now = surplus(news);
  double left = now.value;
  for (int i = 0; i < static_cast<int>(news.size()); ++i) {
    if (news[static_cast<std::size_t>(i)].excess && evidence_of(i).enough_to_explain()) {
      open.push_back(i);
      left -= evidence_of(i).enough() ? evidence_of(i).cars() : 0.0;
    }
  }
  std::ranges::stable_sort(open, std::ranges::greater{}, [&](int i) { return std::abs(evidence_of(i).cars()); });
  const bool gained = std::abs(now.value - unexplained_) > certain_deviations * now.deviation;
  std::vector<std::pair<int, ReportField>> found;
  for (const int region : open) {
    const Evidence& evidence = evidence_of(region);
    const double cars = evidence.cars();
    const auto better = [&](double without) { return std::abs(without) < std::abs(left) - std::abs(cars) / 2.0; };
    const bool passengers = evidence.enough() && better(left + cars);
    const bool counted = evidence.enough() ? !passengers : gained && better(left - cars);
    if (passengers) {
      left += cars;
    }
    if (counted) {
      left -= evidence.enough() ? 0.0 : cars;
      found.emplace_back(region,
                         evidence.low() * cars > cars * cars / 2.0 ? ReportField::low_battery : ReportField::vacant);
    } else if (passengers && evidence.enough_against_passengers()) {
      found.emplace_back(region, passengers_field(region, news[static_cast<std::size_t>(region)]));
    }
  }
  return found;
}

/// Too few cars are too many passengers who wait if somebody waits beside a vacant car; too many are too few of them if
/// nobody waits where there is none; else demand is wrong.
ReportField FleetFilter::passengers_field(int region, const News& news) const {
  const bool waits = news.report->waiting > 0;
  const bool vacant = news.report->vacant > 0;
  const bool too_few = regions_[static_cast<std::size_t>(region)].evidence.cars() < 0.0;
  return waits == vacant && waits == too_few ? ReportField::waiting : ReportField::demand;
}

void FleetFilter::find_lies(const std::vector<News>& news) {
  for (const auto& [region, field] : accused(news)) {
    disbelieve(region, news[static_cast<std::size_t>(region)], field);
  }
  if (const auto culprit = suspected(news)) {
    disbelieve(culprit->first, news[static_cast<std::size_t>(culprit->first)], culprit->second);
  }
}

/// If the city has gained or lost cars, a number of cars lies somewhere, be it by little: that of the region where so
/// many too many are likely, and likelier than anywhere else.
std::optional<std::pair<int, ReportField>> FleetFilter::suspected(const std::vector<News>& news) {
  const Estimate now = surplus(news);
  const int gained = static_cast<int>(std::lround(now.value - unexplained_));
  const bool told = gained != 0 && std::abs(gained) > certain_deviations * now.deviation;
  std::vector<std::pair<double, int>> ranked;
  for (std::size_t i = 0; i < news.size(); ++i) {
    Region& known = regions_[i];
    if (!news[i].excess || std::abs(now.value) < 0.5) {
      known.suspicion = known.suspicion_of_low = 0.0;
    } else if (told) {
      const Excess& excess = *news[i].excess;
      known.suspicion += likelier(excess.cars, gained, excess.expected, excess.slack);
      known.suspicion_of_low += likelier(excess.low, gained, excess.expected_low, 0);
    }
    ranked.emplace_back(known.suspicion, static_cast<int>(i));
  }
  std::ranges::partial_sort(ranked, ranked.begin() + std::min<std::ptrdiff_t>(2, std::ssize(ranked)),
                            std::ranges::greater{});
  if (!told || ranked.front().first < suspicion_enough ||
      (ranked.size() > 1 && ranked[0].first - ranked[1].first < suspicion_enough)) {
    return std::nullopt;
  }
  Region& culprit = regions_[static_cast<std::size_t>(ranked.front().second)];
  culprit.evidence.conclude(now.value);
  const ReportField field = culprit.suspicion_of_low > 0.0 ? ReportField::low_battery : ReportField::vacant;
  culprit.suspicion = culprit.suspicion_of_low = 0.0;
  return std::pair(ranked.front().second, field);
}

void FleetFilter::disbelieve(int region, const News& news, ReportField field) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  std::deque<double> before;
  for (const Fields& past : known.past) {
    before.push_back(past.at(index_of(field)));
  }
  known.lies.at(index_of(field)).emplace(std::move(before));
  if (news.excess && (field == ReportField::vacant || field == ReportField::low_battery)) {
    RegionCounts counts{static_cast<double>(news.report->vacant), static_cast<double>(news.report->low_battery),
                        static_cast<double>(news.plugged_since.size()), 0.0};
    (field == ReportField::vacant ? counts.vacant : counts.low_battery) -= known.evidence.cars();
    StockVector variances = StockVector::Zero();
    variances(static_cast<int>(field == ReportField::vacant ? CarKind::vacant : CarKind::low_battery)) =
        known.evidence.variance() + first_doubt;
    known.stock.emplace(stock_of(counts, news.bound), variances);
  }
  known.evidence.clear();
}

/// Each estimated region takes its share of the surplus, unless that is more than estimates can be wrong by: then
/// somebody else's lie, which is not found yet, is the reason.
void FleetFilter::balance_fleet(const std::vector<News>& news) {
  const Estimate all = surplus(news);
  if (all.deviation == 0.0 || std::abs(all.value) > most_deviations * std::max(least_deviation, all.deviation)) {
    return;
  }
  for (Region& known : regions_) {
    if (known.stock) {
      const double own = total_variance(known.stock->covariance());
      const double others = std::max(0.0, all.deviation * all.deviation - own);
      known.stock->observe_total(total(known.stock->counts()) - all.value, others);
    }
  }
}

}  // namespace evbal
