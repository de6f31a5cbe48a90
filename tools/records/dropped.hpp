#pragma once

#include "common/error.hpp"

#include <map>
#include <string>
#include <string_view>

namespace evbal {

/// Rows of raw records that are left out: how many by reason, and the first of each.
class Dropped {
 public:
  /// Counts a row of `file`. `value` is what stands there instead of what `reason` asks for; it may be any bytes.
  void add(std::string_view reason, const std::string& file, int line, std::string_view value);

  /// Counts what stands at `where`, if that is no line of a file.
  void add(std::string_view reason, const std::string& where, std::string_view value);

  /// Rows left out for this reason.
  long long rows(std::string_view reason) const;

  /// Rows left out.
  long long rows() const;

  /// A line for each reason, in alphabetical order: "  dropped, REASON: ROWS (first: FILE:LINE: `VALUE`)".
  std::string report() const;

 private:
  struct Reason {
    long long rows = 0;
    std::string first;
  };
  std::map<std::string, Reason, std::less<>> reasons_;
};

/// A value as messages show it: in backticks, on one line, cut after 60 bytes.
std::string shown(std::string_view value);

/// The same error, followed by what was read and left out before it.
Error with_report(const Error& error, const std::string& report);

}  // namespace evbal
