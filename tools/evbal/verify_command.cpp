#include "tools/evbal/verify_command.hpp"

#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "coordinator/planning/settings.hpp"
#include "tools/evbal/json_output.hpp"
#include "tools/verify/verify.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

namespace evbal {
namespace {

void print(const Comparison& comparison) {
  std::printf("%-46s  %5d  %9.1e  %8.0e  %s\n", comparison.what.c_str(), comparison.cases, comparison.largest,
              comparison.allowed, comparison.where.c_str());
  std::fflush(stdout);
}

void verify(const std::string& name, bool json) {
  const City city = find_city(name);
  if (!json) {
    std::printf("%-46s  %5s  %9s  %8s  %s\n", "compared", "cases", "largest", "allowed", "where");
  }
  std::vector<Comparison> all;
  const auto add = [&](const std::vector<Comparison>& more) {
    for (const auto& comparison : more) {
      all.push_back(comparison);
      if (!json) {
        print(comparison);
      }
    }
  };
  add({compare_with_moment_problem()});
  add(compare_engines());
  add(compare_bounds());
  add(compare_with_theorem(read_model(model_file({}, city))));
  if (json) {
    std::fputs(comparisons_json(all).c_str(), stdout);
  }
  const auto broken = std::count_if(all.begin(), all.end(), [](const Comparison& one) { return !one.holds(); });
  if (broken > 0) {
    throw Error(ExitStatus::expectation_failed, std::to_string(broken) + " differences are larger than allowed");
  }
}

}  // namespace

void add_verify_command(CLI::App& app) {
  struct Arguments {
    std::string city = "san-francisco-54";
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("verify", "Hold the optimisation against solvers that are not ours");
  command->add_option("CITY", arguments->city, "City whose fitted uncertainty sets are taken")->capture_default_str();
  command->add_flag("--json", arguments->json, "Print the table as JSON");
  command->callback([arguments] { verify(arguments->city, arguments->json); });
}

}  // namespace evbal
