#include "tools/records/csv_rows.hpp"

#include <algorithm>

namespace evbal {
namespace {

constexpr std::size_t kLongestLine = 1 << 24;       // bytes; beyond this it is no table
constexpr std::size_t kLongestOverLines = 1 << 20;  // bytes of a row from its second line on
constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The characters that part fields.
std::string_view separators(const char& separator) {
  return separator == ' ' ? kBlanks : std::string_view(&separator, 1);
}

/// The text without blanks in front; a tab that parts fields is none.
std::string_view without_leading_blanks(std::string_view text, char separator) {
  const std::size_t first = text.find_first_not_of(separator == '\t' ? std::string_view(" ") : kBlanks);
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

}  // namespace

void QuotedRow::begin_field() {
  if (fields_.size() == count_) {
    fields_.emplace_back();
  }
  fields_[count_].clear();
  ++count_;
}

QuotedRow::State QuotedRow::begin(std::string_view line) {
  count_ = 0;
  quoted_ = false;
  begin_field();
  return split(line);
}

QuotedRow::State QuotedRow::go_on(std::string_view line) {
  fields_[count_ - 1] += '\n';
  return split(line);
}

QuotedRow::State QuotedRow::split(std::string_view rest) {
  while (true) {
    std::string& field = fields_[count_ - 1];
    std::size_t end = 0;
    if (quoted_) {
      const std::size_t quote = rest.find('"');
      field.append(rest.substr(0, quote));
      if (quote == std::string_view::npos) {
        return State::open;
      }
      rest.remove_prefix(quote + 1);
      if (rest.starts_with('"')) {
        field += '"';
        rest.remove_prefix(1);
        continue;
      }
      quoted_ = false;
      end = rest.find_first_of(separators(separator_));
      if (!trimmed(rest.substr(0, end)).empty()) {
        return State::stray;
      }
    } else {
      rest = without_leading_blanks(rest, separator_);
      if (rest.starts_with('"')) {
        quoted_ = true;
        rest.remove_prefix(1);
        continue;
      }
      end = rest.find_first_of(separators(separator_));
      field.append(rest.substr(0, end));
    }
    if (end_of_row(rest, end)) {
      return State::complete;
    }
    rest.remove_prefix(end + 1);
    begin_field();
  }
}

bool QuotedRow::end_of_row(std::string_view rest, std::size_t end) {
  return end == std::string_view::npos || (separator_ == ' ' && trimmed(rest.substr(end)).empty());
}

void QuotedRow::fields(std::vector<std::string_view>& into) const {
  into.clear();
  for (std::size_t f = 0; f < count_; ++f) {
    into.push_back(trimmed(fields_[f]));
  }
}

CsvRows::CsvRows(const std::filesystem::path& file, char separator)
    : lines_(file, kLongestLine), separator_(separator), quoted_(separator) {}

bool CsvRows::take_line() {
  ++lines_taken_;
  if (ahead_.empty()) {
    return lines_.next(row_);
  }
  row_ = std::move(ahead_.front());
  ahead_.pop_front();
  return true;
}

bool CsvRows::skip_line() {
  return take_line();
}

bool CsvRows::next() {
  do {
    if (!take_line()) {
      return false;
    }
  } while (trimmed(row_).empty());
  line_ = lines_taken_;
  stray_ = false;
  if (row_.find('"') == std::string::npos) {
    split_plain();
  } else {
    split_quoted();
  }
  if (expected_ == 0 && !stray_) {
    expected_ = fields_.size();
  }
  return true;
}

void CsvRows::split_plain() {
  fields_.clear();
  std::string_view rest = row_;
  const std::string_view ends = separators(separator_);
  for (std::size_t end = rest.find_first_of(ends); end != std::string_view::npos; end = rest.find_first_of(ends)) {
    if (separator_ != ' ' || end > 0) {
      fields_.push_back(trimmed(rest.substr(0, end)));
    }
    rest.remove_prefix(end + 1);
  }
  if (separator_ != ' ' || !rest.empty()) {
    fields_.push_back(trimmed(rest));
  }
}

void CsvRows::split_quoted() {
  std::size_t more = 0;  // lines of ahead_ that belong to the row
  std::size_t bytes = 0;
  auto state = quoted_.begin(row_);
  std::string line;
  while (state == QuotedRow::State::open && bytes <= kLongestOverLines) {
    if (more == ahead_.size()) {
      if (!lines_.next(line)) {
        break;
      }
      ahead_.push_back(line);
    }
    bytes += ahead_[more].size() + 1;
    state = quoted_.go_on(ahead_[more]);
    ++more;
  }
  quoted_.fields(fields_);
  stray_ = state != QuotedRow::State::complete || (more > 0 && expected_ > 0 && fields_.size() != expected_);
  if (!stray_) {
    ahead_.erase(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(more));
    lines_taken_ += static_cast<int>(more);
  }
}

Error CsvRows::error(const std::string& message) const {
  return bad_input(file(), line_, message);
}

}  // namespace evbal
