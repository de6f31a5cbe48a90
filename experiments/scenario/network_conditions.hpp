#pragma once

#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

namespace evbal {

/// What becomes of packets between each agent and the other processes, below DDS, in either direction.
struct NetworkConditions {
  double loss = 0.0;      ///< probability that a packet is lost, at most 0.5
  double delay_ms = 0.0;  ///< by which every other one comes later, at most 1000
};

/// Reads {loss: 0.1, delay: 20ms}; either may be left out. Throws Error{bad_input} with file and line.
NetworkConditions read_network(const YamlValue& value);

/// Writes the same map: read_network gives it back.
void write_network(YamlWriter& yaml, const NetworkConditions& network);

}  // namespace evbal
