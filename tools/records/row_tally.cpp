#include "tools/records/row_tally.hpp"

namespace evbal {
namespace {

constexpr long long kRowsToJudge = 100;

}  // namespace

bool RowTally::keeps(const RowFault& fault) {
  if (fault) {
    dropped_.add(fault.reason, table_.file(), table_.line(), fault.value);
  }
  const bool lacks_value = fault && fault.unreadable && fault.value.empty();
  rows_ += lacks_value ? 0 : 1;
  if (!fault || !fault.unreadable || lacks_value) {
    return !fault;
  }
  if (unreadable_ == 0) {
    first_ = table_.error(std::string(fault.reason) + ": " + shown(fault.value)).what();
  }
  ++unreadable_;
  if (rows_ == kRowsToJudge && unreadable_ == rows_) {
    throw refused();
  }
  return false;
}

void RowTally::finish() const {
  if (rows_ > 0 && unreadable_ == rows_) {
    throw refused();
  }
}

Error RowTally::refused() const {
  return bad_input(first_ + "; none of " + std::to_string(rows_) +
                   " rows can be read: is the description of this table?");
}

}  // namespace evbal
