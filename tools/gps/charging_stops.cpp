#include "tools/gps/charging_stops.hpp"

#include "tools/gps/rides.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace evbal {
namespace {

constexpr double kSamePlace = 10.0;  // m: fixes so close are one stand
constexpr double kSpot = 30.0;       // m: a charging point, with the error of GPS

}  // namespace

StationMap::StationMap(const std::vector<Station>& stations, double within_m)
    : frame_(stations.front().place), within_m_(within_m) {
  for (std::size_t s = 0; s < stations.size(); ++s) {
    places_.push_back(frame_.local(stations[s].place));
    squares_[square_of(places_.back())].push_back(static_cast<int>(s));
  }
}

std::pair<int, int> StationMap::square_of(LocalPoint place) const {
  return {static_cast<int>(std::floor(place.east / within_m_)), static_cast<int>(std::floor(place.north / within_m_))};
}

std::vector<int> StationMap::around(LocalPoint place) const {
  std::vector<int> near;
  const auto [x, y] = square_of(place);
  for (int dx = -1; dx <= 1; ++dx) {
    const auto end = squares_.upper_bound({x + dx, y + 1});
    for (auto square = squares_.lower_bound({x + dx, y - 1}); square != end; ++square) {
      std::copy_if(square->second.begin(), square->second.end(), std::back_inserter(near),
                   [&](int station) { return metres(station, place) <= within_m_; });
    }
  }
  std::sort(near.begin(), near.end());
  return near;
}

std::vector<ChargingStop> StopFinder::add(const Fix& fix) {
  const bool torn = last_ && static_cast<double>(fix.time - last_->time) > 60.0 * rule_.longest_gap &&
                    metres_between(*last_, fix) > rule_.moved_m;
  last_ = fix;
  std::vector<ChargingStop> found;
  if (torn || fix.occupied) {
    found = leave();
  }
  if (fix.occupied) {
    return found;
  }
  const LocalPoint place = stations_.local(fix.place);
  const std::vector<int> near = stations_.around(place);
  for (const Stay& stay : open_) {
    if (!std::binary_search(near.begin(), near.end(), stay.station)) {
      ended_.push_back(stay);
      ended_.back().last = stands_.size() - 1;
    }
  }
  std::erase_if(open_, [&](const Stay& stay) { return !std::binary_search(near.begin(), near.end(), stay.station); });
  if (near.empty()) {
    const auto stops = leave();
    found.insert(found.end(), stops.begin(), stops.end());
    return found;
  }
  if (open_.size() == near.size() && distance(stands_.back().place, place) <= kSamePlace) {
    stands_.back().until = fix.time;
    return found;
  }
  stands_.push_back({place, fix.time, fix.time});
  for (const int station : near) {
    if (std::none_of(open_.begin(), open_.end(), [&](const Stay& stay) { return stay.station == station; })) {
      open_.push_back({station, stands_.size() - 1, 0});
    }
  }
  return found;
}

std::optional<long long> StopFinder::open_since() const {
  return stands_.empty() ? std::nullopt : std::optional(stands_.front().from);
}

double StopFinder::seconds_at(std::size_t stand, const Stay& stay) const {
  const long long until = stand < stay.last ? stands_[stand + 1].from : stands_[stand].until;
  return static_cast<double>(until - stands_[stand].from);
}

LocalPoint StopFinder::longest_stand(const Stay& stay) const {
  struct Sums {
    double seconds = 0.0;
    double east = 0.0;
    double north = 0.0;

    void add(LocalPoint place, double lasted) {
      seconds += lasted;
      east += lasted * place.east;
      north += lasted * place.north;
    }
    LocalPoint mean() const { return {east / seconds, north / seconds}; }
  };
  std::map<std::pair<int, int>, Sums> squares;
  for (std::size_t s = stay.first; s <= stay.last; ++s) {
    const LocalPoint at = stands_[s].place;
    const std::pair square(static_cast<int>(std::floor(at.east / kSpot)),
                           static_cast<int>(std::floor(at.north / kSpot)));
    squares[square].add(at, seconds_at(s, stay));
  }
  const auto longest = std::max_element(
      squares.begin(), squares.end(), [](const auto& a, const auto& b) { return a.second.seconds < b.second.seconds; });
  const LocalPoint middle = longest->second.mean();
  Sums around;
  for (std::size_t s = stay.first; s <= stay.last; ++s) {
    if (distance(stands_[s].place, middle) <= kSpot) {
      around.add(stands_[s].place, seconds_at(s, stay));
    }
  }
  return around.seconds > 0.0 ? around.mean() : middle;
}

long long StopFinder::charge_start(const Stay& stay, LocalPoint spot) const {
  const auto at_spot = [&](std::size_t s) { return distance(stands_[s].place, spot) <= kSpot; };
  for (std::size_t s = stay.first; s <= stay.last; ++s) {
    const bool stands_on = stands_[s].until > stands_[s].from || (s < stay.last && at_spot(s + 1));
    if (at_spot(s) && stands_on) {
      return stands_[s].from;
    }
  }
  return stands_[stay.first].from;
}

std::vector<ChargingStop> StopFinder::leave() {
  for (Stay& stay : open_) {
    stay.last = stands_.size() - 1;
    ended_.push_back(stay);
  }
  struct Candidate {
    double metres = 0.0;
    Stay stay;
    LocalPoint spot;
  };
  std::vector<Candidate> candidates;
  for (const Stay& stay : ended_) {
    if (static_cast<double>(stands_[stay.last].until - stands_[stay.first].from) > 60.0 * rule_.longer_than) {
      const LocalPoint spot = longest_stand(stay);
      candidates.push_back({stations_.metres(stay.station, spot), stay, spot});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.metres, a.stay.station, a.stay.first) < std::tie(b.metres, b.stay.station, b.stay.first);
  });
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : candidates) {
    if (std::none_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
          return candidate.stay.first <= other.stay.last && other.stay.first <= candidate.stay.last;
        })) {
      chosen.push_back(candidate);
    }
  }
  std::vector<ChargingStop> stops;
  stops.reserve(chosen.size());
  for (const auto& [metres, stay, spot] : chosen) {
    stops.push_back({stay.station, stands_[stay.first].from, charge_start(stay, spot), stands_[stay.last].until});
  }
  std::sort(stops.begin(), stops.end(),
            [](const ChargingStop& a, const ChargingStop& b) { return a.arrival < b.arrival; });
  stands_.clear();
  open_.clear();
  ended_.clear();
  return stops;
}

}  // namespace evbal
