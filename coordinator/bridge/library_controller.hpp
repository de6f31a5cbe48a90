#pragma once

#include "coordinator/bridge/external_controller.hpp"

#include <memory>

namespace evbal {

/// The shared library that `settings.coordinator` names, as evbal_controller.h has it, loaded into this process.
/// `world` must outlive it. Throws Error{bad_input} if it is no such library.
std::unique_ptr<ExternalController> load_library(const World& world, const PlanningSettings& settings);

}  // namespace evbal
