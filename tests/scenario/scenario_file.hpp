#pragma once

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

namespace evbal::test {

/// A folder of its own for the files of one test.
class ScenarioFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text, const std::string& name = "a.yaml") const {
    return folder_.write(name, text);
  }

  /// `place` is the file's name and line, or an option.
  void expect_refused(const std::function<void()>& reads, const std::string& place, const std::string& hint) const {
    try {
      reads();
      FAIL() << "was accepted, expected a refusal at " << place << " with " << hint;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(what.find(place + ": "), std::string::npos) << what;
      EXPECT_NE(what.find(hint), std::string::npos) << what;
    }
  }

 private:
  Folder folder_;
};

inline const std::string head = "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\n";

}  // namespace evbal::test
