#pragma once

#include "tools/records/raw_table.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// How a table of charging sessions is laid out and what its columns mean (docs/ingest.md).
struct SessionFormat {
  TableFormat table;                   ///< separator, header and columns
  std::vector<std::size_t> start;      ///< columns that tell together when a session starts, with a blank between
  std::vector<std::size_t> end;        ///< and when it ends
  std::optional<std::size_t> charger;  ///< column of the charger's model, if there is one
  std::string time;                    ///< form of both times, as time_like takes it; empty: unix seconds
};

/// Reads its keys, which may stand among others. Throws Error{bad_input} with file and line.
SessionFormat read_session_format(YamlMap& map);

/// Reads such a file. Throws Error{bad_input} with file and line.
SessionFormat read_session_format(const std::filesystem::path& file);

/// That of the open data of Dundee City Council: tools/ingest/dundee.yaml.
SessionFormat dundee_session_format();

}  // namespace evbal
