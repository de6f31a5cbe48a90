#include "experiments/bound/bound_front.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace evbal {
namespace {

constexpr double most_gigabytes = 8.0;

/// The memory that the equations of a day's network take: as many numbers for each node as nodes within the longest
/// trip and patience.
void check_size(const BoundDay& day) {
  int patience = 0;
  for (const BoundPassenger& one : day.passengers) {
    patience = std::max(patience, one.last - one.appears);
  }
  const int minutes = day.minutes.maxCoeff() + patience + 2 * day.tick;
  const double reach = static_cast<double>(day.regions()) * std::min(day.ticks, minutes / day.tick);
  const double gigabytes = 8e-9 * reach * day.regions() * day.ticks;
  if (gigabytes > most_gigabytes) {
    throw bad_input("the bound of a day with " + std::to_string(day.regions()) + " regions and ticks of " +
                    std::to_string(day.tick) + " min takes " + std::to_string(std::lround(gigabytes)) +
                    " GB of memory, more than " + std::to_string(std::lround(most_gigabytes)) +
                    "; give it a longer `clock.tick`, or a coarser city");
  }
}

}  // namespace

std::optional<double> BoundPoint::bracket() const {
  if (!up) {
    return std::nullopt;
  }
  return (price * up->lost + up->km - bound) / std::max(1.0, bound);
}

DayBound day_bound(const BoundDay& day, const std::vector<double>& prices,
                   const std::function<bool(const BoundProgress&)>& stop) {
  check_size(day);
  DayBound bound{.passengers = static_cast<int>(day.passengers.size()), .capacity = capacity_bound(day), .points = {}};
  for (const double price : prices) {
    bound.points.push_back({.price = price});
  }
  for (const Rounding rounding : {Rounding::down, Rounding::up}) {
    const TimeNetwork network = time_network(day, rounding);
    std::optional<PricedFlow> before;
    for (std::size_t i = 0; i < prices.size(); ++i) {
      before = priced_flow(network, prices[i], before, [&](const PricedFlow& so_far) {
        return stop({.point = i, .rounding = rounding, .flow = &so_far});
      });
      const PricedFlow& flow = *before;
      BoundPoint& point = bound.points[i];
      const std::optional<Driving> driving = flow.solved ? std::optional(Driving{flow.km, flow.lost}) : std::nullopt;
      if (rounding == Rounding::up) {
        point.up = driving;
      } else {
        // What costs so much at a lower price costs no less at this one.
        point.bound = std::max(flow.bound, i == 0 ? 0.0 : bound.points[i - 1].bound);
        point.tight = flow.solved;
        point.down = driving;
      }
    }
  }
  return bound;
}

DayBound merged(const DayBound& one, const DayBound& other) {
  DayBound both = one;
  for (const BoundPoint& point : other.points) {
    const auto at = std::find_if(both.points.begin(), both.points.end(),
                                 [&](const BoundPoint& known) { return known.price >= point.price; });
    if (at == both.points.end() || at->price > point.price) {
      both.points.insert(at, point);
    } else if (std::tuple(point.complete(), point.bound) > std::tuple(at->complete(), at->bound)) {
      *at = point;
    }
  }
  return both;
}

double fewest_lost(const DayBound& bound, double km) {
  double lost = bound.capacity.lost;
  for (const BoundPoint& point : bound.points) {
    lost = std::max(lost, (point.bound - km) / point.price);
  }
  return lost;
}

std::vector<Driving> bound_corners(const DayBound& bound) {
  const auto& points = bound.points;
  std::vector<double> km = {0.0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    km.push_back(points[i].bound - points[i].price * bound.capacity.lost);
    for (std::size_t j = 0; j < i; ++j) {
      // Where both points' lines cross:  (bound_i - km) / price_i = (bound_j - km) / price_j.
      km.push_back((points[i].bound * points[j].price - points[j].bound * points[i].price) /
                   (points[j].price - points[i].price));
    }
  }
  std::sort(km.begin(), km.end());
  std::vector<Driving> corners;
  for (const double at : km) {
    if (at >= 0.0) {
      corners.push_back({at, fewest_lost(bound, at)});
    }
  }
  return corners;
}

}  // namespace evbal
