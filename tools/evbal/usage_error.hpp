#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
class Validator;
}  // namespace CLI

namespace evbal {

/// What is wrong with a command line that `app` could not read, in one line: a command or option that there is not
/// comes with the one that was meant, if one is close.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

/// Holds an argument of an option against the words that it may be.
CLI::Validator one_of_words(const std::vector<std::string>& words);

}  // namespace evbal
