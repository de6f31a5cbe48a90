#include "tools/python/arrays.hpp"

#include "agents/protocol/measured.hpp"
#include "common/error.hpp"
#include "experiments/metrics/columns.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace evbal {
namespace {

namespace py = pybind11;

constexpr std::array under_way_names = {"arriving_occupied", "arriving_vacant", "arriving_low_battery"};  // by Errand

/// A block of numbers, each row of which Python sees as an array of its own without a copy.
template <class Number>
class Rows {
 public:
  Rows(std::size_t rows, std::size_t columns) : block_({rows, columns}), columns_(columns) {
    std::fill_n(block_.mutable_data(), rows * columns, Number{});
  }

  Number* row(std::size_t at) { return block_.mutable_data() + at * columns_; }

  py::array_t<Number> view(std::size_t at) { return {{columns_}, {sizeof(Number)}, row(at), block_}; }

 private:
  py::array_t<Number> block_;
  std::size_t columns_;
};

py::dict by_region(const Environment& environment) {
  const auto& changes = environment.changes();
  const double beta = environment.scenario().planning.balancing.beta;
  std::vector<std::pair<std::string, double>> values;
  const auto all_of = [&](const RegionChange& change) {
    values = named_flows(change.flows, beta);
    columns([&](const char* name, auto value) { values.emplace_back(name, static_cast<double>(value)); },
            change.stocks);
  };
  all_of(changes.front());
  Rows<double> rows(values.size(), changes.size());
  for (std::size_t region = 0; region < changes.size(); ++region) {
    all_of(changes[region]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      rows.row(i)[region] = values[i].second;
    }
  }
  py::dict arrays;
  for (std::size_t i = 0; i < values.size(); ++i) {
    arrays[values[i].first.c_str()] = rows.view(i);
  }
  return arrays;
}

py::list seen_faults(const Environment& environment) {
  py::list faults;
  for (const auto& seen : environment.seen_faults()) {
    faults.append(py::make_tuple(seen.name, seen.region, seen.amount));
  }
  return faults;
}

void add_result(const DayResult& result, py::dict& info) {
  py::dict totals;
  for (const auto& [name, value] : named(result.metrics.totals)) {
    totals[name.c_str()] = value;
  }
  info["totals"] = totals;
  info["fallbacks"] = result.fallbacks;
  info["digest"] = result.digest;
}

std::string place(int errand, int from, int to) {
  return "action[" + std::to_string(errand) + ", " + std::to_string(from) + ", " + std::to_string(to) + "]: ";
}

}  // namespace

std::vector<std::string> observation_names() {
  std::vector<std::string> names = {"heard"};
  for (const Measured& count : measured) {
    names.emplace_back(count.name);
  }
  names.insert(names.end(), under_way_names.begin(), under_way_names.end());
  return names;
}

int minute_of(const SteppedDay& day) {
  const DayClock& clock = day.scenario().world.clock;
  return day.over() ? clock.minutes() : clock.minute_of(day.tick().tick);
}

py::dict observation_of(const SteppedDay& day) {
  const auto regions = static_cast<std::size_t>(day.scenario().world.city.size());
  Rows<std::int32_t> rows(1 + measured.size() + under_way_names.size(), regions);
  for (const Report& report : day.reports()) {
    rows.row(0)[report.region] = 1;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      rows.row(1 + i)[report.region] = report.*measured[i].member;
    }
    for (const UnderWay& cars : report.bound) {
      rows.row(1 + measured.size() + static_cast<std::size_t>(cars.errand))[report.region] += cars.count;
    }
  }
  py::dict observation;
  const std::vector<std::string> names = observation_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    observation[names[i].c_str()] = rows.view(i);
  }
  py::array_t<std::int32_t> minute(1);
  *minute.mutable_data() = minute_of(day);
  observation["minute"] = minute;
  return observation;
}

py::dict info_of(const Environment& environment) {
  const SteppedDay& day = *environment.day();
  py::dict info;
  info["seed"] = day.scenario().world.seed;
  info["day"] = day.scenario().world.day.date;
  Flows all;
  for (const auto& change : environment.changes()) {
    all += change.flows;
  }
  for (const auto& [name, value] : named_flows(all, day.scenario().planning.balancing.beta)) {
    info[name.c_str()] = value;
  }
  info["regions"] = by_region(environment);
  info["faults"] = seen_faults(environment);
  if (day.over()) {
    add_result(day.result(), info);
  }
  return info;
}

std::vector<Move> moves_of(const py::array& action, const Scenario& scenario) {
  const py::ssize_t n = scenario.world.city.size();
  if (action.ndim() != 3 || action.shape(0) != 2 || action.shape(1) != n || action.shape(2) != n) {
    throw bad_input("action: an array of shape (2, " + std::to_string(n) + ", " + std::to_string(n) + ") is expected");
  }
  if (action.dtype().kind() != 'i' && action.dtype().kind() != 'u') {
    throw bad_input("action: whole numbers are expected; round them to an array of integers");
  }
  const auto counts = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(action);
  const std::int64_t* count = counts.data();
  std::vector<Move> moves;
  for (int errand = 0; errand < 2; ++errand) {
    for (int from = 0; from < n; ++from) {
      for (int to = 0; to < n; ++to, ++count) {
        if (*count < 0) {
          throw bad_input(place(errand, from, to) + std::to_string(*count) + " cars; 0 or more are expected");
        }
        const bool stays = from == to && (errand == 0 || !scenario.world.city.charging.top_up);
        if (*count > 0 && !stays) {
          const auto cars = std::min<std::int64_t>(*count, scenario.world.city.fleet.vehicles);
          moves.push_back(
              {from, to, static_cast<std::int32_t>(cars), errand == 0 ? Errand::rebalance : Errand::charge});
        }
      }
    }
  }
  return moves;
}

py::array_t<std::int32_t> action_of(const Plan& plan, int regions) {
  py::array_t<std::int32_t> action({2, regions, regions});
  std::fill_n(action.mutable_data(), action.size(), 0);
  auto cars = action.mutable_unchecked<3>();
  for (const Move& move : plan.moves) {
    cars(move.errand == Errand::rebalance ? 0 : 1, move.from, move.to) += move.count;
  }
  return action;
}

}  // namespace evbal
