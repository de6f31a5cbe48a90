#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace evbal {

/// The id of a zone without blanks around it.
std::string trimmed_id(std::string_view text);

/// The one form of a whole number that other programs write 132, 0132 or 132.0, here "132"; nothing if the text is no
/// whole number in digits.
std::optional<std::string> whole_number(std::string_view text, char decimal = '.');

}  // namespace evbal
