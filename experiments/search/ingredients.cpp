#include "experiments/search/ingredients.hpp"

#include "common/error.hpp"
#include "faults/schedule/draw.hpp"
#include "faults/schedule/guard.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace evbal {
namespace {

Picks draw(const Ingredients& ingredients, std::uint64_t run) {
  Picks picks;
  for (std::size_t entry = 0; entry < ingredients.entries.size(); ++entry) {
    for (auto& fault : draw_faults(ingredients.entries[entry], ingredients.context, {ingredients.seed, run})) {
      picks.push_back({entry, std::move(fault)});
    }
  }
  return in_order(std::move(picks), ingredients);
}

}  // namespace

Ingredients read_ingredients(YamlMap& map, const FaultContext& context) {
  map.require("schema").integer(1, 1);
  map.find("runs");
  if (const auto resolved = map.find("resolved"); resolved && resolved->boolean()) {
    throw resolved->error(
        "nothing is left open in a resolved list of faults; give the schedule that it was drawn from");
  }
  Ingredients ingredients{.context = context};
  if (const auto seed = map.find("seed")) {
    ingredients.seed = seed->seed();
  }
  if (const auto guard = map.find("guard")) {
    ingredients.guard = read_guard(*guard);
  }
  const auto list = map.require("faults");
  std::set<std::string> names;
  for (const auto& entry : list.items()) {
    ingredients.entries.push_back(read_request(entry, context));
    if (!names.insert(ingredients.entries.back().name).second) {
      throw entry.error("fault `" + ingredients.entries.back().name + "` is there twice; give each a name of its own");
    }
  }
  if (ingredients.entries.empty()) {
    throw list.error("no fault is given; a search needs one at least to try");
  }
  return ingredients;
}

Picks in_order(Picks picks, const Ingredients& ingredients) {
  std::stable_sort(picks.begin(), picks.end(), [](const Pick& a, const Pick& b) {
    return std::tie(a.entry, a.fault.start, a.fault.regions) < std::tie(b.entry, b.fault.start, b.fault.regions);
  });
  std::map<std::size_t, int> numbers;
  for (auto& [entry, fault] : picks) {
    const Request& request = ingredients.entries[entry];
    fault.name = request.start ? request.name : request.name + "-" + std::to_string(++numbers[entry]);
  }
  return picks;
}

Schedule schedule_of(const Picks& picks, const Ingredients& ingredients) {
  Schedule schedule{.seed = ingredients.seed, .guard = ingredients.guard, .faults = {}};
  for (const auto& pick : picks) {
    schedule.faults.push_back(pick.fault);
  }
  return schedule;
}

bool keeps_guard(const Picks& picks, const Ingredients& ingredients) {
  return keeps_guard(ingredients.guard, schedule_of(picks, ingredients).faults, ingredients.context);
}

std::vector<Picks> random_draws(const Ingredients& ingredients, std::size_t count) {
  constexpr std::size_t patience = 100;  // draws for each that keeps the guard
  std::vector<Picks> draws;
  for (std::uint64_t run = 0; draws.size() < count; ++run) {
    if (run >= patience * (draws.size() + 1)) {
      throw bad_input("faults: of " + std::to_string(run) + " draws only " + std::to_string(draws.size()) +
                      " keep the guard; give fewer or shorter faults, or a wider guard");
    }
    Picks picks = draw(ingredients, run);
    if (keeps_guard(picks, ingredients)) {
      draws.push_back(std::move(picks));
    }
  }
  return draws;
}

}  // namespace evbal
