#pragma once

#include "coordinator/balancing/controllers.hpp"

#include <vector>

namespace evbal {

/// The main of a coordinator: makes the plans of the run that evbal started it for, by the controller that the scenario
/// names, one of `own` or of evbal's. Started with the words of the bus it takes part there, without any words in lines
/// of JSON on standard input and output (coordinator/bridge/json_lines.hpp). Ends with a line on stderr and an exit
/// status if that controller is neither, or if `own` takes a name of evbal's.
int run_coordinator(int argc, char** argv, const std::vector<Controller>& own = {});

}  // namespace evbal
