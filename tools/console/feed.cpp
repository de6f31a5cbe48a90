#include "tools/console/feed.hpp"

#include <utility>

namespace evbal {
namespace {

constexpr std::size_t at_once = 65'536;  // bytes

std::string event(const std::string& kind, const std::string& json) {
  return "event: " + kind + "\ndata: " + json + "\n\n";
}

}  // namespace

void Feed::begin_day(const std::string& json) {
  {
    const std::lock_guard lock(mutex_);
    ++days_;
    events_ = {event("day", json)};
    state_.clear();
  }
  told_.notify_all();
}

void Feed::tell(const std::string& kind, const std::string& json) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back(event(kind, json));
  }
  told_.notify_all();
}

void Feed::tell_state(const std::string& json) {
  std::string state = event("state", json);
  {
    const std::lock_guard lock(mutex_);
    if (state == state_) {
      return;
    }
    state_ = std::move(state);
    ++states_;
  }
  told_.notify_all();
}

void Feed::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  told_.notify_all();
}

bool Feed::heard_all(const Place& place) const {
  return place.day == days_ && place.event == events_.size() && place.state == states_;
}

bool Feed::over(const Place& place) const {
  const std::lock_guard lock(mutex_);
  return closed_ && heard_all(place);
}

std::string Feed::next(Place& place, std::chrono::milliseconds at_most) {
  std::unique_lock lock(mutex_);
  told_.wait_for(lock, at_most, [&] { return closed_ || !heard_all(place); });
  if (place.day != days_) {
    place = {.day = days_, .event = 0, .state = 0};
  }
  std::string text;
  while (place.event < events_.size() && text.size() < at_once) {
    text += events_[place.event++];
  }
  if (place.event == events_.size() && place.state != states_) {
    place.state = states_;
    text += state_;
  }
  return text;
}

}  // namespace evbal
