#include "tools/records/dropped.hpp"

#include "common/plain_text.hpp"

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

constexpr std::size_t kMostBytes = 60;  // of a value that is shown

/// The value as one line of text: bytes that are none as `?`, and no longer than a reader needs.
std::string shown(std::string_view value) {
  std::string text(value.substr(0, kMostBytes));
  while (!line_complaint(text).empty()) {
    const std::size_t byte = find_invalid_utf8(text);
    text[std::min({byte, find_control_character(text), text.find_first_of("\r\n\t")})] = '?';
  }
  return "`" + text + (value.size() > kMostBytes ? "..." : "") + "`";
}

}  // namespace

void Dropped::add(std::string_view reason, const std::string& file, int line, std::string_view value) {
  auto found = reasons_.find(reason);
  if (found == reasons_.end()) {
    found = reasons_.emplace(reason, Reason{0, file + ":" + std::to_string(line) + ": " + shown(value)}).first;
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

}  // namespace evbal
