#include "tools/evbal/usage_error.hpp"

#include "common/suggestion.hpp"
#include "tools/evbal/command_names.hpp"

#include <CLI/CLI.hpp>

#include <optional>

namespace evbal {
namespace {

/// What is wrong with the first word that the command could not place, an option before anything else.
std::optional<std::string> misplaced_word(const CLI::App& command) {
  const std::vector<std::string> words = command.remaining();
  for (const std::string& word : words) {
    if (word.starts_with("-")) {
      const std::string name = word.substr(0, word.find('='));
      return "unknown option `" + name + "`" + did_you_mean(name, option_names(command));
    }
  }
  if (words.empty()) {
    return std::nullopt;
  }
  const std::vector<std::string> commands = command_names(command);
  return commands.empty() ? "`" + words.front() + "` is one word too many"
                          : "unknown command `" + words.front() + "`" + did_you_mean(words.front(), commands);
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string name = app.get_name();
  std::optional<std::string> misplaced = misplaced_word(app);
  while (!misplaced && !command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
    misplaced = misplaced_word(*command);
  }
  return misplaced.value_or(error.what()) + "; see `" + name + " --help`";
}

CLI::Validator one_of_words(const std::vector<std::string>& words) {
  std::string names;
  for (const std::string& word : words) {
    names += (names.empty() ? "{" : ",") + word;
  }
  return {[words](const std::string& word) { return validate_word(word, words); }, names + "}"};
}

}  // namespace evbal
