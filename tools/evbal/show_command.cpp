#include "tools/evbal/show_command.hpp"

#include "tools/evbal/json_output.hpp"
#include "tools/evbal/scenario_options.hpp"
#include "tools/evbal/sourced_scenario.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace evbal {

void add_show_command(CLI::App& app) {
  struct Arguments {
    ScenarioOptions options;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("show", "Show a scenario with everything explicit, and where it comes from");
  add_scenario_options(*command, arguments->options);
  command->add_flag("--json", arguments->json, "As JSON");
  command->callback([arguments] {
    const ScenarioOptions& options = arguments->options;
    const SourcedScenario scenario = sourced_scenario(find_scenario(options.scenario), options.overrides);
    std::fputs((arguments->json ? sourced_json(scenario) : scenario.text).c_str(), stdout);
  });
}

}  // namespace evbal
