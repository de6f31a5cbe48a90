#include "agents/hosting/journal.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

namespace fs = std::filesystem;

using Entries = std::vector<std::string>;

class JournalTest : public testing::Test {
 protected:
  Entries entries() const { return Journal(file_).entries(); }

  Folder folder_;
  fs::path file_ = folder_.path() / "journal";
};

TEST_F(JournalTest, GivesBackWhatWasAppended) {
  EXPECT_EQ(entries(), Entries{});
  const Entries written = {"one", "", std::string("t\0w\no\n", 6)};
  {
    Journal journal(file_);
    for (const auto& entry : written) {
      journal.append(entry);
    }
    EXPECT_EQ(journal.entries(), Entries{});
  }
  EXPECT_EQ(entries(), written);
  Journal(file_).append("three");
  EXPECT_EQ(entries().back(), "three");
}

TEST_F(JournalTest, CutsOffWhatWasBeingWritten) {
  Journal(file_).append("first\n");
  const auto whole = fs::file_size(file_);
  Journal(file_).append("second entry\n1 2\n");
  const std::string both = text_of(file_);
  for (std::size_t size = whole; size < both.size(); ++size) {
    folder_.write("journal", both.substr(0, size));
    EXPECT_EQ(entries(), Entries{"first\n"}) << size;
    EXPECT_EQ(fs::file_size(file_), whole);
    Journal(file_).append("again");
    EXPECT_EQ(entries(), (Entries{"first\n", "again"}));
  }
}

TEST_F(JournalTest, RefusesWhatWasNeverAppended) {
  Journal(file_).append("first");
  const std::size_t whole = fs::file_size(file_);
  Journal(file_).append("second");
  const std::string good = text_of(file_);
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int flipped : {1, 2, 16, 128}) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ flipped);
      folder_.write("journal", bad);
      const std::string where = at < whole ? "entry 1, at byte 0," : "entry 2, at byte " + std::to_string(whole) + ",";
      try {
        ADD_FAILURE() << "byte " << at << ": " << entries().size() << " entries are believed";
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::run_failed);
        EXPECT_EQ(std::string(error.what()), file_.string() + ": " + where + " is damaged");
      }
    }
  }
}

TEST_F(JournalTest, IsNotTakenForEmptyIfItCannotBeRead) {
  try {
    ADD_FAILURE() << Journal("/proc/self/mem").entries().size() << " entries";  // its first byte is nobody's
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "/proc/self/mem: cannot be read: Input/output error");
  }
}

TEST_F(JournalTest, SaysThatItCannotBeOpened) {
  EXPECT_THROW(Journal(folder_.path() / "nowhere" / "journal"), Error);
}

}  // namespace
}  // namespace evbal
