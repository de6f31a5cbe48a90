#pragma once

namespace CLI {
class App;
}

namespace evbal {

/// Adds `evbal doctor`: what this machine lacks, and what earlier runs left over.
/// The command throws Error, whose status main exits with.
void add_doctor_command(CLI::App& app);

}  // namespace evbal
