// evbal-faults: says what goes wrong, tick by tick.

#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "agents/world/world.hpp"
#include "faults/schedule/schedule.hpp"

#include <utility>

namespace {

using namespace evbal;

void inject(const ProcessOptions& options, Participant& participant) {
  YamlMap scenario(YamlValue::load(options.scenario));
  const World world = read_world(scenario);
  const Eigen::VectorXi points = world.city.points();
  const FaultContext context{world.clock, {points.begin(), points.end()}};
  Schedule schedule = read_resolved(scenario, context);
  const auto amended = [&] {
    YamlMap again(YamlValue::load(options.scenario));
    const Schedule before = std::exchange(schedule, read_resolved(again, context));
    return schedule != before;
  };
  serve_injector(participant, options,
                 {.faults = [&](int tick) { return faults_at(schedule, world.clock, tick); }, .amended = amended});
}

}  // namespace

int main(int argc, char** argv) {
  return evbal::run_process(argc, argv, "Says what goes wrong in a run; started by evbal run", inject);
}
