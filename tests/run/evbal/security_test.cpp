// Days over a bus with security, by the command line.

#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

TEST(Security, LeavesTheDayOfSanFranciscoAsItIs) {
  const CommandLine line;
  std::ofstream(line.path() / "early.yaml") << "schema: 1\n"
                                               "city: san-francisco-54\n"
                                               "day: 2008-06-03\n"
                                               "clock: {start: \"05:00\", end: \"06:30\"}\n"
                                               "seed: 7\n"
                                               "controllers: [nominal]\n";
  ASSERT_EQ(line.evbal("run early.yaml --transport inproc --quiet --out alone").status, 0);
  const Ended secured = line.evbal("run early.yaml --set security=on --quiet --out secured");
  ASSERT_EQ(secured.status, 0) << secured.err;
  EXPECT_EQ(line.summary("secured", "digest"), line.summary("alone", "digest"));
  EXPECT_EQ(line.summary("secured", "agents"), "54");
  EXPECT_EQ(line.summary("secured", "security"), "\"on\"");
  EXPECT_EQ(line.summary("alone", "security"), "");
  EXPECT_FALSE(fs::exists(line.path() / "secured" / "keys"));
  EXPECT_EQ(line.evbal("replay secured --quiet").status, 0) << "without a bus";
}

TEST(Security, IsWithoutEffectWhereThereIsNoBus) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --out plain").status, 0);
  ASSERT_EQ(line.evbal("run morning.yaml --set security=on --quiet --out secured").status, 0);
  EXPECT_EQ(line.summary("secured", "digest"), line.summary("plain", "digest"));
  EXPECT_EQ(line.summary("secured", "security"), "");
}

TEST(Security, OfAnAuthorityOfOnesOwn) {
  const CommandLine line;
  const std::string run = "run morning.yaml --transport dds --set 'security={ca: my-ca}' --quiet --out ";
  const Ended none = line.evbal(run + "none");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("my-ca/ca.pem: cannot be read"), std::string::npos) << none.err;
  // As docs/security.md says.
  const Ended made = line.command(
      "mkdir -m 700 my-ca && openssl ecparam -name prime256v1 -genkey -noout -out my-ca/ca-key.pem && openssl req "
      "-x509 "
      "-new -sha256 -key my-ca/ca-key.pem -subj '/CN=my authority' -days 3650 -out my-ca/ca.pem");
  ASSERT_EQ(made.status, 0) << made.err;
  const Ended secured = line.evbal(run + "secured");
  ASSERT_EQ(secured.status, 0) << secured.err;
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --out alone").status, 0);
  EXPECT_EQ(line.summary("secured", "digest"), line.summary("alone", "digest"));
  ASSERT_EQ(line.command("openssl genrsa -out my-ca/ca-key.pem 2048").status, 0);
  const Ended other = line.evbal(run + "other");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("my-ca/ca-key.pem: is not the key of `ca.pem`"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace evbal
