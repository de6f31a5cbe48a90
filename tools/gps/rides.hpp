#pragma once

#include "tools/gps/fixes.hpp"

#include <optional>

namespace evbal {

/// From the first fix with passengers to the first without.
struct Ride {
  Fix pickup;   ///< first fix with passengers
  Fix dropoff;  ///< first fix without
};

/// A way without passengers: from the drop-off, or from where the records begin or go on after a gap.
struct VacantMove {
  /// Why it ended: passengers got in, the records have a gap, or they end.
  enum class End { pickup, gap, records };
  Fix from;                ///< the drop-off, or the first fix of the records or after a gap
  Fix to;                  ///< the pick-up, or the last fix before the gap or of the records
  double km = 0.0;         ///< sum of the straight lines between its fixes
  End end = End::records;  ///< why it ended
};

/// Metres between two fixes.
double metres_between(const Fix& a, const Fix& b);

/// Finds rides and vacant moves in the fixes of one vehicle. Rides that are under way when the records begin or end are
/// no rides.
class RideFinder {
 public:
  /// A gap of more than `longest_gap` minutes ends a vacant move.
  explicit RideFinder(double longest_gap) : longest_gap_(longest_gap) {}

  /// What a fix completes.
  struct Found {
    std::optional<Ride> ride;          ///< that ends with the fix
    std::optional<VacantMove> vacant;  ///< that ends with the fix, or with the one before
  };

  /// The fix that follows in time.
  Found add(const Fix& fix);

  /// The last vacant move.
  std::optional<VacantMove> finish();

  /// Rides that were under way when the records began or, after finish(), ended.
  int cut_off() const { return cut_off_; }

 private:
  std::optional<VacantMove> end_vacant(const Fix& to, VacantMove::End end);

  double longest_gap_;
  std::optional<Fix> last_;
  std::optional<Fix> pickup_;
  std::optional<Fix> vacant_from_;
  double vacant_km_ = 0.0;
  int cut_off_ = 0;
};

}  // namespace evbal
