#include "tools/records/dropped.hpp"

#include "common/plain_text.hpp"

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

constexpr std::size_t kMostBytes = 60;  // of a value that is shown

}  // namespace

std::string shown(std::string_view value) {
  std::string text(value.substr(0, kMostBytes));
  while (!validate_line(text).empty()) {
    const std::size_t byte = find_invalid_utf8(text);
    text[std::min({byte, find_control_character(text), text.find_first_of("\r\n\t")})] = '?';
  }
  return "`" + text + (value.size() > kMostBytes ? "..." : "") + "`";
}

void Dropped::add(std::string_view reason, const std::string& file, int line, std::string_view value) {
  auto found = reasons_.find(reason);
  if (found == reasons_.end()) {
    found = reasons_.emplace(reason, Reason{0, file + ":" + std::to_string(line) + ": " + shown(value)}).first;
  }
  ++found->second.rows;
}

void Dropped::add(std::string_view reason, const std::string& where, std::string_view value) {
  auto found = reasons_.find(reason);
  if (found == reasons_.end()) {
    found = reasons_.emplace(reason, Reason{0, where + (value.empty() ? "" : ": " + shown(value))}).first;
  }
  ++found->second.rows;
}

long long Dropped::rows(std::string_view reason) const {
  const auto found = reasons_.find(reason);
  return found == reasons_.end() ? 0 : found->second.rows;
}

long long Dropped::rows() const {
  return std::accumulate(reasons_.begin(), reasons_.end(), 0LL,
                         [](long long sum, const auto& reason) { return sum + reason.second.rows; });
}

std::string Dropped::report() const {
  std::string text;
  for (const auto& [reason, dropped] : reasons_) {
    text += "  dropped, " + reason + ": " + std::to_string(dropped.rows) + " (first: " + dropped.first + ")\n";
  }
  return text;
}

Error with_report(const Error& error, const std::string& report) {
  const std::string lines = report.ends_with('\n') ? report.substr(0, report.size() - 1) : report;
  return {error.status(), lines.empty() ? error.what() : error.what() + ("\n" + lines)};
}

}  // namespace evbal
