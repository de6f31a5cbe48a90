#pragma once

namespace evbal {

/// From now on the first Ctrl-C (SIGINT), SIGTERM or SIGHUP only asks the run to end; a second one ends the process.
void catch_interrupts();

/// Throws Error{run_failed} once the run has been asked to end. Called wherever a run could be left.
void check_interrupt();

}  // namespace evbal
