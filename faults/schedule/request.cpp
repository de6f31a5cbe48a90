#include "faults/schedule/request.hpp"

#include "agents/protocol/words.hpp"
#include "faults/schedule/entry.hpp"

#include <algorithm>

namespace evbal {
namespace {

Arrivals read_arrivals(const YamlValue& value, const DayClock& clock) {
  YamlMap map(value);
  YamlMap poisson(map.require("poisson"));
  map.finish();
  Arrivals arrivals{poisson.require("per_hour").number(0.001, 60.0), clock.start, clock.end};
  if (const auto from = poisson.find("from")) {
    arrivals.from = from->time_of_day();
  }
  if (const auto to = poisson.find("to")) {
    arrivals.to = to->time_of_day();
  }
  poisson.finish();
  if (arrivals.from < clock.start || arrivals.to > clock.end || arrivals.from >= arrivals.to) {
    throw poisson.value().error("`from` must come before `to`, both within the day, " + time_of_day(clock, 0) + " to " +
                                time_of_day(clock, clock.minutes()));
  }
  return arrivals;
}

/// So many points that every region asked for has them, or one of those to be picked from.
Quantity read_points(const YamlValue& points, const Target& target, const FaultContext& context) {
  const auto& candidates = target.candidates;
  const auto fewer = [&](int a, int b) { return context.points_per_region[a] < context.points_per_region[b]; };
  const auto [least, most] = std::minmax_element(candidates.begin(), candidates.end(), fewer);
  const int limit = context.points_per_region[points.is_scalar() ? *least : *most];
  if (points.is_scalar() && points.integer() > limit) {
    throw points.error("`" + points.text() + "` points are more than region " + std::to_string(*least) +
                       " has; give at most " + std::to_string(limit) + " or choose regions with more");
  }
  return read_quantity(points, Unit::number, {1.0, static_cast<double>(limit)});
}

Magnitude read_count(const YamlValue& value, const Request& request, const FaultContext& context) {
  const FaultType& type = *request.type;
  YamlMap map(value);
  const auto counted = map.find(type.counted);
  const auto fraction = type.counts_points() ? map.find("fraction_of_points") : std::nullopt;
  map.finish();
  if (counted.has_value() == fraction.has_value()) {
    throw value.error(type.counts_points() ? "expected either `fraction_of_points: f` or `points: n`"
                                           : "expected `" + type.counted + ": n`");
  }
  if (fraction) {
    return {read_quantity(*fraction, Unit::number, {0.01, 1.0}), true};
  }
  if (type.counts_points()) {
    return {read_points(*counted, request.target, context), false};
  }
  if (counted->is_scalar()) {
    counted->integer();
  }
  return {read_quantity(*counted, Unit::number, type.range), false};
}

Magnitude read_magnitude(YamlMap& map, const Request& request, const FaultContext& context) {
  const FaultType& type = *request.type;
  if (type.unit == MagnitudeUnit::none) {
    return {};
  }
  const auto value = map.require(type.magnitude);
  if (type.unit == MagnitudeUnit::count) {
    return read_count(value, request, context);
  }
  return {read_quantity(value, type.unit == MagnitudeUnit::minutes ? Unit::minutes : Unit::number, type.range), false};
}

void read_times(YamlMap& map, const DayClock& clock, Request& request) {
  const auto start = map.find("start");
  const auto arrivals = map.find("arrivals");
  if (start.has_value() == arrivals.has_value()) {
    throw map.value().error("fault `" + request.name + "` needs either `start` or `arrivals`");
  }
  if (start) {
    request.start = read_quantity(*start, Unit::time_of_day,
                                  {static_cast<double>(clock.start), static_cast<double>(clock.end - 1)});
  } else {
    request.arrivals = read_arrivals(*arrivals, clock);
  }
  constexpr double longest = 24.0 * 60.0;
  request.duration = read_quantity(map.require(request.type->duration), Unit::minutes, {1.0, longest});
  const auto ramp = request.type->ramp ? map.find("ramp") : std::nullopt;
  if (!ramp) {
    return;
  }
  request.ramp = read_quantity(*ramp, Unit::minutes, {0.0, longest});
  if (!request.ramp.open() && !request.duration.open() && 2.0 * request.ramp.centre > request.duration.centre) {
    throw ramp->error("rise and fall together last longer than the fault; give a ramp of at most half of the duration");
  }
}

}  // namespace

Request read_request(const YamlValue& entry, const FaultContext& context) {
  YamlMap map(entry);
  Request request;
  request.name = read_name(map);
  request.type = &fault_types()[map.require("type").one_of(fault_type_names())];
  request.target = read_target(map, *request.type, context);
  read_times(map, context.clock, request);
  request.magnitude = read_magnitude(map, request, context);
  if (request.type->to) {
    request.to = map.require("to").integer(0, static_cast<int>(context.points_per_region.size()) - 1);
  }
  if (const auto given = request.type->on_start ? map.find("on_start") : std::nullopt) {
    request.on_start = static_cast<OnStart>(given->one_of(words<OnStart>()));
  }
  if (const auto given = request.type->may_be_invisible() ? map.find("visible") : std::nullopt) {
    request.visible = given->boolean();
  }
  map.finish();
  return request;
}

}  // namespace evbal
