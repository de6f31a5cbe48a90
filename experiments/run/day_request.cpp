#include "experiments/run/day_request.hpp"

#include <vector>

namespace evbal {
namespace {

constexpr double slowest = 1.0;
constexpr double fastest = 1e6;

const std::vector<std::string> deeds = {"fault", "pause", "go on", "tick", "speed", "kill", "schedule"};  // by DayDeed

std::optional<double> read_speed(const YamlValue& value) {
  return value.text() == "unlimited" ? std::nullopt : std::optional(value.number(slowest, fastest));
}

}  // namespace

DayRequest read_day_request(const std::string& text) {
  YamlMap map(YamlValue::parse_option(text, "request"));
  DayRequest request;
  request.deed = static_cast<DayDeed>(map.require("do").one_of(deeds));
  switch (request.deed) {
    case DayDeed::fault:
      request.fault = map.require("fault");
      break;
    case DayDeed::speed:
      request.speed = read_speed(map.require("speed"));
      break;
    case DayDeed::kill:
      request.process = map.require("process").text();
      break;
    default:
      break;
  }
  map.finish();
  return request;
}

}  // namespace evbal
