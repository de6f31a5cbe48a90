#include "tools/evbal/list_command.hpp"

#include "tools/evbal/console_table.hpp"
#include "tools/evbal/json_output.hpp"
#include "tools/evbal/listing.hpp"
#include "tools/evbal/usage_error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace evbal {
namespace {

std::string listing_table(const Listing& listing) {
  std::vector<std::vector<std::string>> table = {listing.columns};
  for (const auto& row : listing.rows) {
    table.emplace_back();
    for (const Cell& cell : row) {
      const auto* number = std::get_if<std::int64_t>(&cell);
      table.back().push_back(number != nullptr ? std::to_string(*number) : std::get<std::string>(cell));
    }
  }
  return aligned(table, listing.columns.size());
}

}  // namespace

void add_list_command(CLI::App& app) {
  struct Arguments {
    std::string kind;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("list", "List what is shipped and what scenarios may name");
  command->add_option("KIND", arguments->kind, "What is listed")->required()->check(one_of_words(listed_kinds()));
  command->add_flag("--json", arguments->json, "As JSON");
  command->callback([arguments] {
    const Listing listing = listing_of(arguments->kind);
    std::fputs((arguments->json ? listing_json(listing) : listing_table(listing)).c_str(), stdout);
  });
}

}  // namespace evbal
