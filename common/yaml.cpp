#include "common/yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

namespace evbal {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) {
    text += (text.empty() ? "`" : ", `") + word + "`";
  }
  return text;
}

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// Plain decimal only: no hexadecimal, no infinities, no leading zero that YAML 1.1 would read as octal.
std::optional<double> decimal(std::string_view text) {
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
std::optional<Integer> whole(std::string_view text) {
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

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& words) {
  const auto best = std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  if (best == words.end() || edit_distance(word, *best) > std::max<std::size_t>(2, best->size() / 3)) {
    return "";
  }
  return " (did you mean `" + *best + "`?)";
}

YamlValue::YamlValue(std::shared_ptr<const YAML::Node> node, std::shared_ptr<const std::string> file)
    : node_(std::move(node)), file_(std::move(file)) {}

YamlValue YamlValue::load(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw bad_input(file.string(), 0, "cannot be read; give an existing YAML file");
  }
  std::ostringstream text;
  text << in.rdbuf();
  return parse(text.str(), file.string());
}

YamlValue YamlValue::parse(const std::string& text, const std::string& name) {
  try {
    const YAML::Node node = YAML::Load(text);
    if (node.IsNull()) {
      throw bad_input(name, 1, "is empty; a YAML map is expected");
    }
    return {std::make_shared<YAML::Node>(node), std::make_shared<std::string>(name)};
  } catch (const YAML::Exception& e) {
    throw bad_input(name, e.mark.line + 1, "not valid YAML: " + e.msg);
  }
}

bool YamlValue::is_map() const {
  return node_->IsMap();
}

bool YamlValue::is_list() const {
  return node_->IsSequence();
}

bool YamlValue::is_scalar() const {
  return node_->IsScalar();
}

int YamlValue::line() const {
  if (node_->Mark().is_null() && !settings_.empty()) {  // a map that is there for its settings only
    return settings_.front().value.line();
  }
  return node_->Mark().line + 1;
}

const std::string& YamlValue::file() const {
  return *file_;
}

Error YamlValue::error(const std::string& message) const {
  return bad_input(*file_, line(), message);
}

const std::string& YamlValue::scalar(const char* expected) const {
  if (!node_->IsScalar()) {
    throw error(std::string("expected ") + expected);
  }
  return node_->Scalar();
}

std::string YamlValue::text() const {
  return scalar("a text");
}

double YamlValue::number() const {
  const std::string& text = scalar("a number");
  const auto value = decimal(text);
  if (!value) {
    throw error("`" + text + "` is no number; write a plain decimal such as 1.5");
  }
  return *value;
}

double YamlValue::number(double low, double high) const {
  const double value = number();
  if (value < low || value > high) {
    throw error("`" + text() + "` is out of range; give a number from " + shown(low) + " to " + shown(high));
  }
  return value;
}

int YamlValue::integer() const {
  const std::string& text = scalar("a whole number");
  const auto value = whole<int>(text);
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
  const auto value = whole<std::uint64_t>(text);
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
  const auto amount = decimal(text.substr(0, unit_at));
  const double minutes = unit == "ms"    ? 1.0 / 60'000.0
                         : unit == "s"   ? 1.0 / 60.0
                         : unit == "min" ? 1.0
                         : unit == "h"   ? 60.0
                                         : 0.0;
  if (!amount || minutes == 0.0) {
    throw error("`" + text + "` is no duration; write a number and ms, s, min or h, such as 30min");
  }
  return *amount * minutes;
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
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    throw error("`" + text + "` is not known" + did_you_mean(text, words) + "; choose one of " + joined(words));
  }
  return static_cast<std::size_t>(found - words.begin());
}

std::vector<YamlValue> YamlValue::items() const {
  if (!is_list()) {
    throw error("expected a list");
  }
  std::vector<YamlValue> values;
  for (const auto& item : *node_) {
    values.push_back({std::make_shared<YAML::Node>(item), file_});
  }
  return values;
}

std::string YamlValue::dump() const {
  return YAML::Dump(*node_);
}

YamlValue YamlValue::with(const std::string& path, const YamlValue& value) const {
  YamlValue copy = *this;
  copy.settings_.push_back({path, value});
  return copy;
}

YamlMap::YamlMap(const YamlValue& value) : value_(value) {
  if (!value.is_map()) {
    throw value.error("expected a map of `key: value`");
  }
  for (const auto& entry : *value.node_) {
    const YamlValue key{std::make_shared<YAML::Node>(entry.first), value.file_};
    const std::string name = key.text();
    const YamlValue content{std::make_shared<YAML::Node>(entry.second), value.file_};
    if (!entries_.emplace(name, content).second) {
      throw key.error("key `" + name + "` is given twice");
    }
    key_places_.emplace(name, key);
    order_.push_back(name);
  }
  for (const auto& setting : value.settings_) {
    set(setting);
  }
}

void YamlMap::set(const YamlValue::Setting& setting) {
  const std::size_t dot = setting.path.find('.');
  const std::string key = setting.path.substr(0, dot);
  const auto found = entries_.find(key);
  YamlValue content = setting.value;
  if (dot != std::string::npos) {
    if (found != entries_.end() && !found->second.is_map()) {
      throw setting.value.error("`" + key + "` holds no keys, so none can be set in it");
    }
    const YamlValue empty{std::make_shared<YAML::Node>(YAML::NodeType::Map), setting.value.file_};
    content = (found == entries_.end() ? empty : found->second).with(setting.path.substr(dot + 1), setting.value);
  }
  if (found == entries_.end()) {
    order_.push_back(key);
    key_places_.emplace(key, setting.value);
  }
  entries_.insert_or_assign(key, content);
}

std::optional<YamlValue> YamlMap::find(const std::string& key) {
  known_.insert(key);
  const auto found = entries_.find(key);
  return found == entries_.end() ? std::nullopt : std::optional(found->second);
}

YamlValue YamlMap::require(const std::string& key) {
  auto value = find(key);
  if (!value) {
    throw value_.error("key `" + key + "` is missing");
  }
  return *value;
}

void YamlMap::finish() const {
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& key : order_) {
    if (!known_.contains(key)) {
      throw key_places_.at(key).error("unknown key `" + key + "`" + did_you_mean(key, known) + "; known are " +
                                      joined(known));
    }
  }
}

}  // namespace evbal
