#pragma once

#include "tools/records/dropped.hpp"
#include "tools/records/raw_table.hpp"

#include <string>

namespace evbal {

/// Counts the rows of one table, and refuses the table if the description does not fit it: none of its rows can be
/// read, or none of the first hundred. Rows that lack a value speak neither for nor against it.
class RowTally {
 public:
  /// Both must outlive this. What is dropped is added to `dropped`.
  RowTally(const RawTable& table, Dropped& dropped) : table_(table), dropped_(dropped) {}

  /// Counts the current row: dropped for its fault, or kept if it has none, which is what is returned. Throws
  /// Error{bad_input} at the first row if it is the hundredth and none could be read.
  bool keeps(const RowFault& fault);

  /// The table is at its end. Throws as keeps() does if it has rows and none could be read.
  void finish() const;

 private:
  Error refused() const;

  const RawTable& table_;
  Dropped& dropped_;
  long long rows_ = 0;
  long long unreadable_ = 0;
  std::string first_;  ///< unreadable row, and why
};

}  // namespace evbal
