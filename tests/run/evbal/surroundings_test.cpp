// What a user's shell and working directory hold for other programs on DDS: the day is the one without it.

#include "tests/held_ports.hpp"
#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// What evbal is started among.
struct Surroundings {
  std::string name;
  std::string profiles;     ///< an XML file of Fast DDS; empty: none
  std::string environment;  ///< what a shell has before the command; if nothing, the profiles lie where Fast DDS looks
  int first_port = 0;       ///< of those that another program has
  int ports = 0;            ///< that it has; a run asks for 9910 and those that follow first
};

// As the test runner names them.
void PrintTo(const Surroundings& surroundings, std::ostream* out) {
  *out << surroundings.name;
}

std::string profiles(const std::string& text) {
  return "<?xml version=\"1.0\"?><dds><profiles xmlns=\"http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles\">" +
         text + "</profiles></dds>";
}

/// What a participant is like by default.
std::string participant(const std::string& text) {
  return profiles("<participant profile_name=\"p\" is_default_profile=\"true\"><rtps>" + text +
                  "</rtps></participant>");
}

std::string discovery(const std::string& protocol) {
  return participant("<builtin><discovery_config><discoveryProtocol>" + protocol +
                     "</discoveryProtocol></discovery_config></builtin>");
}

/// What writers and readers are like by default.
std::string endpoints(const std::string& text) {
  return profiles("<data_writer profile_name=\"w\" is_default_profile=\"true\"><qos>" + text +
                  "</qos></data_writer><data_reader profile_name=\"r\" is_default_profile=\"true\"><qos>" + text +
                  "</qos></data_reader>");
}

std::vector<Surroundings> all_surroundings() {
  const std::string shared_memory = profiles(
      "<transport_descriptors><transport_descriptor><transport_id>s</transport_id><type>SHM</type></"
      "transport_descriptor>"
      "</transport_descriptors><participant profile_name=\"p\" is_default_profile=\"true\"><rtps><userTransports>"
      "<transport_id>s</transport_id></userTransports></rtps></participant>");
  const std::string slow = participant(
      "<throughputController><bytesPerPeriod>100</bytesPerPeriod><periodMillisecs>1000</periodMillisecs>"
      "</throughputController>");
  const std::string two = participant(
      "<allocation><total_participants><initial>1</initial><maximum>2</maximum><increment>1</increment>"
      "</total_participants></allocation>");
  return {
      {"DiscoveryClient", discovery("CLIENT"), ""},
      {"NoDiscovery", discovery("NONE"), ""},
      {"Partitions", endpoints("<partition><names><name>elsewhere</name></names></partition>"), ""},
      {"Deadline", endpoints("<deadline><period><nanosec>1000</nanosec></period></deadline>"), ""},
      {"SharedMemory", shared_memory, ""},
      {"BestEffort", endpoints("<reliability><kind>BEST_EFFORT</kind></reliability>"), ""},
      {"Throughput", slow, ""},
      {"TwoParticipants", two, ""},
      {"Lifespan", endpoints("<lifespan><duration><nanosec>1</nanosec></duration></lifespan>"), ""},
      {"Ownership", endpoints("<ownership><kind>EXCLUSIVE</kind></ownership>"), ""},
      {"ProfilesOfFastRtps", discovery("CLIENT"), "FASTRTPS_DEFAULT_PROFILES_FILE=profiles.xml"},
      {"ProfilesOfFastDds", shared_memory, "FASTDDS_DEFAULT_PROFILES_FILE=profiles.xml SKIP_DEFAULT_XML_FILE=0"},
      {"DiscoveryServer", "", "ROS_DISCOVERY_SERVER=127.0.0.1:11811"},
      {"SuperClient", "", "ROS_DISCOVERY_SERVER=127.0.0.1:11811 ROS_SUPER_CLIENT=TRUE"},
      {"EnvironmentFile", "", "FASTDDS_ENVIRONMENT_FILE=environment.json"},
      {"BuiltinTransports", "", "FASTDDS_BUILTIN_TRANSPORTS=SHM"},
      {"Statistics", "", "FASTDDS_STATISTICS=HISTORY_LATENCY_TOPIC\\;PHYSICAL_DATA_TOPIC"},
      {"RosDomain", "", "ROS_DOMAIN_ID=10"},
      {"OtherMiddleware", "", "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp CYCLONEDDS_URI=file:///none.xml"},
      {"RosDiscovery", "", "ROS_LOCALHOST_ONLY=1 ROS_AUTOMATIC_DISCOVERY_RANGE=OFF ROS_STATIC_PEERS=192.0.2.1"},
      {"Language", "", "localedef -i tr_TR -f UTF-8 ./tr_TR.UTF-8; LOCPATH=$PWD LANG=tr_TR.UTF-8"},
      {"Locale", "", "localedef -i de_DE -f UTF-8 ./de_DE.UTF-8; LOCPATH=$PWD LC_ALL=de_DE.UTF-8"},
      {"OmpThreads", "", "OMP_NUM_THREADS=8 OMP_DYNAMIC=TRUE OMP_PROC_BIND=TRUE"},
      {"BlasThreads", "", "OPENBLAS_NUM_THREADS=8 GOTO_NUM_THREADS=8 OPENBLAS_CORETYPE=Haswell"},
      {"PortsInUse", "", "", 9910, 4},
      {"ThreeDomainsInUse", "", "", 9900, 750},
  };
}

class InSurroundings : public testing::TestWithParam<Surroundings> {};

std::set<std::string> shared_memory_of_fast_dds() {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator("/dev/shm")) {
    const std::string name = entry.path().filename();
    if (name.find("fastrtps") != std::string::npos || name.find("fastdds") != std::string::npos) {
      names.insert(name);
    }
  }
  return names;
}

TEST_P(InSurroundings, TheDayIsTheSame) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out alone --quiet").status, 0);
  const auto before = shared_memory_of_fast_dds();
  const Surroundings& around = GetParam();
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(line.path() / name) << text; };
  write("environment.json", R"({"environment_variables": {"ROS_DISCOVERY_SERVER": "127.0.0.1:11811"}})");
  if (!around.environment.empty()) {
    write("profiles.xml", around.profiles);
  } else if (!around.profiles.empty()) {
    write("DEFAULT_FASTRTPS_PROFILES.xml", around.profiles);
    write("DEFAULT_FASTDDS_PROFILES.xml", around.profiles);
  }
  const HeldPorts held(around.first_port, around.ports);
  const Ended ended = line.evbal("run morning.yaml --transport dds --out among --quiet", around.environment);
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(line.summary("among", "digest"), line.summary("alone", "digest"));
  EXPECT_EQ(line.summary("among", "agents"), "5") << "over the bus";
  EXPECT_EQ(shared_memory_of_fast_dds(), before);
}

TEST(DdsProfiles, AreUsedIfAskedForAndNamedInTheRecord) {
  const CommandLine line;
  const fs::path file = line.path() / "profiles.xml";
  std::ofstream(file) << "<?xml version=\"1.0\"?><dds><log><use_default>FALSE</use_default><consumer>"
                         "<class>FileConsumer</class><property><name>filename</name><value>seen.log</value></property>"
                         "</consumer></log></dds>";
  const std::string command = "run morning.yaml --transport dds --quiet --out ";
  ASSERT_EQ(line.evbal(command + "without", "FASTRTPS_DEFAULT_PROFILES_FILE=profiles.xml").status, 0);
  EXPECT_FALSE(fs::exists(line.path() / "seen.log"));
  EXPECT_EQ(line.summary("without", "dds_profiles"), "");
  const Ended with = line.evbal(command + "with --dds-profiles profiles.xml");
  ASSERT_EQ(with.status, 0) << with.err;
  EXPECT_TRUE(fs::exists(line.path() / "seen.log"));
  EXPECT_EQ(line.summary("with", "dds_profiles"), '"' + file.string() + '"');
  EXPECT_EQ(line.summary("with", "digest"), line.summary("without", "digest"));
  EXPECT_EQ(line.evbal("replay with --quiet").status, 0) << "without a bus";
}

TEST(DdsProfiles, ThatCannotBeReadAreRefused) {
  const CommandLine line;
  std::ofstream(line.path() / "broken.xml") << "<dds><profiles>";
  for (const char* file : {"broken.xml", "none.xml"}) {
    const Ended refused = line.evbal(std::string("run morning.yaml --transport dds --out a --dds-profiles ") + file);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_NE(refused.err.find(file), std::string::npos) << refused.err;
  }
  const Ended no_bus = line.evbal("run morning.yaml --out b --dds-profiles broken.xml");
  EXPECT_EQ(no_bus.status, 2);
  EXPECT_NE(no_bus.err.find("choose `dds`"), std::string::npos) << no_bus.err;
}

INSTANTIATE_TEST_SUITE_P(OfOthers, InSurroundings, testing::ValuesIn(all_surroundings()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace evbal
