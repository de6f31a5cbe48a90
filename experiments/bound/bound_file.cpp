#include "experiments/bound/bound_file.hpp"

#include "common/decimal.hpp"
#include "common/digest.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"
#include "experiments/scenario/input_digests.hpp"

#include <array>
#include <charconv>
#include <sstream>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> columns = {"price",         "bound",          "tight",       "down_km",
                                          "down_lost",     "up_km",          "up_lost",     "passengers",
                                          "capacity_lost", "capacity_start", "capacity_end"};

void add(std::vector<std::string>& cells, const std::optional<Driving>& driving) {
  cells.push_back(driving ? decimal(driving->km) : "");
  cells.push_back(driving ? decimal(driving->lost) : "");
}

double number(const std::string& cell, const fs::path& file, int line) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) {
    throw bad_input(file.string(), line, "`" + cell + "` is no number; compute the bound again with `evbal bound`");
  }
  return value;
}

}  // namespace

std::string bound_key(const Scenario& scenario) {
  const World& world = scenario.world;
  YamlWriter yaml;
  yaml.key("pack").text(pack_digest(world.city.folder)).key("day").text(world.day.date);
  yaml.key("seed").number(world.seed).key("demand").number(static_cast<int>(world.demand));
  yaml.key("start").number(world.clock.start).key("end").number(world.clock.end);
  yaml.key("tick").number(world.clock.tick).key("step").number(world.clock.step);
  yaml.key("vehicles").number(world.city.fleet.vehicles);
  yaml.key("patience").begin_list().number(world.city.passengers.patience_low);
  yaml.number(world.city.passengers.patience_high).end_list();
  yaml.key("faults").begin_map();
  write_schedule(yaml, {.seed = 0, .guard = {}, .faults = scenario.schedule.faults}, world.clock);  // as drawn
  return text_digest(yaml.end_map().finish());
}

fs::path bound_file(const fs::path& bounds, const std::string& key) {
  return bounds / key / "bound.csv";
}

std::string bound_csv(const DayBound& bound) {
  std::string text = csv_row(columns);
  for (const BoundPoint& point : bound.points) {
    std::vector<std::string> cells = {decimal(point.price), decimal(point.bound), point.tight ? "yes" : "no"};
    add(cells, point.down);
    add(cells, point.up);
    for (const int count : {bound.passengers, bound.capacity.lost, bound.capacity.start, bound.capacity.end}) {
      cells.push_back(std::to_string(count));
    }
    text += csv_row(cells);
  }
  return text;
}

std::optional<DayBound> read_bound(const fs::path& file) {
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  std::istringstream in(text_of_file(file));
  std::string text;
  if (!std::getline(in, text) || split_csv(text) != columns) {
    throw bad_input(file.string(), 1, "is no bound of a day; compute it again with `evbal bound`");
  }
  DayBound bound;
  for (int line = 2; std::getline(in, text); ++line) {
    const std::vector<std::string> cells = split_csv(text);
    if (cells.size() != columns.size()) {
      throw bad_input(file.string(), line,
                      "has " + std::to_string(cells.size()) + " columns, not " + std::to_string(columns.size()));
    }
    const auto at = [&](std::size_t column) { return number(cells[column], file, line); };
    const auto driving = [&](std::size_t column) {
      return cells[column].empty() ? std::nullopt : std::optional(Driving{at(column), at(column + 1)});
    };
    bound.points.push_back(
        {.price = at(0), .bound = at(1), .tight = cells[2] == "yes", .down = driving(3), .up = driving(5)});
    bound.passengers = static_cast<int>(at(7));
    bound.capacity = {static_cast<int>(at(8)), static_cast<int>(at(9)), static_cast<int>(at(10))};
  }
  return bound;
}

}  // namespace evbal
