#pragma once

#include "coordinator/balancing/controllers.hpp"

#include <vector>

namespace evbal {

/// The main of a coordinator: joins the run that evbal started it for, and makes its plans by the controller that the
/// scenario names, one of `own` or of evbal's. Ends with a line on stderr and an exit status if that controller is
/// neither, or if `own` takes a name of evbal's.
int run_coordinator(int argc, char** argv, const std::vector<Controller>& own = {});

}  // namespace evbal
