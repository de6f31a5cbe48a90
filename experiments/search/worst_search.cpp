#include "experiments/search/worst_search.hpp"

#include "common/random.hpp"
#include "experiments/search/moves.hpp"

#include <algorithm>
#include <optional>

namespace evbal {
namespace {

/// Schedules that are tried at a time: enough for the cores of most machines, few enough that moves build on moves.
constexpr std::size_t at_a_time = 8;

/// Trials that moves begin from when so many of `all` moves are made: half as many with each sixth of them, one
/// when a third of them are made.
std::size_t lines_left(std::size_t made, std::size_t all) {
  const std::size_t most = 4;
  return std::max<std::size_t>(1, most >> (6 * made / all));
}

void try_all(std::vector<Trial>& trials, const Harms& harms) {
  const std::vector<double> harm = harms(trials);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].harm = harm[i];
  }
}

bool harms_more(const Trial& a, const Trial& b) {
  return a.harm > b.harm;
}

bool tried(const std::vector<Trial>& trials, const Picks& picks) {
  return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) { return trial.picks == picks; });
}

/// A schedule made from `parent` that was not tried yet, if one is found; else the parent's own.
Trial child_of(const Ingredients& ingredients, const Trial& parent, const std::vector<Trial>& trials,
               std::size_t number, const MoveStock& stock) {
  constexpr std::size_t attempts = 20;
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    RandomStream stream = move_stream(ingredients, number, attempt);
    auto move = moved(ingredients, parent.picks, stock, stream);
    if (move && !tried(trials, move->picks)) {
      return {.number = number,
              .stage = "move",
              .parent = parent.number,
              .change = std::move(move->change),
              .picks = std::move(move->picks)};
    }
  }
  return {.number = number, .stage = "move", .parent = parent.number, .change = "none", .picks = parent.picks};
}

std::vector<Trial> drawn_trials(const Ingredients& ingredients, std::size_t count, const Harms& harms) {
  std::vector<Trial> trials;
  for (auto& picks : random_draws(ingredients, count)) {
    trials.push_back({.number = trials.size() + 1, .stage = "draw", .change = "", .picks = std::move(picks)});
  }
  try_all(trials, harms);
  return trials;
}

/// As many faults as the draw with most, and those of the most harmful draws.
MoveStock stock_of(std::vector<Trial> draws) {
  constexpr std::size_t harmful_draws = 8;
  std::stable_sort(draws.begin(), draws.end(), harms_more);
  MoveStock stock;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const Picks& picks = draws[i].picks;
    stock.most = std::max(stock.most, picks.size());
    if (i < harmful_draws) {
      stock.harmful.insert(stock.harmful.end(), picks.begin(), picks.end());
    }
  }
  return stock;
}

/// Lets each line go on from the best of its children, unless all of them do less harm.
void advance(std::vector<Trial>& lines, const std::vector<Trial>& children) {
  for (std::size_t i = 0; i < children.size(); ++i) {
    Trial& line = lines[i % lines.size()];
    if (children[i].harm >= line.harm) {
      line = children[i];
    }
  }
}

}  // namespace

std::size_t first_draws(std::size_t budget) {
  return std::max<std::size_t>(1, budget / 3);
}

std::vector<Trial> search_worst(const Ingredients& ingredients, std::size_t budget, const Harms& harms) {
  const std::size_t draws = first_draws(budget);
  std::vector<Trial> trials = drawn_trials(ingredients, draws, harms);
  const MoveStock stock = stock_of(trials);
  std::vector<Trial> lines = trials;
  while (trials.size() < budget) {
    std::stable_sort(lines.begin(), lines.end(), harms_more);
    lines.resize(std::min(lines.size(), lines_left(trials.size() - draws, budget - draws)));
    std::vector<Trial> children;
    for (std::size_t i = 0; i < std::min(at_a_time, budget - trials.size()); ++i) {
      children.push_back(child_of(ingredients, lines[i % lines.size()], trials, trials.size() + i + 1, stock));
    }
    try_all(children, harms);
    advance(lines, children);
    trials.insert(trials.end(), children.begin(), children.end());
  }
  return trials;
}

const Trial& most_harmful(const std::vector<Trial>& trials) {
  return *std::max_element(trials.begin(), trials.end(),
                           [](const Trial& a, const Trial& b) { return a.harm < b.harm; });
}

}  // namespace evbal
