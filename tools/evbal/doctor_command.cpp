#include "tools/evbal/doctor_command.hpp"

#include "common/error.hpp"
#include "tools/evbal/diagnosis.hpp"
#include "tools/evbal/json_output.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace evbal {
namespace {

bool is_trouble(const Finding& finding) {
  return !finding.well.value_or(true);
}

const char* mark(const Finding& finding) {
  if (!finding.well) {
    return "    ";
  }
  return *finding.well ? "  ok" : "LACK";
}

void print(const Finding& finding) {
  std::printf("%s  %s%s\n", mark(finding), finding.what.c_str(),
              is_trouble(finding) ? (": " + finding.cure).c_str() : "");
}

void examine(bool clean, bool json) {
  const std::vector<Finding> findings = diagnose(clean);
  if (json) {
    std::fputs(findings_json(findings).c_str(), stdout);
  } else {
    std::for_each(findings.begin(), findings.end(), print);
  }
  if (const auto troubles = std::count_if(findings.begin(), findings.end(), is_trouble); troubles > 0) {
    throw run_failed(std::to_string(troubles) + (troubles == 1 ? " thing to mend" : " things to mend"));
  }
}

}  // namespace

void add_doctor_command(CLI::App& app) {
  struct Arguments {
    bool clean = false;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("doctor", "Say what this machine lacks and what runs left over that broke off");
  command->add_flag("--clean", arguments->clean, "Remove what they left over");
  command->add_flag("--json", arguments->json, "As JSON");
  command->callback([arguments] { examine(arguments->clean, arguments->json); });
}

}  // namespace evbal
