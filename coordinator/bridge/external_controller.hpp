#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/world.hpp"
#include "coordinator/planning/settings.hpp"

#include <unistd.h>

#include <memory>
#include <string>
#include <vector>

namespace evbal {

/// A controller outside of evbal that makes the plans of a day.
class ExternalController {
 public:
  ExternalController() = default;
  virtual ~ExternalController() = default;
  ExternalController(const ExternalController&) = delete;
  ExternalController& operator=(const ExternalController&) = delete;

  /// The plan of `tick`, which is due; `reports` are what came. To be called for each such tick, in turn. Throws
  /// Error{bad_input} if the answer is wrong and Error{run_failed} if none comes; either names the controller and where
  /// in its answers it went wrong.
  virtual Plan plan(const Tick& tick, const std::vector<Report>& reports) = 0;

  /// Ends it, also while another thread is in plan().
  virtual void end() {}
};

/// Starts the controller that `settings.coordinator` names: a shared library in this process (evbal_controller.h), or a
/// child process that speaks in lines of JSON (json_lines.hpp), whose stderr is the open file `errors`. `scenario` is
/// the resolved scenario's text; `world` must outlive the controller. Throws Error{bad_input} or Error{run_failed} if
/// it cannot be started.
std::unique_ptr<ExternalController> start_controller(const World& world, const PlanningSettings& settings,
                                                     const std::string& scenario, int errors = STDERR_FILENO);

}  // namespace evbal
