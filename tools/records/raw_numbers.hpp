#pragma once

#include <optional>
#include <string_view>

namespace evbal {

/// The whole of `text` as a number as other people's programs write it: 0.000015 may be 1.5e-05. Nothing if it is none.
std::optional<double> raw_number(std::string_view text);

/// The same as a whole number, which may be written 2.0.
std::optional<long long> raw_integer(std::string_view text);

}  // namespace evbal
