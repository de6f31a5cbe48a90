#include "tools/evbal/bound_command.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "experiments/bound/bound_file.hpp"
#include "experiments/progress/live_view.hpp"
#include "tools/evbal/console_table.hpp"
#include "tools/evbal/kept_bound.hpp"
#include "tools/evbal/runs_folder.hpp"
#include "tools/evbal/scenario_options.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

struct BoundArguments {
  ScenarioOptions options;
  std::vector<double> prices = {2.0, 5.0, 10.0, 20.0, 50.0};
  double time_limit = 0.0;
  bool quiet = false;
};

/// Shows on stderr how far the bound has come, and says when the time is over.
class BoundClock {
 public:
  explicit BoundClock(const BoundArguments& arguments) : arguments_(arguments) {}

  bool is_over(const BoundProgress& progress) {
    check_interrupt();
    const double seconds = std::chrono::duration<double>(SteadyClock::now() - start_).count();
    if (!arguments_.quiet) {
      show(progress, seconds);
    }
    return arguments_.time_limit > 0.0 && seconds >= 60.0 * arguments_.time_limit;
  }

 private:
  /// On a terminal a line that renews itself, elsewhere one for each price.
  void show(const BoundProgress& progress, double seconds) {
    const bool terminal = isatty(STDERR_FILENO) == 1;
    if (!terminal && progress.flow->iterations > 0) {
      return;
    }
    const bool down = progress.rounding == Rounding::down;
    const std::size_t done = progress.point + (down ? 0 : arguments_.prices.size());
    std::fprintf(stderr, "%s%zu/%zu  price %g, arrivals rounded %s", terminal ? "\r\033[K" : "", done + 1,
                 2 * arguments_.prices.size(), arguments_.prices[progress.point], down ? "down" : "up");
    if (progress.flow->iterations > 0) {
      std::fprintf(stderr, "  %d iterations, cost at least %.1f", progress.flow->iterations, progress.flow->bound);
    }
    std::fprintf(stderr, "  %s%s", shown_seconds(seconds).c_str(), terminal ? "" : "\n");
  }

  const BoundArguments& arguments_;
  SteadyClock::time_point start_ = SteadyClock::now();
};

std::string bound_table(const DayBound& bound) {
  std::vector<std::vector<std::string>> table = {
      {"price", "cost at least", "down: km", "lost", "up: km", "lost", "bracket, %", ""}};
  for (const BoundPoint& point : bound.points) {
    const auto cells = [](const std::optional<Driving>& driving) {
      return driving ? std::vector<std::string>{fixed(driving->km, 0), fixed(driving->lost, 1)}
                     : std::vector<std::string>{"", ""};
    };
    const auto down = cells(point.down);
    const auto up = cells(point.up);
    const auto bracket = point.bracket();
    table.push_back({fixed(point.price, 2), fixed(point.bound, 1), down[0], down[1], up[0], up[1],
                     bracket ? fixed(100.0 * *bracket, 1) : "",
                     point.tight ? "" : "a bound, not the best: out of time"});
  }
  return aligned(table, 0);
}

void print_bound(const DayBound& bound, const Scenario& scenario, const fs::path& file) {
  const World& world = scenario.world;
  std::printf("%s on %s, seed %llu: %d passengers who can be lost, %d cars. Batteries and chargers are left out.\n\n",
              world.city.name.c_str(), world.day.date.c_str(), static_cast<unsigned long long>(world.seed),
              bound.passengers, world.city.fleet.vehicles);
  if (bound.capacity.lost > 0) {
    std::printf("The fleet has no minutes for %d of them, at any km (%s to %s).\n\n", bound.capacity.lost,
                time_of_day(world.clock, bound.capacity.start).c_str(),
                time_of_day(world.clock, bound.capacity.end).c_str());
  } else {
    std::printf("The fleet has minutes enough for all of them, if it were in the right places.\n\n");
  }
  std::printf("%s\nprice x lost + km driven empty is at least the cost, whoever plans this day.\n%s\n",
              bound_table(bound).c_str(), file.c_str());
}

void compute_bound(const BoundArguments& arguments) {
  catch_interrupts();
  const Scenario scenario = read_scenario(find_scenario(arguments.options.scenario), arguments.options.overrides);
  if (scenario.draws.size() > 1) {
    throw bad_input(arguments.options.scenario.string() + ": has " + std::to_string(scenario.draws.size()) +
                    " draws of its faults, each another day; give the scenario.resolved.yaml of one");
  }
  BoundClock clock(arguments);
  const DayBound bound =
      kept_bound(scenario, arguments.prices, [&](const BoundProgress& progress) { return clock.is_over(progress); });
  print_bound(bound, scenario, bound_file(bounds_folder(), bound_key(scenario)));
}

std::string prices_complaint(const std::string& text) {
  char* end = nullptr;
  const double price = std::strtod(text.c_str(), &end);
  return *end == '\0' && price > 0.0 && price <= 1e6 ? "" : "give a number above 0, at most 1000000";
}

}  // namespace

void add_bound_command(CLI::App& app) {
  const auto arguments = std::make_shared<BoundArguments>();
  CLI::App* command = app.add_subcommand("bound", "The fewest passengers that a day must lose, whoever plans it");
  add_day_options(*command, arguments->options);
  command
      ->add_option("--prices", arguments->prices, "Km that a lost passenger counts as: a point of the front for each")
      ->check(prices_complaint)
      ->capture_default_str();
  command
      ->add_option("--time-limit", arguments->time_limit,
                   "Minutes after which what is known so far is taken, which is a bound too")
      ->check(CLI::PositiveNumber);
  command->add_flag("--quiet", arguments->quiet, "Without progress");
  command->callback([arguments] {
    std::sort(arguments->prices.begin(), arguments->prices.end());
    arguments->prices.erase(std::unique(arguments->prices.begin(), arguments->prices.end()), arguments->prices.end());
    compute_bound(*arguments);
  });
}

}  // namespace evbal
