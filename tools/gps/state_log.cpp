#include "tools/gps/state_log.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr long long kEvery = 600;  // s: plans are made as often
constexpr long long kStep = 1800;  // s
constexpr long long kMinutesOfDay = 24 * 60;

}  // namespace

TransitionCounter::TransitionCounter(int regions) : periods_(transition_periods().size(), TransitionCounts(regions)) {}

void TransitionCounter::add(long long local_time, const CarPlace& start, const CarPlace& end) {
  const int minute = static_cast<int>(local_time / 60 % kMinutesOfDay);
  if (minute >= transition_periods().front() && minute + kStep / 60 <= kMinutesOfDay) {
    periods_[period_at(transition_periods(), minute)].add({start}, {end});
  }
}

void StateLog::add_samples(const Fix& next) {
  if (static_cast<double>(next.time - last_->time) > 60.0 * longest_gap_) {
    return;
  }
  int region = -1;
  for (long long time = (last_->time + kEvery - 1) / kEvery * kEvery; time < next.time; time += kEvery) {
    if (last_->occupied) {
      samples_.push_back({time, last_->time, {CarState::occupied, -1}, {}, false});
      continue;
    }
    region = region < 0 ? regions_.region_of(last_->place) : region;
    samples_.push_back({time, last_->time, {CarState::vacant, region}, last_->place, true});
  }
}

void StateLog::end_ride(const Fix& dropoff) {
  const int region = regions_.region_of(dropoff.place);
  for (auto sample = samples_.rbegin(); sample != samples_.rend() && sample->time >= *ride_from_; ++sample) {
    if (sample->car.state == CarState::occupied) {
      sample->car.region = region;
      sample->place = dropoff.place;
      sample->known = true;
    }
  }
  ride_from_.reset();
}

void StateLog::add(const Fix& fix) {
  if (last_) {
    add_samples(fix);
  }
  if (fix.occupied && !ride_from_) {
    ride_from_ = fix.time;
  } else if (!fix.occupied && ride_from_) {
    end_ride(fix);
  }
  last_ = fix;
}

void StateLog::add(const ChargingStop& stop, int region) {
  for (auto sample = samples_.rbegin(); sample != samples_.rend() && sample->fix >= stop.arrival; ++sample) {
    if (sample->fix <= stop.end) {
      sample->car = {sample->fix < stop.start ? CarState::low_battery : CarState::plugged, region};
      sample->known = true;
    }
  }
}

std::vector<Outside> StateLog::settle(long long until, TransitionCounter& counter) {
  const auto in_region = [](const Sample& sample) { return sample.known && sample.car.region >= 0; };
  std::vector<Outside> outside;
  until = std::min(until, ride_from_.value_or(until));
  const auto later = [](const Sample& sample, long long time) { return sample.time < time; };
  const auto end = std::lower_bound(samples_.begin(), samples_.end(), until, later);
  for (auto sample = std::lower_bound(samples_.begin(), end, settled_, later); sample != end; ++sample) {
    const long long start = sample->time - kStep;
    const auto before = std::lower_bound(samples_.begin(), sample, start, later);
    if (in_region(*sample) && before != sample && before->time == start && in_region(*before)) {
      counter.add(clock_.local(start), before->car, sample->car);
    }
    if (sample->known && sample->car.region < 0) {
      outside.push_back({sample->time, sample->place});
    }
  }
  settled_ = std::max(settled_, until);
  samples_.erase(samples_.begin(), std::lower_bound(samples_.begin(), end, settled_ - kStep, later));
  return outside;
}

}  // namespace evbal
