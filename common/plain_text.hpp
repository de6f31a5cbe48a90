#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// Position of the first byte that is no UTF-8 (RFC 3629), npos if there is none.
std::size_t find_invalid_utf8(std::string_view text);

/// Position of the first control character other than tab and line break, npos if there is none.
std::size_t find_control_character(std::string_view text);

/// The lines of a text, without their breaks.
std::vector<std::string> lines_of(const std::string& text);

/// What keeps `text` from being one line of text: bytes that are no UTF-8, a line break, another control character.
/// Empty if nothing does.
std::string validate_line(std::string_view text);

/// What keeps `text` from being the name of a file or folder in a folder of ours: what validate_line says, `/`, a dot
/// in front, no or more than 100 bytes. Empty if nothing does.
std::string validate_file_name(std::string_view text);

}  // namespace evbal
