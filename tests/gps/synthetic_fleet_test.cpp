// A fleet whose every move is known: what its fixes tell must be what it did.

#include "common/random.hpp"
#include "tools/gps/track.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace evbal {
namespace {

constexpr int kRegions = 4;
constexpr int kVehicles = 25;
constexpr int kDays = 8;
constexpr int kStepsPerDay = 38;
constexpr long long kFirstMorning = 1'211'112'000;  // 2008-05-18 05:00, seven hours behind UTC
constexpr long long kStep = 1800;
constexpr double kMetre = 1.0 / 111'195.0;  // degrees of latitude

/// Regions are squares of 0.02 degrees in a row, with a station in the middle of every other one.
LatLon middle(int region) {
  return {37.71, -122.49 + 0.02 * region};
}

std::vector<Region> regions() {
  std::vector<Region> all;
  for (int r = 0; r < kRegions; ++r) {
    const LatLon at = middle(r);
    all.push_back({"r" + std::to_string(r),
                   {{{at.lat - 0.01, at.lon - 0.01},
                     {at.lat - 0.01, at.lon + 0.01},
                     {at.lat + 0.01, at.lon + 0.01},
                     {at.lat + 0.01, at.lon - 0.01}}},
                   at});
  }
  return all;
}

/// Chances from a vacant vehicle of any region: vacant in each region, occupied to each, charging in regions 0 and 2.
constexpr std::array<double, 2 * kRegions + 2> kFromVacant{0.3, 0.1, 0.1, 0.05, 0.15, 0.1, 0.05, 0.05, 0.04, 0.06};
constexpr double kRideGoesOn = 0.3;
constexpr int kChargingSteps = 3;

struct Charge {
  int vehicle = 0;
  int station = 0;
  long long arrival = 0;
  long long start = 0;
  long long end = 0;
};

/// Lives the days of one vehicle: its state changes at full steps only.
class Driver {
 public:
  explicit Driver(int vehicle)
      : vehicle_(vehicle), random_(7, Purpose::synthetic_city, {static_cast<unsigned>(vehicle)}) {}

  std::vector<Fix> fixes;
  std::vector<Charge> charges;

  void live() {
    const auto offset = static_cast<long long>(random_.below(60));
    for (int day = 0; day < kDays; ++day) {
      car_ = {CarState::vacant, static_cast<int>(random_.below(kRegions))};
      for (int step = 0; step < kStepsPerDay; ++step) {
        const long long begin = kFirstMorning + day * 86'400LL + step * kStep;
        begin_step(begin);
        for (long long time = begin + offset; time < begin + kStep; time += 60) {
          add_fix(time);
        }
      }
      if (car_.state == CarState::plugged) {
        end_at_night();
      }
    }
  }

 private:
  /// The last step alone is too short a stay.
  void end_at_night() {
    charges.back().end = begin_ + kStep;
    if (charges.back().end - charges.back().arrival == kStep) {
      charges.pop_back();
    }
  }

  void begin_step(long long begin) {
    begin_ = begin;
    if (car_.state == CarState::plugged && --charging_steps_ > 0) {
      return;
    }
    if (car_.state == CarState::occupied && random_.uniform() < kRideGoesOn) {
      return;
    }
    const CarState before = car_.state;
    car_.state = CarState::vacant;
    if (before == CarState::vacant) {
      draw();
    }
    // 300 to 800 m from the middle: never near a station.
    const double away = random_.uniform(300.0, 800.0) * kMetre;
    const double angle = random_.uniform(0.0, 6.28);
    place_ = {middle(car_.region).lat + away * std::sin(angle), middle(car_.region).lon + away * std::cos(angle)};
    // Some of the free ones stand near the station, too shortly to charge.
    decoy_ = car_.state == CarState::vacant && random_.uniform() < 0.2;
    outage_ = random_.uniform() < 0.1 ? begin + static_cast<long long>(random_.below(kStep)) : 0;
  }

  void draw() {
    const auto next = static_cast<int>(random_.weighted(kFromVacant));
    if (next < kRegions) {
      car_.region = next;
    } else if (next < 2 * kRegions) {
      car_ = {CarState::occupied, next - kRegions};
    } else {
      const int station = next - 2 * kRegions;
      car_ = {CarState::plugged, 2 * station};
      charging_steps_ = kChargingSteps;
      charges.push_back({vehicle_, station, begin_, begin_ + 12 * 60, begin_ + kChargingSteps * kStep});
    }
  }

  LatLon place(long long time) const {
    const LatLon at = middle(car_.region);
    if (car_.state == CarState::plugged) {  // a queue of 12 min, 120 m from the point
      return {at.lat + (time < charges.back().start ? 150.0 : 30.0) * kMetre, at.lon};
    }
    return decoy_ && time < begin_ + 20 * 60 ? LatLon{at.lat - 150.0 * kMetre, at.lon} : place_;
  }

  void add_fix(long long time) {
    if (outage_ > 0 && time >= outage_ && time < outage_ + 20 * 60) {
      return;
    }
    const LatLon at = place(time);
    const double noise = 5.0 * kMetre;
    fixes.push_back({time,
                     {at.lat + noise * random_.normal(), at.lon + noise * random_.normal()},
                     car_.state == CarState::occupied});
  }

  int vehicle_;
  RandomStream random_;
  CarPlace car_;
  long long begin_ = 0;
  int charging_steps_ = 0;
  LatLon place_;
  bool decoy_ = false;
  long long outage_ = 0;
};

class SyntheticFleet : public testing::Test {
 protected:
  SyntheticFleet()
      : map_(regions(), {{"a", 0, 2, middle(0)}, {"b", 2, 2, middle(2)}}, LocalClock(-420), ChargingRule()),
        counter_(kRegions) {
    for (int vehicle = 0; vehicle < kVehicles; ++vehicle) {
      Driver driver(vehicle);
      driver.live();
      charged_.insert(charged_.end(), driver.charges.begin(), driver.charges.end());
      Track track(map_);
      const auto keep = [&](const TrackEvents& events) {
        for (const ChargingStop& stop : events.stops) {
          found_.push_back({vehicle, stop.station, stop.arrival, stop.start, stop.end});
        }
      };
      for (const Fix& fix : driver.fixes) {
        keep(track.add(fix, counter_));
      }
      keep(track.finish(counter_));
    }
  }

  TrackMap map_;
  TransitionCounter counter_;
  std::vector<Charge> charged_;
  std::vector<Charge> found_;
};

bool same(const Charge& a, const Charge& b) {
  return a.vehicle == b.vehicle && a.station == b.station && a.arrival < b.end && b.arrival < a.end;
}

double share_with_a_match(const std::vector<Charge>& of, const std::vector<Charge>& among) {
  const auto matched = std::count_if(of.begin(), of.end(), [&](const Charge& one) {
    return std::any_of(among.begin(), among.end(), [&](const Charge& other) { return same(one, other); });
  });
  return static_cast<double>(matched) / static_cast<double>(of.size());
}

TEST_F(SyntheticFleet, ChargesWhereAndWhenItDid) {
  ASSERT_GT(charged_.size(), 200U);
  EXPECT_GE(share_with_a_match(charged_, found_), 0.97) << "recall";
  EXPECT_GE(share_with_a_match(found_, charged_), 0.97) << "precision";
  int on_time = 0;
  for (const Charge& one : found_) {
    const auto truth =
        std::find_if(charged_.begin(), charged_.end(), [&](const Charge& other) { return same(one, other); });
    on_time += truth != charged_.end() && std::abs(one.start - truth->start) <= 120 &&
                       std::abs(one.arrival - truth->arrival) <= 120
                   ? 1
                   : 0;
  }
  EXPECT_GE(on_time, 0.85 * static_cast<double>(found_.size())) << "arrival and start, where no outage hides them";
}

/// Fails unless each share lies within 4.5 standard errors of its chance; samples ten minutes apart tell the same three
/// times.
void expect_shares(const Eigen::RowVectorXd& counts, const Eigen::RowVectorXd& chances) {
  const double cars = counts.sum() / 3.0;
  ASSERT_GT(cars, 200.0);
  for (Eigen::Index i = 0; i < counts.size(); ++i) {
    const double p = chances(i);
    EXPECT_NEAR(counts(i) / counts.sum(), p, 4.5 * std::sqrt(p * (1.0 - p) / cars) + 1e-9) << "column " << i;
  }
}

TEST_F(SyntheticFleet, ChangesStateAsOftenAsItDid) {
  TransitionCounts day(kRegions);
  for (const auto& period : counter_.periods()) {
    EXPECT_GT(period.vacant.sum(), 0.0);
    day += period;
  }
  Eigen::RowVectorXd vacant = Eigen::RowVectorXd::Zero(3 * kRegions);
  for (int i = 0; i < 2 * kRegions; ++i) {
    vacant(i) = kFromVacant[i];
  }
  vacant(2 * kRegions) = kFromVacant[2 * kRegions];
  vacant(2 * kRegions + 2) = kFromVacant[2 * kRegions + 1];
  for (int region = 0; region < kRegions; ++region) {
    expect_shares(day.vacant.row(region), vacant);
    Eigen::RowVectorXd occupied = Eigen::RowVectorXd::Zero(2 * kRegions);
    occupied(region) = 1.0 - kRideGoesOn;
    occupied(kRegions + region) = kRideGoesOn;
    expect_shares(day.occupied.row(region), occupied);
  }
}

}  // namespace
}  // namespace evbal
