#include "agents/bus/certificates.hpp"

#include "agents/bus/grants.hpp"
#include "agents/bus/participant.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace evbal {
namespace {

/// The complaint about one's own CA in this folder.
std::string complaint_about(const Folder& folder) {
  try {
    CertificateAuthority::read(folder.path());
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    return error.what();
  }
  return "";
}

TEST(SubjectHash, BeginsWithAOneAndTellsNamesApart) {
  const SubjectHash agent = hash_of({.run = "1-2", .process = "agent-0"});
  EXPECT_EQ(agent, hash_of({.run = "1-2", .process = "agent-0"}));
  EXPECT_NE(agent, hash_of({.run = "1-2", .process = "agent-1"}));
  EXPECT_NE(agent, hash_of({.run = "1-3", .process = "agent-0"})) << "of another run";
  EXPECT_GE(agent[0], 0x80);
}

TEST(CertificateAuthority, IssuesAnotherKeyEachTime) {
  const auto authority = CertificateAuthority::made("a");
  const Credentials first = authority.issue({.run = "1-2", .process = "agent-0"});
  const Credentials second = authority.issue({.run = "1-2", .process = "agent-0"});
  EXPECT_EQ(first.certificate.find("-----BEGIN CERTIFICATE-----"), 0U);
  EXPECT_EQ(first.key.find("-----BEGIN PRIVATE KEY-----"), 0U);
  EXPECT_NE(first.key, second.key);
}

TEST(CertificateAuthority, SignsTextsThatCanBeRead) {
  const std::string document = CertificateAuthority::made("a").sign("what is said\n");
  EXPECT_NE(document.find("multipart/signed"), std::string::npos);
  EXPECT_NE(document.find("what is said"), std::string::npos);
}

TEST(OwnCertificateAuthority, ThatCannotBeUsedIsRefusedWithTheReason) {
  const Folder folder;
  EXPECT_NE(complaint_about(folder).find("ca.pem: cannot be read"), std::string::npos) << complaint_about(folder);
  folder.write("ca.pem", "nothing\n");
  EXPECT_NE(complaint_about(folder).find("ca.pem: is no certificate"), std::string::npos) << complaint_about(folder);
  const auto authority = CertificateAuthority::made("a");
  const Credentials process = authority.issue({.run = "1-2", .process = "agent-0"});
  folder.write("ca.pem", process.certificate);
  EXPECT_NE(complaint_about(folder).find("is no certificate of a CA"), std::string::npos) << complaint_about(folder);
  folder.write("ca.pem", authority.certificate());
  EXPECT_NE(complaint_about(folder).find("ca-key.pem: cannot be read"), std::string::npos) << complaint_about(folder);
  folder.write("ca-key.pem", process.certificate);
  EXPECT_NE(complaint_about(folder).find("is no private key"), std::string::npos) << complaint_about(folder);
  folder.write("ca-key.pem", process.key);
  EXPECT_NE(complaint_about(folder).find("is not the key of `ca.pem`"), std::string::npos) << complaint_about(folder);
}

/// What a grant says between two words.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const auto begin = text.find(from);
  return begin == std::string::npos ? "" : text.substr(begin, text.find(to, begin) - begin);
}

TEST(Grant, LetsEachWriteWhereItHasASay) {
  const auto writes = [](int participant, const std::string& topic) {
    const std::string grant = grant_of({.run = "1-2", .process = name_of(participant)}, participant, 10);
    return between(grant, "<publish>", "</publish>").find("<topic>" + topic + "</topic>") != std::string::npos;
  };
  for (int participant = BusAddress::conductor; participant <= BusAddress::first_agent; ++participant) {
    EXPECT_EQ(writes(participant, "evbal/plan"), participant == BusAddress::coordinator);
    EXPECT_EQ(writes(participant, "evbal/tick"), participant == BusAddress::conductor);
    EXPECT_EQ(writes(participant, "evbal/faults"), participant == BusAddress::injector);
    EXPECT_EQ(writes(participant, "evbal/reports"), participant == BusAddress::first_agent);
    EXPECT_EQ(writes(participant, "evbal/departures"), participant == BusAddress::first_agent);
  }
  const std::string agent = grant_of({.run = "1-2", .process = "agent-0"}, BusAddress::first_agent, 10);
  EXPECT_NE(agent.find("<subject_name>CN=agent-0,O=1-2</subject_name>"), std::string::npos);
  EXPECT_EQ(between(agent, "<subscribe>", "</subscribe>").find("evbal/reports"), std::string::npos);
}

}  // namespace
}  // namespace evbal
