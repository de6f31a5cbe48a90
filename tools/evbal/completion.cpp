#include "tools/evbal/completion.hpp"

#include "agents/world/world.hpp"
#include "common/installation.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "experiments/study/design/trade.hpp"
#include "faults/schedule/fault_types.hpp"
#include "tools/evbal/command_names.hpp"
#include "tools/evbal/metric_meanings.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <sstream>

namespace evbal {
namespace {

using Names = std::vector<std::string>;

Names metric_words() {
  Names names;
  for (const MetricMeaning& metric : metric_meanings()) {
    names.push_back(metric.name);
  }
  return names;
}

/// The words of "{a,b}" in what help says of an option that takes one of a few.
Names words_in_braces(const std::string& help) {
  const auto begin = help.find('{');
  const auto end = help.find('}');
  Names words;
  if (begin != std::string::npos && end != std::string::npos) {
    std::istringstream list(help.substr(begin + 1, end - begin - 1));
    for (std::string word; std::getline(list, word, ',');) {
      words.push_back(word);
    }
  }
  return words;
}

/// The names that a value may have, whatever the command.
Names values_of(const CLI::Option& option) {
  static const std::map<std::string, std::function<Names()>> named = {
      {"CITY", pack_names},
      {"SCENARIO", [] { return shipped_names("scenarios"); }},
      {"SWEEP", [] { return shipped_names("studies"); }},
      {"FAULT", fault_type_names},
      {"BENCHMARK", [] { return shipped_names("benchmarks"); }},
      {"TUNING", [] { return shipped_names("studies"); }},
      {"--at", traded_metrics},
      {"--controller", controller_names},
      {"--faults", [] { return shipped_names("faults"); }},
      {"--metric", metric_words},
  };
  const auto known = named.find(option.get_name(option.get_positional()));
  return known != named.end() ? known->second() : words_in_braces(option.get_type_name());
}

/// Words as the program would get them: `--seed`, `=` and `7` are one.
Names joined_at_equals(const Names& words) {
  Names joined;
  bool open = false;
  for (const std::string& word : words) {
    if (!joined.empty() && (open || word == "=")) {
      joined.back() += word;
    } else {
      joined.push_back(word);
    }
    open = word == "=";
  }
  return joined;
}

const CLI::App* command_below(const CLI::App& command, const std::string& name) {
  const auto found = command.get_subcommands([&](const CLI::App* sub) { return sub->check_name(name); });
  return found.empty() ? nullptr : found.front();
}

/// Where the words before the last have led to.
struct Place {
  const CLI::App* command = nullptr;
  const CLI::Option* option = nullptr;  ///< whose values come next, as many as `values`
  int values = 0;
  std::size_t others = 0;  ///< words of the command so far that are neither options nor their values
};

void take(Place& place, const std::string& word) {
  if (place.values > 0) {
    --place.values;
  } else if (word.starts_with("-")) {
    place.option = place.command->get_option_no_throw(word);
    place.values = place.option != nullptr ? place.option->get_items_expected_min() : 0;
  } else if (const CLI::App* below = command_below(*place.command, word)) {
    place.command = below;
  } else {
    ++place.others;
  }
}

/// All that may stand at a place where `word` has been begun.
Names expected_at(const Place& place, const std::string& word) {
  if (place.values > 0) {
    return values_of(*place.option);
  }
  if (word.starts_with("-")) {
    return option_names(*place.command);
  }
  const auto positionals =
      place.command->get_options([](const CLI::Option* option) { return option->get_positional(); });
  return place.others < positionals.size() ? values_of(*positionals[place.others]) : command_names(*place.command);
}

}  // namespace

std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words) {
  Names before = joined_at_equals(words);
  std::string word = before.empty() ? "" : before.back();
  if (!before.empty()) {
    before.pop_back();
  }
  if (const auto equals = word.find('='); word.starts_with("-") && equals != std::string::npos) {
    before.push_back(word.substr(0, equals));
    word = word.substr(equals + 1);
  }
  Place place{.command = &app};
  for (const std::string& earlier : before) {
    take(place, earlier);
  }
  Names names = expected_at(place, word);
  std::erase_if(names, [&](const std::string& name) { return !name.starts_with(word); });
  return names;
}

}  // namespace evbal
