#include "tools/evbal/report_content.hpp"

#include "tests/folder.hpp"
#include "tests/record/small_day.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(ReportContent, SaysWhatItLeavesOutAndWhy) {
  const Folder folder;
  RunHeader header = small_header();
  header.resolved = "schema: 1\ncity: gone\n";
  RunRecord record(folder.path() / "run", header);
  for (const auto& tick : small_day()) {
    record.add(tick);
  }
  mark_complete(record.finish({}).folder);
  const std::string page = report_page(content_on({read_run(folder.path() / "run")}));
  EXPECT_NE(page.find("Left out: map, forecasts and thresholds. "), std::string::npos);
  EXPECT_NE(page.find("city `gone` is neither a shipped pack nor a folder"), std::string::npos);
}

}  // namespace
}  // namespace evbal
