#pragma once

namespace evbal {

/// Makes Fast DDS, in this process and in those that it starts, as it is without any surroundings: removes from the
/// environment what sets profiles, transports and discovery servers for other programs, and forbids the profiles of the
/// working directory. Without effect once that is done. To be called while no other thread reads the environment.
void ignore_surroundings();

}  // namespace evbal
