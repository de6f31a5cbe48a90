#include "coordinator/bridge/run_bridge.hpp"

#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/pin.hpp"
#include "coordinator/bridge/external_controller.hpp"
#include "coordinator/planning/settings.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>

namespace evbal {
namespace {

void bridge(const Command& command, const ProcessOptions& options, Participant& participant) {
  if (command.empty()) {
    throw bad_input("evbal-bridge: no command; give one, such as --coordinator \"evbal-bridge python3 mine.py\"");
  }
  const std::string resolved = text_of_file(options.scenario);
  YamlMap scenario(YamlValue::parse(resolved, options.scenario.string()));
  const World world = read_world(scenario);
  PlanningSettings settings = read_planning(scenario);
  settings.coordinator = command;
  const auto controller = start_controller(world, settings, resolved);
  const Farewell farewell([&] { controller->end(); });
  const auto plan = [&](const Tick& tick, const auto& reports) { return controller->plan(tick, reports); };
  // The child's state cannot be saved: after a restart a new child is asked for the past plans once more.
  serve_coordinator(
      participant, options,
      {.plan = plan,
       .memory = [] { return std::string(); },
       .recall = [&](const Tick& tick, const auto& reports, const auto& /*memory*/) { plan(tick, reports); }});
}

}  // namespace

int run_bridge(int argc, char** argv) {
  pin_arithmetic(argv);
  const std::span words(argv, static_cast<std::size_t>(argc));
  // What evbal says begins with --name; the child may have an option of that name too, before it.
  const auto last = std::find(words.rbegin(), words.rend() - 1, std::string_view("--name"));
  const auto own = last == words.rend() - 1 ? words.end() : last.base() - 1;
  const Command command(words.begin() + 1, own);
  std::vector<char*> rest = {words.front()};
  rest.insert(rest.end(), own, words.end());
  return run_process(
      static_cast<int>(rest.size()), rest.data(), "Has a command make the plans of a run",
      [&](const ProcessOptions& options, Participant& participant) { bridge(command, options, participant); });
}

}  // namespace evbal
