#include "tools/evbal/filter_options.hpp"

#include <CLI/CLI.hpp>

namespace evbal {

std::vector<CLI::Option*> add_filter_options(CLI::App& command, DayFilter& filter) {
  return {command.add_option("--scenario", filter.scenarios, "These scenarios of the sweep only"),
          command.add_option("--faults", filter.faults, "These schedules of faults only"),
          command.add_option("--variant", filter.variants, "These variants only"),
          command.add_option("--days", filter.days, "These days only, such as 2024-01-11")};
}

}  // namespace evbal
