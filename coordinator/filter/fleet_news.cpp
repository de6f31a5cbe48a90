#include "coordinator/filter/fleet_filter.hpp"

#include <algorithm>
#include <cmath>

// What is new of each region: what of it was reported, announced, listed and ordered.

namespace evbal {
namespace {

// Of the cars that come free, the share that comes out low before any came, for how many cars that counts, and for how
// many those of the whole city count in a region: regions differ less than their few cars could tell.
constexpr double first_low_share = 0.05;
constexpr double cars_of_the_first = 20.0;
constexpr double cars_of_the_city = 150.0;
// For how many short trips the model's shares count in the city's rate: days and hours differ by a tenth and more.
constexpr double trips_of_the_model = 20.0;

int announced(const std::vector<Effect>& effects, int region, EffectType type) {
  int sum = 0;
  for (const Effect& effect : effects) {
    const bool counts = effect.region == region && effect.type == type && effect.visible;
    sum += counts ? static_cast<int>(std::lround(effect.magnitude)) : 0;
  }
  return sum;
}

}  // namespace

std::vector<FleetFilter::News> FleetFilter::news_of(const Tick& tick, int minute,
                                                    const std::vector<std::optional<Report>>& reports,
                                                    const std::vector<Move>& moves, const WindowOutlook& outlook) {
  std::vector<News> news(regions_.size());
  const double in_city = low_share_.ratio(first_low_share, cars_of_the_first);
  const auto bound = bound_for(tick, static_cast<int>(regions_.size()));
  for (int i = 0; i < static_cast<int>(news.size()); ++i) {
    News& here = news[static_cast<std::size_t>(i)];
    here.report = reports[static_cast<std::size_t>(i)] ? &*reports[static_cast<std::size_t>(i)] : nullptr;
    here.present = std::ranges::find(tick.due, i) != tick.due.end() || here.report != nullptr;
    here.bound = bound[static_cast<std::size_t>(i)];
    here.broken = announced(tick.effects, i, EffectType::fleet_breakdown);
    here.window.low_share = regions_[static_cast<std::size_t>(i)].low_share.ratio(in_city, cars_of_the_city);
    const double window = minute - last_.minute;
    here.window.may_give_up = window > model_.patience ? (window - model_.patience) / window : 0.0;
    count_sessions(minute, i, here);
    const int closed = announced(tick.effects, i, EffectType::charger_outage);
    const int blocked = announced(tick.effects, i, EffectType::charger_block);
    here.points =
        std::max({0, std::max(0, model_.points(i) - closed) - blocked, static_cast<int>(here.plugged_since.size())});
  }
  if (begun_) {
    add_road_traffic(moves, minute, news);
    add_short_trips(outlook, news);
  }
  return news;
}

void FleetFilter::count_sessions(int minute, int region, News& news) const {
  const Region& known = regions_[static_cast<std::size_t>(region)];
  std::vector<int> since = known.last.plugged_since;
  for (const int begun : since) {
    const double ends = model_.share_that_ends(last_.minute - begun, minute - last_.minute);
    news.may_end += ends;
    news.may_end_variance += ends * (1.0 - ends);
  }
  if (news.report != nullptr) {
    const auto& now = news.report->plugged_since;
    const auto begun = std::ranges::count_if(now, [&](int minute_since) { return minute_since >= last_.minute; });
    const auto stayed = static_cast<std::ptrdiff_t>(now.size()) - begun;
    news.window.begun = static_cast<double>(begun);
    news.window.ended = static_cast<double>(std::max<std::ptrdiff_t>(0, std::ssize(since) - stayed));
    news.plugged_since = now;
    return;
  }
  const double free = std::max(0.0, known.last.points - static_cast<double>(since.size()) + news.may_end);
  news.window.ended = news.may_end;
  news.window.ended_variance = news.may_end_variance;
  news.window.begun = std::min(known.counts.low_battery, free);
  news.window.begun_variance = news.window.begun;
  // Who has been plugged in longest leaves first; who came since is taken to have come now.
  const auto left = std::min<std::ptrdiff_t>(std::ssize(since), std::lround(news.window.ended));
  since.erase(since.begin(), since.begin() + left);
  since.resize(since.size() + static_cast<std::size_t>(std::lround(news.window.begun)), minute);
  news.plugged_since = std::move(since);
}

void FleetFilter::add_road_traffic(const std::vector<Move>& moves, int minute, std::vector<News>& news) {
  last_.moves.clear();
  std::ranges::copy_if(moves, std::back_inserter(last_.moves),
                       [&](const Move& move) { return std::ranges::find(unplanned_, move.from) == unplanned_.end(); });
  std::vector<std::vector<UnderWay>> now;
  now.reserve(news.size());
  for (const News& here : news) {
    now.push_back(here.bound);
  }
  const RoadTraffic traffic = traffic_since(last_, now, minute, model_.minutes);
  for (std::size_t i = 0; i < news.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    RegionWindow& window = news[i].window;
    window.came_vacant = traffic.came_vacant(row);
    window.came_low = traffic.came_low(row);
    window.left_vacant = traffic.left_vacant(row) + news[i].broken - regions_[i].broken;
    window.left_low = traffic.left_low(row);
    window.topped_up = traffic.topped_up(row);
    window.slack = std::max(news[i].broken, regions_[i].broken) + traffic.may_stay(row);
  }
}

void FleetFilter::add_short_trips(const WindowOutlook& outlook, std::vector<News>& news) const {
  std::vector<double> begun(news.size());
  for (std::size_t i = 0; i < news.size(); ++i) {
    begun[i] = picked_up(static_cast<int>(i), news[i], outlook).expected;
  }
  for (const ShortTrips& trips : outlook.short_trips) {
    news[static_cast<std::size_t>(trips.to)].usual_drop_offs +=
        trips.share * begun[static_cast<std::size_t>(trips.from)];
  }
  const double rate = trip_rate_.ratio(1.0, trips_of_the_model);
  for (News& here : news) {
    here.window.dropped_off = rate * here.usual_drop_offs;
  }
}

}  // namespace evbal
