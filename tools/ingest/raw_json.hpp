#pragma once

#include <nlohmann/json_fwd.hpp>

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace evbal {

/// Reads a JSON file of any program, plain or compressed. Messages call it `kind`, such as "GeoJSON", and what it must
/// be as a whole `whole`, such as "list". Throws Error{bad_input} with file and line, also if it is nested more than a
/// hundred levels deep.
nlohmann::json read_raw_json(const std::filesystem::path& file, const std::string& kind, const std::string& whole);

/// What an error of the JSON library says, without its number.
std::string words_of(const std::exception& error);

/// A member of an object; null if it has none, or if it is no object.
const nlohmann::json& member(const nlohmann::json& object, std::string_view name);

/// The number that stands there, also as text; nothing if there is none.
std::optional<double> number_in(const nlohmann::json& value);

}  // namespace evbal
