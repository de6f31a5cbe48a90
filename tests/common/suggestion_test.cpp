#include "common/suggestion.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(Suggestion, IsTheClosestWordIfOneIsClose) {
  EXPECT_EQ(did_you_mean("robst", {"ratio", "robust"}), " (did you mean `robust`?)");
  EXPECT_EQ(did_you_mean("simplex", {"ipopt", "cuts"}), "");
  EXPECT_EQ(did_you_mean("simplex", {}), "");
}

TEST(Suggestion, ComesWithWhatMayBeChosen) {
  EXPECT_EQ(validate_word("dds", {"dds", "inproc"}), "");
  EXPECT_EQ(validate_word("inprc", {"dds", "inproc"}),
            "`inprc` is not known (did you mean `inproc`?); choose one of `dds`, `inproc`");
}

}  // namespace
}  // namespace evbal
