#pragma once

#include "agents/protocol/fields.hpp"

#include <string>

namespace evbal {

/// A process to the conductor, once its ends of all topics have found theirs.
struct Hello {
  std::string name;  ///< as the conductor started it: "agent-0", "coordinator", "faults"
  std::int64_t process_id = 0;
};

template <class Visit>
void fields(Visit&& visit, Is<Hello> auto& m) {
  visit("name", m.name);
  visit("process_id", m.process_id);
}

}  // namespace evbal
