#pragma once

#include "tools/gps/fixes.hpp"
#include "tools/records/raw_table.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace evbal {

/// Reads the rows of a table of fixes.
class FixRows {
 public:
  /// `format` must outlive this.
  explicit FixRows(const GpsFormat& format);

  /// Reads a row into `fix`, a local time as the table shows it, or says what is wrong with it.
  RowFault read(const RawTable& row, Fix& fix) const;

 private:
  const GpsFormat& format_;
  std::optional<long long> occupied_number_;  ///< that the word is, if it is one
  std::optional<long long> free_number_;
  std::string no_flag_;
};

/// The vehicle that a file is named after. Throws Error{bad_input}.
std::string vehicle_of(const std::filesystem::path& file, const GpsFormat& format);

}  // namespace evbal
