#pragma once

namespace evbal {

/// From now on the first Ctrl-C (SIGINT), SIGTERM or SIGHUP asks the run to end; one that has not ended within 10 s is
/// ended, whatever it is doing, and so it is by a second signal. A signal that this process was started to ignore, as
/// under nohup or in a shell's background, stays ignored.
void catch_interrupts();

/// Throws Error{run_failed} once the run has been asked to end. Called wherever a run could be left.
void check_interrupt();

}  // namespace evbal
