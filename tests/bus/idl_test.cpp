// Holds agents/bus/evbal.idl, which is for the readers of other languages, and the structs of the protocol together.

#include "agents/bus/cdr.hpp"
#include "agents/bus/hello.hpp"
#include "agents/protocol/words.hpp"
#include "tests/bus/idl/generated_types.hpp"
#include "tests/support/random_message.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

namespace evbal {
namespace {

/// The bytes of a message as the bus writes them are read by the type that Fast DDS's generator made of the IDL, and
/// are what it writes then.
template <class Type, class Message>
void same_bytes() {
  const Sample<Message> sample{"a run", test::any_message<Message>()};
  const auto size = static_cast<std::uint32_t>(cdr_size(sample));
  test::Payload ours(size);
  write_cdr(sample, reinterpret_cast<char*>(ours.data));
  ours.length = size;
  Type type;
  typename Type::type generated;
  RC_ASSERT(test::read(type, ours, generated));
  RC_ASSERT(test::size_of(type, generated) == size);
  test::Payload theirs(size);
  std::memset(theirs.data, 0, size);  // it leaves what is between numbers as it is
  RC_ASSERT(test::write(type, generated, theirs));
  RC_ASSERT(theirs.length == size);
  RC_ASSERT(std::memcmp(ours.data, theirs.data, size) == 0);
}

RC_GTEST_PROP(Idl, HasTheBytesOfHello, ()) {
  same_bytes<wire::HelloPubSubType, Hello>();
}

RC_GTEST_PROP(Idl, HasTheBytesOfFaults, ()) {
  same_bytes<wire::FaultsPubSubType, Faults>();
}

RC_GTEST_PROP(Idl, HasTheBytesOfTick, ()) {
  same_bytes<wire::TickPubSubType, Tick>();
}

RC_GTEST_PROP(Idl, HasTheBytesOfReports, ()) {
  same_bytes<wire::ReportsPubSubType, std::vector<Report>>();
}

RC_GTEST_PROP(Idl, HasTheBytesOfPlan, ()) {
  same_bytes<wire::PlanPubSubType, Plan>();
}

RC_GTEST_PROP(Idl, HasTheBytesOfDepartures, ()) {
  same_bytes<wire::DeparturesPubSubType, std::vector<Departures>>();
}

/// What stands between the braces of each struct and enum of the IDL, without comments and in one line.
std::map<std::string, std::string> idl() {
  std::ifstream in(test::in_source("agents/bus/evbal.idl"));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text = std::regex_replace(text, std::regex("//[^\n]*"), "");
  text = std::regex_replace(text, std::regex("\\s+"), " ");
  std::map<std::string, std::string> bodies;
  const std::regex definition("(?:struct|enum) (\\w+) \\{ ([^}]*) \\}");
  for (std::sregex_iterator at(text.begin(), text.end(), definition); at != std::sregex_iterator(); ++at) {
    bodies[(*at)[1]] = (*at)[2];
  }
  return bodies;
}

/// How the IDL calls the type of a field.
struct IdlType {
  std::string operator()(std::int32_t /*of*/) const { return "long"; }
  std::string operator()(std::int64_t /*of*/) const { return "long long"; }
  std::string operator()(double /*of*/) const { return "double"; }
  std::string operator()(bool /*of*/) const { return "boolean"; }
  std::string operator()(const std::string& /*of*/) const { return "string"; }
  std::string operator()(Errand /*of*/) const { return "Errand"; }
  std::string operator()(EffectType /*of*/) const { return "EffectType"; }
  std::string operator()(OnStart /*of*/) const { return "OnStart"; }
  std::string operator()(ReportField /*of*/) const { return "ReportField"; }
  std::string operator()(ProcessRole /*of*/) const { return "ProcessRole"; }
  std::string operator()(NetworkTopic /*of*/) const { return "NetworkTopic"; }
  std::string operator()(FallbackLevel /*of*/) const { return "FallbackLevel"; }
  std::string operator()(const Origin& /*of*/) const { return "Origin"; }
  std::string operator()(const Vehicle& /*of*/) const { return "Vehicle"; }
  std::string operator()(const Provenance& /*of*/) const { return "Provenance"; }
  std::string operator()(const Arrival& /*of*/) const { return "Arrival"; }
  std::string operator()(const UnderWay& /*of*/) const { return "UnderWay"; }
  std::string operator()(const Effect& /*of*/) const { return "Effect"; }
  std::string operator()(const Move& /*of*/) const { return "Move"; }
  std::string operator()(const Rejection& /*of*/) const { return "Rejection"; }
  std::string operator()(const PlanCost& /*of*/) const { return "PlanCost"; }
  std::string operator()(SensorFaultKind /*of*/) const { return "SensorFaultKind"; }
  std::string operator()(const SensorFlag& /*of*/) const { return "SensorFlag"; }
  std::string operator()(const FieldInnovations& /*of*/) const { return "FieldInnovations"; }
  std::string operator()(const Departure& /*of*/) const { return "Departure"; }
  std::string operator()(const Fate& /*of*/) const { return "Fate"; }
  std::string operator()(const Observed& /*of*/) const { return "Observed"; }

  template <class Item>
  std::string operator()(const std::vector<Item>& /*of*/) const {
    return "sequence<" + (*this)(Item{}) + ">";
  }
};

template <class Message>
std::string declared() {
  std::string fields;
  const Message message{};
  for_each_field(message, [&](std::string_view name, const auto& field) {
    fields += (fields.empty() ? "" : " ") + IdlType{}(field) + " " + std::string(name) + ";";
  });
  return fields;
}

TEST(Idl, NamesTheFieldsOfEachStruct) {
  const auto idl_of = idl();
  EXPECT_EQ(idl_of.at("Origin"), declared<Origin>());
  EXPECT_EQ(idl_of.at("Vehicle"), declared<Vehicle>());
  EXPECT_EQ(idl_of.at("Arrival"), declared<Arrival>());
  EXPECT_EQ(idl_of.at("UnderWay"), declared<UnderWay>());
  EXPECT_EQ(idl_of.at("Effect"), declared<Effect>());
  EXPECT_EQ(idl_of.at("Report"), declared<Report>());
  EXPECT_EQ(idl_of.at("Move"), declared<Move>());
  EXPECT_EQ(idl_of.at("Rejection"), declared<Rejection>());
  EXPECT_EQ(idl_of.at("PlanCost"), declared<PlanCost>());
  EXPECT_EQ(idl_of.at("SensorFlag"), declared<SensorFlag>());
  EXPECT_EQ(idl_of.at("FieldInnovations"), declared<FieldInnovations>());
  EXPECT_EQ(idl_of.at("Provenance"), declared<Provenance>());
  EXPECT_EQ(idl_of.at("Departure"), declared<Departure>());
  EXPECT_EQ(idl_of.at("Fate"), declared<Fate>());
  EXPECT_EQ(idl_of.at("Observed"), declared<Observed>());
  EXPECT_EQ(idl_of.at("RegionDepartures"), declared<Departures>());
  EXPECT_EQ(idl_of.at("Hello"), "string run; " + declared<Hello>());
  EXPECT_EQ(idl_of.at("Faults"), "string run; " + declared<Faults>());
  EXPECT_EQ(idl_of.at("Tick"), "string run; " + declared<Tick>());
  EXPECT_EQ(idl_of.at("Plan"), "string run; " + declared<Plan>());
  EXPECT_EQ(idl_of.at("Reports"), "string run; sequence<Report> regions;");
  EXPECT_EQ(idl_of.at("Departures"), "string run; sequence<RegionDepartures> regions;");
}

template <class Enum>
std::string enumerated() {
  std::string names;
  for (const std::string_view name : enumerator_names<Enum>) {
    names.append(names.empty() ? "" : ", ").append(name);
  }
  return names;
}

// All enumerators of an IDL module stand in one scope, so that two are called otherwise there.
TEST(Idl, NamesTheEnumeratorsOfEachEnum) {
  auto idl_of = idl();
  const auto renamed = [&](const std::string& type, const std::string& there, const std::string& here) {
    return std::regex_replace(idl_of.at(type), std::regex("\\b" + there + "\\b"), here);
  };
  EXPECT_EQ(idl_of.at("Errand"), enumerated<Errand>());
  EXPECT_EQ(idl_of.at("EffectType"), enumerated<EffectType>());
  EXPECT_EQ(idl_of.at("OnStart"), enumerated<OnStart>());
  EXPECT_EQ(idl_of.at("ProcessRole"), enumerated<ProcessRole>());
  EXPECT_EQ(idl_of.at("FallbackLevel"), enumerated<FallbackLevel>());
  EXPECT_EQ(idl_of.at("SensorFaultKind"), enumerated<SensorFaultKind>());
  EXPECT_EQ(renamed("ReportField", "no_field", "none"), enumerated<ReportField>());
  EXPECT_EQ(renamed("NetworkTopic", "all_topics", "all"), enumerated<NetworkTopic>());
}

}  // namespace
}  // namespace evbal
