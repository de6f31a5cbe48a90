#include "tools/evbal/fit_command.hpp"

#include "agents/world/world.hpp"
#include "coordinator/planning/settings.hpp"
#include "tools/fit/fit_city.hpp"
#include "tools/fit/print_fit.hpp"
#include "tools/fit/transition_table.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace evbal {
namespace {

void fit(const std::string& name, int leads, const std::string& table, const std::string& out) {
  const City city = find_city(name);
  const auto transitions = table.empty() ? std::vector<Period>() : read_transitions(table, city.regions);
  const CityFit fitted = fit_city(
      city, leads, [](const std::string& line) { std::cout << line << std::endl; }, transitions);
  const std::filesystem::path file = out.empty() ? model_file({}, city) : std::filesystem::path(out);
  write_model(fitted.model, file);
  print_fit(city, fitted);
  std::printf("\nwrote %s\n", file.c_str());
}

}  // namespace

void add_fit_command(CLI::App& app) {
  struct Arguments {
    std::string city;
    int tau = BalancingParameters{}.tau;
    std::string transitions;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("fit", "Estimate forecasts, uncertainty sets and transitions of a city");
  command->add_option("city", arguments->city, "Shipped city or folder of a pack")->required();
  command->add_option("--out", arguments->out, "File to write; without it, model.json beside the pack");
  command->add_option("--transitions", arguments->transitions,
                      "transitions.csv of `ingest gps`: what real drivers did, in place of simulated ones");
  command->add_option("--tau", arguments->tau, "Steps that plans look ahead, at most")
      ->check(CLI::Range(1, 48))
      ->capture_default_str();
  command->callback([arguments] { fit(arguments->city, arguments->tau, arguments->transitions, arguments->out); });
}

}  // namespace evbal
