#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// The shell's part of a page: all that stands in ```sh.
std::string commands_of(const std::string& page) {
  const std::string text = text_of(std::string(EVBAL_SOURCE_DIR "/docs/") + page);
  const std::string opening = "```sh\n";
  std::string commands;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    commands += text.substr(at, text.find("```", at) - at);
  }
  return commands;
}

class WorkedExample : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(WorkedExample, RunsAsItIsWritten) {
  const auto& [page, run] = GetParam();
  const Folder folder;
  const auto programs = std::filesystem::path(EVBAL_PROGRAM).parent_path().string();
  folder.write("example.sh", commands_of(page));
  const std::string command = "cd " + folder.path().string() + " && PATH=" + programs +
                              ":$PATH bash -eu -o pipefail example.sh >out.txt 2>err.txt";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(folder.path() / "err.txt");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / run / "report.html")) << text_of(folder.path() / "out.txt");
}

INSTANTIATE_TEST_SUITE_P(Pages, WorkedExample,
                         testing::Values(std::pair{"ingest.md", "runs/my-day"}, std::pair{"fit.md", "runs/morning"}));

}  // namespace
}  // namespace evbal
