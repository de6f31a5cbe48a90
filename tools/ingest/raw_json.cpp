#include "tools/ingest/raw_json.hpp"

#include "common/error.hpp"
#include "tools/records/raw_numbers.hpp"
#include "tools/records/text_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace evbal {

using nlohmann::json;

json read_raw_json(const std::filesystem::path& file, const std::string& kind, const std::string& whole) {
  constexpr int kDeepest = 100;  // levels: functions that go through a value call themselves
  const std::string text = unpacked_text(file);
  const auto shallow = [&](int depth, json::parse_event_t, const json&) {
    if (depth > kDeepest) {
      throw bad_input(file.string(), 0, "is no " + kind + ": it is nested more than a hundred levels deep");
    }
    return true;
  };
  try {
    return json::parse(text, shallow);
  } catch (const json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end == text.begin() ? end : std::prev(end), '\n');
    const std::string what = error.what();
    std::string wrong = what.substr(what.find(": ", what.find(", column ")) + 2);
    if (what.find("; expected end of input") != std::string::npos) {
      wrong = "something follows its end; put all into one " + whole;
    } else if (error.byte + 1 >= text.size()) {
      wrong = "it breaks off; is the file truncated?";
    }
    throw bad_input(file.string(), static_cast<int>(line), "is no " + kind + ": " + wrong);
  } catch (const json::exception& error) {
    throw bad_input(file.string(), 0, "is no " + kind + ": " + words_of(error));
  }
}

std::string words_of(const std::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.starts_with('[') ? text.find("] ") : std::string::npos;
  return end == std::string::npos ? text : text.substr(end + 2);
}

const json& member(const json& object, std::string_view name) {
  static const json none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

std::optional<double> number_in(const json& value) {
  return value.is_string()   ? raw_number(value.get_ref<const std::string&>())
         : value.is_number() ? std::optional(value.get<double>())
                             : std::nullopt;
}

}  // namespace evbal
