#include "experiments/study/executors/day_keys.hpp"

#include "common/digest.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "common/version.hpp"
#include "experiments/scenario/input_digests.hpp"

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// The digest of a path, made by `digest` when it is asked for first.
template <class MakeDigest>
const std::string& known(std::map<fs::path, std::string>& digests, const fs::path& path, const MakeDigest& digest) {
  const auto at = digests.find(path);
  return at != digests.end() ? at->second : digests.emplace(path, digest(path)).first->second;
}

}  // namespace

std::string DayKeys::of(const Scenario& scenario, const std::string& controller) {
  const fs::path model = model_file(scenario.planning, scenario.world.city);
  return text_digest(resolved_yaml(scenario, controller) + "\npack " +
                     known(packs_, scenario.world.city.folder, pack_digest) + "\nmodel " +
                     known(models_, model, model_digest) + "\nversion " + version());
}

std::vector<std::string> keys_of(const Sweep& sweep) {
  DayKeys day_keys;
  std::vector<std::string> keys;
  for (const auto& day : sweep.days) {
    const Scenario scenario = scenario_of(day);
    if (!scenario.planning.coordinator.empty()) {
      throw bad_input("coordinator `" + shown(scenario.planning.coordinator) +
                      "`: takes part over the bus, without which sweeps play their days; use `evbal run`");
    }
    keys.push_back(day_keys.of(scenario, day.controller));
    check_interrupt();
  }
  return keys;
}

}  // namespace evbal
