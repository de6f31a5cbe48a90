#include "tools/evbal/listing.hpp"

#include "experiments/metrics/metrics.hpp"
#include "tools/evbal/metric_meanings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

std::vector<std::string> listed_names(const std::string& kind) {
  std::vector<std::string> names;
  for (const auto& row : listing_of(kind).rows) {
    names.push_back(std::get<std::string>(row.front()));
  }
  return names;
}

bool has_name(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Listing, HasWhatIsShipped) {
  EXPECT_TRUE(has_name(listed_names("cities"), "shenzhen-54"));
  EXPECT_TRUE(has_name(listed_names("scenarios"), "toy.yaml"));
  EXPECT_TRUE(has_name(listed_names("controllers"), "turnover"));
  EXPECT_TRUE(has_name(listed_names("faults"), "stadium.yaml"));
  EXPECT_TRUE(has_name(listed_names("studies"), "sweep-small.yaml"));
}

TEST(Listing, SaysSomethingOfEachThing) {
  for (const auto& kind : listed_kinds()) {
    const Listing listing = listing_of(kind);
    EXPECT_FALSE(listing.rows.empty()) << kind;
    for (const auto& row : listing.rows) {
      ASSERT_EQ(row.size(), listing.columns.size()) << kind;
      EXPECT_NE(row.back(), Cell{""}) << kind << ": " << std::get<std::string>(row.front());
    }
  }
}

TEST(Listing, HasEveryMetricOfADayInItsOrder) {
  EXPECT_EQ(listed_names("metrics"), metric_names());
}

TEST(Listing, TakesTheFirstSentenceOfAComment) {
  EXPECT_EQ(first_sentence("# One, two\n# and three. Then\n# more.\nschema: 1\n"), "One, two and three");
  EXPECT_EQ(first_sentence("# Version 0.2 of all\n#\n# more. x\n"), "Version 0.2 of all");
  EXPECT_EQ(first_sentence("# All.\nschema: 1\n"), "All");
  EXPECT_EQ(first_sentence("schema: 1\n"), "");
}

}  // namespace
}  // namespace evbal
