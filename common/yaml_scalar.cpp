#include "common/decimal.hpp"
#include "common/plain_text.hpp"
#include "common/yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace evbal {
namespace {

/// A decimal number: no hexadecimal, no infinities, no leading zero that YAML 1.1 would read as octal.
std::optional<double> parsed_number(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string_view::npos || text.front() == '+') {
    return std::nullopt;
  }
  const std::string_view digits = text.front() == '-' ? text.substr(1) : text;
  if (digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9') {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

template <class Integer>
std::optional<Integer> parsed_integer(std::string_view text) {
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  if (digits.size() > 1 && digits[0] == '0') {
    return std::nullopt;
  }
  Integer value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

const std::string& YamlValue::scalar(const char* expected) const {
  if (!node_->IsScalar()) {
    throw error(std::string("expected ") + expected);
  }
  if (const auto wrong = validate_line(node_->Scalar()); !wrong.empty()) {
    throw error(std::string(expected) + " is expected, and this " + wrong);
  }
  return node_->Scalar();
}

std::string YamlValue::text() const {
  return scalar("a text");
}

std::string YamlValue::paragraphs() const {
  if (!is_scalar()) {
    throw error("expected a text");
  }
  return node_->Scalar();
}

std::string YamlValue::file_name() const {
  std::string name = text();
  if (const auto wrong = validate_file_name(name); !wrong.empty()) {
    throw error("name `" + name + "` " + wrong);
  }
  return name;
}

double YamlValue::number() const {
  const std::string& text = scalar("a number");
  const auto value = parsed_number(text);
  if (!value) {
    throw error("`" + text + "` is no number; write a plain decimal such as 1.5");
  }
  return *value;
}

double YamlValue::number(double low, double high) const {
  const double value = number();
  if (value < low || value > high) {
    throw error("`" + text() + "` is out of range; give a number from " + decimal(low) + " to " + decimal(high));
  }
  return value;
}

int YamlValue::integer() const {
  const std::string& text = scalar("a whole number");
  const auto value = parsed_integer<int>(text);
  if (!value) {
    throw error("`" + text + "` is no whole number; write digits only, such as 12");
  }
  return *value;
}

int YamlValue::integer(int low, int high) const {
  const int value = integer();
  if (value < low || value > high) {
    throw error("`" + text() + "` is out of range; give a whole number from " + std::to_string(low) + " to " +
                std::to_string(high));
  }
  return value;
}

std::uint64_t YamlValue::seed() const {
  const std::string& text = scalar("a seed");
  const auto value = parsed_integer<std::uint64_t>(text);
  if (!value) {
    throw error("`" + text + "` is no seed; write a whole number from 0 to 2^64-1");
  }
  return *value;
}

bool YamlValue::boolean() const {
  const std::string& text = scalar("true or false");
  if (text != "true" && text != "false") {
    throw error("`" + text + "` is neither `true` nor `false`");
  }
  return text == "true";
}

double YamlValue::duration() const {
  const std::string& text = scalar("a duration");
  const std::size_t unit_at = text.find_first_not_of("0123456789.");
  const std::string unit = unit_at == std::string::npos ? "" : text.substr(unit_at);
  const auto amount = parsed_number(text.substr(0, unit_at));
  const double per_minute = unit == "ms" ? 60'000.0 : unit == "s" ? 60.0 : unit == "min" ? 1.0 : 0.0;
  if (!amount || (per_minute == 0.0 && unit != "h")) {
    throw error("`" + text + "` is no duration; write a number and ms, s, min or h, such as 30min");
  }
  const double minutes = unit == "h" ? *amount * 60.0 : *amount / per_minute;
  // 4.1 has no exact binary form: 4.1 * 60 is a little less than 246.
  constexpr double rounding_error = 1e-9;
  const double whole = std::round(minutes);
  return std::abs(minutes - whole) <= rounding_error * minutes ? whole : minutes;
}

double YamlValue::duration(double low, double high) const {
  const double minutes = duration();
  if (minutes < low || minutes > high) {
    const auto shown = [](double bound) {
      const bool hours = bound >= 60.0 && std::fmod(bound, 60.0) == 0.0;
      return hours ? decimal(bound / 60.0) + "h" : decimal(bound) + "min";
    };
    throw error("`" + text() + "` is out of range; give a duration from " + shown(low) + " to " + shown(high));
  }
  return minutes;
}

int YamlValue::whole_minutes() const {
  const double minutes = duration();
  if (minutes < 1.0 || minutes != std::floor(minutes) || minutes > 24.0 * 60.0) {
    throw error("`" + text() + "` must be whole minutes, from 1min to 24h");
  }
  return static_cast<int>(minutes);
}

int YamlValue::time_of_day() const {
  const std::string& text = scalar("a time of day");
  const auto hours = text.size() == 5 && text[2] == ':' ? std::optional(text.substr(0, 2)) : std::nullopt;
  const auto is_digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  if (hours && is_digit(0) && is_digit(1) && is_digit(3) && is_digit(4)) {
    const int hour = (text[0] - '0') * 10 + (text[1] - '0');
    const int minute = (text[3] - '0') * 10 + (text[4] - '0');
    if (minute < 60 && hour * 60 + minute <= 24 * 60) {
      return hour * 60 + minute;
    }
  }
  throw error("`" + text + "` is no time of day; write \"17:30\", from \"00:00\" to \"24:00\"");
}

std::size_t YamlValue::one_of(const std::vector<std::string>& words) const {
  const std::string& text = scalar("a word");
  if (const auto wrong = validate_word(text, words); !wrong.empty()) {
    throw error(wrong);
  }
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), text) - words.begin());
}

}  // namespace evbal
