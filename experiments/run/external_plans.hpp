#pragma once

#include "experiments/conductor/inproc_players.hpp"
#include "experiments/scenario/scenario.hpp"

#include <filesystem>

namespace evbal {

/// Plans of the scenario's day, in turn, by the coordinator that it names in place of evbal's, as a part of this
/// process or a child of it that lives as long as the function. What a child prints on stderr goes to
/// `folder`/processes/coordinator.log, with an empty `folder` nowhere; its last lines stand in the error if the
/// controller fails. `scenario` must outlive the function. Throws as ExternalController does.
InprocPlayers::Planner external_plans(const Scenario& scenario, const std::filesystem::path& folder);

}  // namespace evbal
