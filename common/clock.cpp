#include "common/clock.hpp"

#include <array>
#include <cstdio>

namespace evbal {

std::string DayClock::validate() const {
  if (start < 0 || end > 24 * 60 || start >= end) {
    return "the day must start before it ends, between 00:00 and 24:00";
  }
  if (tick < 1 || step < 1 || plan_every < 1) {
    return "tick, step and plan_every must be at least 1min";
  }
  if (step % tick != 0 || plan_every % tick != 0) {
    return "tick must divide step and plan_every";
  }
  if (step % plan_every != 0) {
    return "plan_every must divide step";
  }
  if (minutes() % step != 0) {
    return "step must divide the length of the day";
  }
  return "";
}

std::string time_of_day(const DayClock& clock, int minute) {
  const int total = clock.start + minute;
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%02d:%02d", total / 60, total % 60);
  return text.data();
}

}  // namespace evbal
