#include "experiments/study/executors/day_keys.hpp"

#include "common/digest.hpp"
#include "common/interrupt.hpp"
#include "common/version.hpp"
#include "experiments/scenario/input_digests.hpp"

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// The digest of what has a name, made by `digest` when it is asked for first.
template <class Name, class MakeDigest>
const std::string& known(std::map<Name, std::string>& digests, const Name& name, const MakeDigest& digest) {
  const auto at = digests.find(name);
  return at != digests.end() ? at->second : digests.emplace(name, digest(name)).first->second;
}

}  // namespace

std::string DayKeys::of(const Scenario& scenario, const std::string& controller) {
  const fs::path model = model_file(scenario.planning, scenario.world.city);
  const Command& coordinator = scenario.planning.coordinator;
  const std::string by = coordinator.empty() ? "" : "\ncoordinator " + known(commands_, coordinator, command_digest);
  return text_digest(resolved_yaml(scenario, controller) + by + "\npack " +
                     known(packs_, scenario.world.city.folder, pack_digest) + "\nmodel " +
                     known(models_, model, model_digest) + "\nversion " + version());
}

std::vector<std::string> keys_of(const Sweep& sweep) {
  DayKeys day_keys;
  std::vector<std::string> keys;
  for (const auto& day : sweep.days) {
    const Scenario scenario = scenario_of(day);
    keys.push_back(day_keys.of(scenario, day.controller));
    check_interrupt();
  }
  return keys;
}

}  // namespace evbal
