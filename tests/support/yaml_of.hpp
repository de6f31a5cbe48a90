#pragma once

#include "common/yaml_writer.hpp"

#include <string>

namespace evbal {

/// What `write` writes into a map of its own.
template <class Write>
std::string yaml_of(Write write) {
  YamlWriter yaml;
  write(yaml);
  return yaml.finish();
}

}  // namespace evbal
