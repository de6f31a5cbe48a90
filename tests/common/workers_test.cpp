#include "common/workers.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>
#include <stdexcept>

namespace evbal {
namespace {

using Complaints = std::map<std::size_t, std::string>;

Complaints worked(const std::vector<std::size_t>& jobs, int at_a_time, const std::function<void(std::size_t)>& work) {
  Complaints complaints;
  work_through(jobs, at_a_time, work,
               [&](std::size_t job, const std::string& complaint) { complaints[job] = complaint; });
  return complaints;
}

TEST(Workers, DoEveryJobInAProcessOfItsOwn) {
  const Folder folder;
  const auto note = [&](std::size_t job) { folder.write(std::to_string(job), std::to_string(getpid())); };
  EXPECT_EQ(worked({4, 5, 6, 7}, 2, note), (Complaints{{4, ""}, {5, ""}, {6, ""}, {7, ""}}));
  std::set<std::string> ids = {std::to_string(getpid())};
  for (const char* job : {"4", "5", "6", "7"}) {
    ids.insert(text_of(folder.path() / job));
  }
  EXPECT_EQ(ids.size(), 5U);
  EXPECT_TRUE(worked({}, 2, note).empty());
}

TEST(Workers, TellWhatWentWrongAndGoOn) {
  const auto fail = [](std::size_t job) {
    if (job == 0) {
      throw std::runtime_error("no petrol");
    }
    if (job == 1) {
      raise(SIGKILL);
    }
  };
  const Complaints complaints = worked({0, 1, 2}, 1, fail);
  EXPECT_EQ(complaints.at(0), "no petrol");
  EXPECT_NE(complaints.at(1).find("Killed"), std::string::npos) << complaints.at(1);
  EXPECT_EQ(complaints.at(2), "");
}

TEST(Workers, AreEndedIfNobodyWantsThemAnyMore) {
  const Folder folder;
  const auto work = [&](std::size_t job) {
    if (job == 1) {
      sleep(60);
    }
  };
  const auto start = time(nullptr);
  EXPECT_THROW(work_through({1, 0}, 2, work, [](std::size_t, const std::string&) { throw run_failed("enough"); }),
               Error);
  EXPECT_LT(time(nullptr) - start, 50);
}

TEST(Workers, AreEndedWhenTheyTakeTooLong) {
  std::map<std::size_t, std::string> complaints;
  work_through(
      {0, 1}, 2, [](std::size_t job) { sleep(job == 0 ? 60 : 0); },
      [&](std::size_t job, const std::string& complaint) { complaints[job] = complaint; },
      std::chrono::milliseconds(1500));
  EXPECT_EQ(complaints.at(0), "took longer than 1.5 s, and was ended");
  EXPECT_EQ(complaints.at(1), "");
}

}  // namespace
}  // namespace evbal
