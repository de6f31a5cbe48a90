#include "tools/evbal/verify_command.hpp"

#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "coordinator/planning/settings.hpp"
#include "tools/verify/verify.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace evbal {
namespace {

int print(const Comparison& comparison) {
  std::printf("%-46s  %5d  %9.1e  %8.0e  %s\n", comparison.what.c_str(), comparison.cases, comparison.largest,
              comparison.allowed, comparison.where.c_str());
  std::fflush(stdout);
  return comparison.holds() ? 0 : 1;
}

void verify(const std::string& name) {
  const City city = find_city(name);
  std::printf("%-46s  %5s  %9s  %8s  %s\n", "compared", "cases", "largest", "allowed", "where");
  int broken = print(compare_with_moment_problem());
  for (const auto& comparison : compare_engines()) {
    broken += print(comparison);
  }
  for (const auto& comparison : compare_with_theorem(read_model(model_file({}, city)))) {
    broken += print(comparison);
  }
  if (broken > 0) {
    throw Error(ExitStatus::expectation_failed, std::to_string(broken) + " differences are larger than allowed");
  }
}

}  // namespace

void add_verify_command(CLI::App& app) {
  const auto city = std::make_shared<std::string>("san-francisco-54");
  CLI::App* command = app.add_subcommand("verify", "Hold the optimisation against solvers that are not ours");
  command->add_option("city", *city, "City whose fitted uncertainty sets are taken")->capture_default_str();
  command->callback([city] { verify(*city); });
}

}  // namespace evbal
