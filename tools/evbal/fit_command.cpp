#include "tools/evbal/fit_command.hpp"

#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "coordinator/planning/settings.hpp"
#include "tools/fit/fit_city.hpp"
#include "tools/fit/fit_json.hpp"
#include "tools/fit/print_fit.hpp"
#include "tools/fit/transition_table.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

namespace evbal {
namespace {

/// First and last date of a stretch of days; empty: as the pack has it.
using Stretch = std::vector<std::string>;

struct FitArguments {
  std::string city;
  int tau = BalancingParameters{}.tau;
  Stretch train;
  Stretch test;
  std::string transitions;
  std::string out;
  bool json = false;
};

/// The city's days within a stretch. Throws Error{bad_input} if there are none.
std::vector<std::string> days_within(const City& city, const Stretch& stretch) {
  std::vector<std::string> days;
  std::copy_if(city.days.begin(), city.days.end(), std::back_inserter(days),
               [&](const std::string& day) { return stretch.front() <= day && day <= stretch.back(); });
  if (days.empty()) {
    throw bad_input(city.name + " has no day from " + stretch.front() + " to " + stretch.back() +
                    "; its days are from " + city.days.front() + " to " + city.days.back());
  }
  return days;
}

void fit(const FitArguments& arguments) {
  City city = find_city(arguments.city);
  city.train_days = arguments.train.empty() ? city.train_days : days_within(city, arguments.train);
  city.test_days = arguments.test.empty() ? city.test_days : days_within(city, arguments.test);
  std::erase_if(city.test_days, [&](const std::string& day) {
    return std::binary_search(city.train_days.begin(), city.train_days.end(), day);
  });
  const auto transitions =
      arguments.transitions.empty() ? std::vector<Period>() : read_transitions(arguments.transitions, city.regions);
  const auto tell = [&progress = arguments.json ? std::cerr : std::cout](const std::string& line) {
    progress << line << std::endl;
  };
  const CityFit fitted = fit_city(city, arguments.tau, tell, transitions);
  const std::filesystem::path file =
      arguments.out.empty() ? model_file({}, city) : std::filesystem::path(arguments.out);
  write_model(fitted.model, file);
  if (arguments.json) {
    std::fputs(fit_json(city, fitted, file).c_str(), stdout);
  } else {
    print_fit(city, fitted);
    std::printf("\nwrote %s\n", file.c_str());
  }
}

}  // namespace

void add_fit_command(CLI::App& app) {
  const auto arguments = std::make_shared<FitArguments>();
  CLI::App* command = app.add_subcommand("fit", "Estimate forecasts, uncertainty sets and transitions of a city");
  command->add_option("CITY", arguments->city, "Shipped city or folder of a pack")->required();
  command->add_option("--out", arguments->out, "File to write; without it, model.json beside the pack");
  command->add_option("--train", arguments->train, "First and last day to fit to; without it, the pack's training days")
      ->expected(2);
  command->add_option("--test", arguments->test, "First and last day to forecast; without it, the pack's test days")
      ->expected(2);
  command->add_option("--transitions", arguments->transitions,
                      "transitions.csv of `ingest gps`: what real drivers did, in place of simulated ones");
  command->add_option("--tau", arguments->tau, "Steps that plans look ahead, at most")
      ->check(CLI::Range(1, 48))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "As JSON; progress goes to standard error");
  command->callback([arguments] { fit(*arguments); });
}

}  // namespace evbal
