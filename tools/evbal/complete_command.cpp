#include "tools/evbal/complete_command.hpp"

#include "tools/evbal/completion.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace evbal {

void add_complete_command(CLI::App& app) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("complete", "Say what the last word of a command line may become");
  command->group("");  // not shown
  command->add_option("WORD", *words, "The words after evbal, the last of which is being typed");
  command->callback([&app, words] {
    for (const std::string& name : completions(app, *words)) {
      std::printf("%s\n", name.c_str());
    }
  });
}

}  // namespace evbal
