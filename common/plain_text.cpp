#include "common/plain_text.hpp"

#include <sstream>

namespace evbal {
namespace {

/// Bytes of the UTF-8 character that `text` begins with, 0 if it begins with none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) {
    return 1;
  }
  const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (length == 0 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  const unsigned char second = byte(1);
  const bool longer_than_needed = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool half_of_a_pair = first == 0xED && second > 0x9F;  // of UTF-16
  const bool beyond_unicode = first == 0xF4 && second > 0x8F;
  return longer_than_needed || half_of_a_pair || beyond_unicode ? 0 : length;
}

}  // namespace

std::size_t find_invalid_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text.substr(at));
    if (length == 0) {
      return at;
    }
    at += length;
  }
  return std::string_view::npos;
}

std::size_t find_control_character(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if ((byte < 0x20 && text[at] != '\t' && text[at] != '\n' && text[at] != '\r') || byte == 0x7F) {
      return at;
    }
  }
  return std::string_view::npos;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string validate_line(std::string_view text) {
  if (find_invalid_utf8(text) != std::string_view::npos) {
    return "is not UTF-8; write it in UTF-8";
  }
  if (text.find_first_of("\n\r") != std::string_view::npos) {
    return "holds a line break; write it in one line";
  }
  if (text.find('\t') != std::string_view::npos || find_control_character(text) != std::string_view::npos) {
    return "holds a control character; leave it out";
  }
  return "";
}

std::string validate_file_name(std::string_view text) {
  constexpr std::size_t longest = 100;
  if (auto wrong = validate_line(text); !wrong.empty()) {
    return wrong;
  }
  if (text.empty() || text.size() > longest) {
    return "must have 1 to " + std::to_string(longest) + " bytes, for files are named after it";
  }
  if (text.front() == '.' || text.find('/') != std::string_view::npos) {
    return "may not begin with `.` nor hold `/`, for files are named after it";
  }
  return "";
}

}  // namespace evbal
