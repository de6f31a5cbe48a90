#pragma once

#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <filesystem>
#include <optional>

namespace evbal {

/// A run whose processes prove to one another that they belong to it, and whose messages are encrypted.
struct BusSecurity {
  std::filesystem::path ca{};  ///< folder of one's own certificate authority; empty: one is made for the run
};

/// Reads `off`, `on` or {ca: FOLDER}, where a relative folder is beside the file. Throws Error{bad_input} with file and
/// line.
std::optional<BusSecurity> read_security(const YamlValue& value);

/// Writes what is read back as the same; not for `off`.
void write_security(YamlWriter& yaml, const BusSecurity& security);

}  // namespace evbal
