#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal slurm-task`, which a job array runs; not for users.
void add_slurm_task_command(CLI::App& app);

}  // namespace evbal
