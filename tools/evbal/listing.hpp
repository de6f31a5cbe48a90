#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// What there is by name, for `evbal list`.
namespace evbal {

/// A text, or a whole number.
using Cell = std::variant<std::string, std::int64_t>;

/// Things of one kind.
struct Listing {
  std::vector<std::string> columns;     ///< what is told of each; the first is its name
  std::vector<std::vector<Cell>> rows;  ///< by thing, a cell a column
};

/// The kinds that there are: cities, scenarios and so on.
std::vector<std::string> listed_kinds();

/// All things of a kind, one of listed_kinds(). Throws Error{bad_input} if a pack cannot be read.
Listing listing_of(const std::string& kind);

/// The first sentence of the comment with which a YAML text begins, in one line.
std::string first_sentence(const std::string& yaml);

}  // namespace evbal
