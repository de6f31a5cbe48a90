#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What a user's wrong word was meant to be.
namespace evbal {

/// "`a`, `b`": words that may be chosen, for messages.
std::string listed(const std::vector<std::string>& words);

/// The word in `words` closest to `word`, as " (did you mean `x`?)", empty if none is close.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& words);

/// What is wrong with `word` where one of `words` is expected, and what would be right; empty if it is one of them.
std::string validate_word(const std::string& word, const std::vector<std::string>& words);

}  // namespace evbal
