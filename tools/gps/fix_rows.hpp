#pragma once

#include "tools/gps/fixes.hpp"
#include "tools/records/raw_table.hpp"

#include <string>
#include <string_view>

namespace evbal {

/// The complaint about a row that can be read, but tells no place.
inline constexpr std::string_view kNowhere = "at 0,0, which receivers write that know no place";

/// Reads the rows of a table of fixes.
class FixRows {
 public:
  /// `format` must outlive this.
  explicit FixRows(const GpsFormat& format);

  /// What is wrong with a row: the value, and what it should be. No reason if nothing is.
  struct Complaint {
    std::string_view reason;  ///< valid as long as the reader
    std::string_view value;   ///< valid as long as the row
  };

  /// Reads a row into `fix`; a local time as the table shows it.
  Complaint read(const RawTable& row, Fix& fix) const;

 private:
  const GpsFormat& format_;
  std::string no_flag_;
};

/// The vehicle that a file is named after. Throws Error{bad_input}.
std::string vehicle_of(const std::filesystem::path& file, const GpsFormat& format);

}  // namespace evbal
