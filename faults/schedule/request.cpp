#include "faults/schedule/request.hpp"

#include "faults/schedule/entry.hpp"

#include <algorithm>

namespace evbal {
namespace {

std::vector<int> read_candidates(const std::optional<YamlValue>& of, const Place& place, bool with_points) {
  if (!of) {
    return regions_with(place, with_points ? 1 : 0);
  }
  YamlMap map(*of);
  const auto regions = map.find("regions");
  const auto min_points = map.find("min_points");
  map.finish();
  if (regions.has_value() == min_points.has_value()) {
    throw of->error("expected either `regions: [..]` or `min_points: k`");
  }
  return regions ? read_regions(*regions, place, with_points) : regions_with(place, min_points->integer(1, 1'000'000));
}

Target read_target(const YamlValue& value, const Place& place, bool with_points) {
  YamlMap map(value);
  const auto regions = map.find("regions");
  const auto pick = map.find("pick");
  const auto of = map.find("of");
  map.finish();
  if (regions.has_value() == pick.has_value() || (of && !pick)) {
    throw value.error("expected either `regions: [..]` or `pick: n`, with or without `of: {min_points: k}`");
  }
  if (regions) {
    return {read_regions(*regions, place, with_points), std::nullopt};
  }
  Target target{read_candidates(of, place, with_points), std::nullopt};
  const int most = static_cast<int>(target.candidates.size());
  if (most == 0) {
    throw value.error("no region fits; ask for fewer points");
  }
  if (pick->is_scalar()) {
    pick->integer(1, most);
  }
  target.pick = read_quantity(*pick, Unit::number, {1.0, static_cast<double>(most)});
  return target;
}

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

Magnitude read_magnitude(const YamlValue& value, const Request& request, const Place& place) {
  if (request.type->magnitude == MagnitudeUnit::factor) {
    return {read_quantity(value, Unit::number, {0.0, max_factor}), false};
  }
  YamlMap map(value);
  const auto fraction = map.find("fraction_of_points");
  const auto points = map.find("points");
  map.finish();
  if (fraction.has_value() == points.has_value()) {
    throw value.error("expected either `fraction_of_points: f` or `points: n`");
  }
  if (fraction) {
    return {read_quantity(*fraction, Unit::number, {0.01, 1.0}), true};
  }
  const auto& candidates = request.target.candidates;
  const auto fewer = [&](int a, int b) { return place.points_per_region[a] < place.points_per_region[b]; };
  const auto [least, most] = std::minmax_element(candidates.begin(), candidates.end(), fewer);
  const int limit = place.points_per_region[points->is_scalar() ? *least : *most];
  if (points->is_scalar() && points->integer() > limit) {
    throw points->error("`" + points->text() + "` points are more than region " + std::to_string(*least) +
                        " has; give at most " + std::to_string(limit) + " or choose regions with more");
  }
  return {read_quantity(*points, Unit::number, {1.0, static_cast<double>(limit)}), false};
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
  request.duration = read_quantity(map.require("duration"), Unit::minutes, {1.0, longest});
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

Request read_request(const YamlValue& entry, const Place& place) {
  YamlMap map(entry);
  Request request;
  request.name = read_name(map);
  request.type = &fault_types()[map.require("type").one_of(fault_type_names())];
  request.target = read_target(map.require("target"), place, request.type->magnitude == MagnitudeUnit::points);
  read_times(map, place.clock, request);
  request.magnitude = read_magnitude(map.require("magnitude"), request, place);
  if (const auto given = request.type->on_start ? map.find("on_start") : std::nullopt) {
    request.on_start = static_cast<OnStart>(given->one_of(on_start_words()));
  }
  if (const auto given = map.find("visible")) {
    request.visible = given->boolean();
  }
  map.finish();
  return request;
}

}  // namespace evbal
