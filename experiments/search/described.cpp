#include "experiments/search/described.hpp"

#include "agents/protocol/words.hpp"
#include "common/decimal.hpp"
#include "faults/schedule/fault_types.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace evbal {
namespace {

/// "a, b and c"
std::string in_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

std::string counted(double count, const std::string& thing) {
  return decimal(count) + " " + (count == 1.0 ? thing.substr(0, thing.size() - 1) : thing);
}

/// Of all regions together where things are counted, else of the first region: they were drawn as one.
std::string magnitude_words(const Fault& fault, const FaultType& type) {
  constexpr int digits = 2;
  switch (type.unit) {
    case MagnitudeUnit::none:
      return "";
    case MagnitudeUnit::count:
      return " of " + counted(std::accumulate(fault.magnitudes.begin(), fault.magnitudes.end(), 0.0), type.counted);
    case MagnitudeUnit::minutes:
      return " of " + counted(fault.magnitudes.front(), "minutes");
    case MagnitudeUnit::number:
      break;
  }
  return (type.magnitude == "probability" ? " with probability " : " by ") + fixed(fault.magnitudes.front(), digits);
}

std::string place_words(const Fault& fault, const FaultType& type) {
  if (type.target == TargetKind::engine) {
    return "";
  }
  if (fault.process != ProcessRole::agent) {
    return " of the " + std::string(word(fault.process));
  }
  std::vector<std::string> numbers;
  for (const int region : fault.regions) {
    numbers.push_back(std::to_string(region));
  }
  const std::string what = type.target == TargetKind::sensors  ? " at `" + std::string(word(fault.field)) + "`"
                           : type.target == TargetKind::topics ? " of topic `" + std::string(word(fault.topic)) + "`"
                                                               : "";
  return what + (numbers.size() == 1 ? " in region " : " in regions ") + in_words(numbers);
}

}  // namespace

std::string described(const Fault& fault, const DayClock& clock) {
  const FaultType& type = fault_type(fault.type);
  return type.name + magnitude_words(fault, type) + place_words(fault, type) + " from " +
         time_of_day(clock, fault.start) + " for " + counted(fault.duration, "minutes");
}

std::string described(const Schedule& schedule, const DayClock& clock) {
  std::vector<Fault> by_time = schedule.faults;
  std::ranges::stable_sort(by_time, {}, &Fault::start);
  std::vector<std::string> words;
  for (const auto& fault : by_time) {
    words.push_back(described(fault, clock));
  }
  return words.empty() ? "no fault" : in_words(words);
}

}  // namespace evbal
