#pragma once

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// Something that was looked at.
struct Finding {
  std::string what;          ///< "UDP over 127.0.0.1"
  std::optional<bool> well;  ///< whether it is as it should be; none if it may be either way
  std::string cure;          ///< what would be right, where it is not well
};

/// What this machine lacks, what runs left over that broke off, and what else may explain much. With `clean` the
/// leftovers are removed. Throws Error{run_failed} if one cannot be.
std::vector<Finding> diagnose(bool clean);

}  // namespace evbal
