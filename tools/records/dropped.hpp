#pragma once

#include <map>
#include <string>
#include <string_view>

namespace evbal {

/// Rows of raw records that are left out: how many by reason, and the first of each.
class Dropped {
 public:
  /// Counts a row of `file`. `value` is what stands there instead of what `reason` asks for; it may be any bytes.
  void add(std::string_view reason, const std::string& file, int line, std::string_view value);

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

}  // namespace evbal
