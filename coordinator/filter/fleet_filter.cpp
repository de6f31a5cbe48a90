#include "coordinator/filter/fleet_filter.hpp"

#include "coordinator/filter/count_law.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr int most_passengers = 1'000'000;  ///< that a report can speak of
// Of the cars that came free, by report, in the share that comes out low.
constexpr double kept_in_city = 0.6;
constexpr double kept_in_region = 0.9;
constexpr double kept_of_trips = 0.9;       ///< likewise of short trips, in their rate
constexpr double surprise_of_a_lie = 10.0;  ///< from which on a count of them is left out of it
constexpr double unknown = 1e4;             ///< variance of a count of which nothing is known
constexpr double least_deviation = 0.7;     ///< of the fleet's balance
// Surprise up to which numbers of cars change as they should, from which on they do not, for how many reports in a row
// they have to before they are followed, and with what variance.
constexpr double surprise_of_steady = 3.0;
constexpr double surprise_of_jump = 5.0;
constexpr int steady_enough = 2;
constexpr double noise_of_steady = 0.01;
constexpr double most_deviations = 3.0;  ///< likewise, if the estimates are to be trusted with it

int value_of(const Report& report, ReportField field) {
  return report.*measured.at(index_of(field)).member;
}

ReportField field_at(std::size_t index) {
  return static_cast<ReportField>(index + 1);
}

RegionCounts cars_of(const Report& report, double waiting) {
  return {static_cast<double>(report.vacant), static_cast<double>(report.low_battery), 0.0, waiting};
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
  city_gained(news);
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
      disbelieve({region, field, 0.0, 0.0, 0.0}, news);
    }
  }
}

/// Adds what a report of cars that are believed is evidence of. If demand is not believed, only cars that are too many
/// without any passenger are.
void FleetFilter::weigh(int region, News& news, const WindowOutlook& outlook) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  const auto waiting = believed(region, news, ReportField::waiting);
  if (!begun_ || known.stock || !waiting || !believes_cars(region, news)) {
    return;
  }
  const auto demand = believed(region, news, ReportField::demand);
  const double said = std::clamp(news.report->demand, 0, most_passengers);
  Excess excess = excess_of(known.counts, news.window, cars_of(*news.report, *waiting), said);
  const double off = excess.cars - excess.expected + (demand ? 0.0 : known.doubt.cars);
  excess.passengers =
      favours_passengers(excess, off, said, outlook.demand(region), outlook.demand_dispersion * outlook.demand(region));
  if (demand) {
    news.excess = excess;
  } else {
    known.doubt.passengers += excess.passengers;
    known.doubt.cars = off;
    excess.cars = std::max(0, static_cast<int>(excess.cars - said));
  }
  known.evidence.add(excess);
  news.weighed = true;
}

void FleetFilter::follow(int region, News& news, const WindowOutlook& outlook) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  weigh(region, news, outlook);
  if (retry(region, news)) {
    return;
  }
  if (believes_cars(region, news)) {
    known.stock.reset();
    return;
  }
  known.evidence.clear();
  if (!begun_) {
    known.stock.emplace(StockVector::Zero(), StockVector::Constant(unknown));
  } else {
    if (!known.stock) {
      known.stock.emplace(stock_of(known.counts, count_of(news.bound, Errand::passenger)), StockVector::Zero());
      known.doubt = {};
    }
    const StockChange now = change_of(region, news, outlook);
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

/// What comes and goes where the numbers of cars are not believed: by the balance, or by these very numbers if they
/// have changed as they should for some time, since what is off by a constant tells changes.
StockChange FleetFilter::change_of(int region, const News& news, const WindowOutlook& outlook) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  StockChange now = stock_change(news.window, picked_up(region, news, outlook));
  const auto waiting = believed(region, news, ReportField::waiting);
  const auto demand = believed(region, news, ReportField::demand);
  const auto possible = [&](const RegionCounts& cars) {
    return std::min(cars.vacant, cars.low_battery) >= 0.0 && std::max(cars.vacant, cars.low_battery) <= model_.vehicles;
  };
  if (!known.heard || !waiting || !demand || !possible(*known.heard) || !possible(cars_of(*news.report, 0.0))) {
    known.doubt.steady = 0;
    known.doubt.jumped = true;
    return now;
  }
  RegionCounts before = *known.heard;
  before.waiting = known.counts.waiting;
  const RegionCounts reported = cars_of(*news.report, *waiting);
  const Excess excess = excess_of(before, news.window, reported, *demand);
  const double surprised =
      std::max(surprise(excess.cars, excess.expected, excess.slack), surprise(excess.low, excess.expected_low, 0));
  const auto rests = [&](ReportField field, double change, CarKind kind) {
    return !believed(region, news, field) && change == 0.0 && std::abs(now.change(static_cast<int>(kind))) >= 1.0;
  };
  const double vacant = reported.vacant - before.vacant;
  const double low = reported.low_battery - before.low_battery;
  const bool steady = surprised < surprise_of_steady && !rests(ReportField::vacant, vacant, CarKind::vacant) &&
                      !rests(ReportField::low_battery, low, CarKind::low_battery);
  const double off = news.cars() - total(known.stock->counts() + now.change);
  known.doubt.passengers += favours_passengers(excess, off, *demand, outlook.demand(region),
                                               outlook.demand_dispersion * outlook.demand(region));
  known.doubt.steady = steady ? known.doubt.steady + 1 : 0;
  known.doubt.jumped = known.doubt.jumped || surprised > surprise_of_jump;
  if (known.doubt.steady >= steady_enough) {
    now.change(static_cast<int>(CarKind::vacant)) = vacant;
    now.change(static_cast<int>(CarKind::low_battery)) = low;
    now.noise = StockMatrix::Identity() * noise_of_steady;
  }
  return now;
}

/// The share of cars that come out low, and how many short trips end, from the regions whose reports tell it.
void FleetFilter::learn(const std::vector<News>& news) {
  double free = 0.0;
  double low = 0.0;
  double usual_drop_offs = 0.0;
  double drop_offs = 0.0;
  for (std::size_t i = 0; i < news.size(); ++i) {
    const auto& excess = news[i].excess;
    if (!excess || !believes_cars(static_cast<int>(i), news[i])) {
      continue;
    }
    const double free_here = come_free(news[i].window);
    const double low_here = std::clamp(static_cast<double>(excess->low), 0.0, free_here);
    regions_[i].low_share.add(free_here, low_here, kept_in_region);
    free += free_here;
    low += low_here;
    if (excess->slack == 0 && surprise(excess->cars, excess->expected, 0) < surprise_of_a_lie) {
      usual_drop_offs += news[i].usual_drop_offs;
      drop_offs += excess->cars;
    }
  }
  low_share_.add(free, low, kept_in_city);
  trip_rate_.add(usual_drop_offs, drop_offs, kept_of_trips);
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
      cars += news[i].cars();
    }
  }
  return {cars, std::sqrt(variance)};
}

/// Cars that the city came to have too many of since this was asked last; evidence that is open takes note of it.
double FleetFilter::city_gained(const std::vector<News>& news) {
  const double cars = surplus(news).value;
  const double gained = cars - unexplained_;
  for (Region& known : regions_) {
    known.evidence.add_city(gained);
  }
  unexplained_ = cars;
  return gained;
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
