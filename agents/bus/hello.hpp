#pragma once

#include <cstdint>
#include <string>

namespace evbal {

/// A process to the conductor, once its ends of all topics have found theirs.
struct Hello {
  std::string name;             ///< as the conductor started it: "agent-0", "coordinator", "faults"
  std::int64_t process_id = 0;  ///< of the writer, as the operating system counts
};

}  // namespace evbal
