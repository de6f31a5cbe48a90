#include "experiments/progress/live_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace evbal {
namespace {

constexpr int label_width = 8;

using Numbers = std::vector<long>;

long sum(const Numbers& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0L);
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

std::string label(std::string text) {
  text.resize(label_width, ' ');
  return text;
}

/// Sums of as many neighbours as it takes to have at most `most` of them.
Numbers pooled(const Numbers& numbers, int most) {
  const std::size_t together = (numbers.size() + static_cast<std::size_t>(most) - 1) / static_cast<std::size_t>(most);
  Numbers sums;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % together == 0) {
      sums.push_back(0);
    }
    sums.back() += numbers[i];
  }
  return sums;
}

/// A bar for each number, an eighth of a line high at least if it is not 0.
std::string bars(const Numbers& numbers, long top) {
  static const std::array<const char*, 9> heights = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  std::string text;
  for (const long number : numbers) {
    text += heights.at(static_cast<std::size_t>((8 * std::clamp(number, 0L, top) + top - 1) / top));
  }
  return text;
}

long highest(const Numbers& numbers) {
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

std::string clipped(const std::string& ascii, int columns) {
  return ascii.substr(0, static_cast<std::size_t>(columns));
}

std::string clock_line(const std::string& title, const DayClock& clock, const DayState& day, double seconds_left,
                       int columns) {
  const std::string before = title + "  " + time_of_day(clock, clock.minute_of(day.ticks)) + "  ";
  const std::string after = "  " + shown_seconds(seconds_left) + " left";
  const int room = columns - static_cast<int>(before.size() + after.size());
  const int done = room * day.ticks / std::max(1, clock.ticks());
  return room < 1 ? clipped(before, columns) : before + repeated("━", done) + repeated("─", room - done) + after;
}

std::string passengers_line(const DayState& day) {
  const double settled = std::max(1.0, static_cast<double>(day.served + day.lost));
  std::array<char, 16> share{};
  std::snprintf(share.data(), share.size(), "%.1f", 100.0 * static_cast<double>(day.lost) / settled);
  return "served " + std::to_string(day.served) + "  lost " + std::to_string(day.lost) + " (" + share.data() +
         " %)  waiting " + std::to_string(sum(day.waiting)) + "  vacant " + std::to_string(sum(day.vacant)) +
         "  queue " + std::to_string(sum(day.queue));
}

std::string faults_line(const DayState& day) {
  std::string text = label("faults");
  for (const std::string& name : day.faults) {
    text += "[" + name + "] ";
  }
  return text;
}

std::string plan_line(const DayClock& clock, const DayState& day) {
  const Provenance& plan = day.provenance;
  std::string text = label("plan");
  if (plan.controller.empty()) {
    return text;
  }
  text += time_of_day(clock, day.planned_at) + " " + plan.controller;
  if (plan.iterations > 0) {
    std::array<char, 64> solved{};
    std::snprintf(solved.data(), solved.size(), ", %d iterations, gap %.0e", plan.iterations, plan.gap);
    text += " by " + plan.engine + solved.data();
  }
  static const std::array<const char*, 4> fallbacks = {"", "the nominal problem", "the last plan's next step",
                                                       "nobody moves"};
  if (plan.fallback != FallbackLevel::none) {
    text += "; fell back, " + std::string(fallbacks.at(static_cast<std::size_t>(plan.fallback))) + ": " + plan.reason;
  }
  if (!plan.rejected.empty()) {
    text += "; " + std::to_string(plan.rejected.size()) + " reports not believed";
  }
  if (!plan.flags.empty()) {
    text += "; " + std::to_string(plan.flags.size()) + " sensors lie";
  }
  return text;
}

}  // namespace

std::string shown_seconds(double seconds) {
  const long whole = std::lround(seconds);
  return whole < 60 ? std::to_string(whole) + " s"
                    : std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

std::string live_line(const std::string& title, const DayClock& clock, const DayState& day, double seconds_left) {
  const int step = clock.step_of(clock.minute_of(day.ticks - 1)) + 1;
  std::string text = title + "  step " + std::to_string(step) + "/" + std::to_string(clock.steps()) + "  " +
                     time_of_day(clock, clock.minute_of(day.ticks)) + "  served " + std::to_string(day.served) +
                     "  lost " + std::to_string(day.lost);
  for (const std::string& name : day.faults) {
    text += "  [" + name + "]";
  }
  return text + "  " + shown_seconds(seconds_left) + " left";
}

std::vector<std::string> live_view(const std::string& title, const DayClock& clock, const DayState& day,
                                   double seconds_left, int columns) {
  const int room = columns - label_width;
  const Numbers demand = pooled(day.demand, room);
  const Numbers vacant = pooled(day.vacant, room);
  const Numbers queue = pooled(day.queue, room);
  const long top = std::max({1L, highest(demand), highest(vacant)});
  return {clock_line(title, clock, day, seconds_left, columns),
          clipped(passengers_line(day), columns),
          label("demand") + bars(demand, top),
          label("vacant") + bars(vacant, top),
          label("queue") + bars(queue, std::max(1L, highest(queue))),
          clipped(faults_line(day), columns),
          clipped(plan_line(clock, day), columns)};
}

}  // namespace evbal
