#include "experiments/run/run_folder.hpp"

#include "common/error.hpp"
#include "common/files.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto patience = 2s;  // a killed launcher's worker holds the directory until it has been killed, too

/// How the mark of draws that are not all played begins; their fingerprint follows.
const std::string draws_mark = "draws ";

/// Whether a run may have written the file.
bool is_of_run(const fs::path& file) {
  static const std::set<std::string> names = {
      "INCOMPLETE",  "distribution.csv", "faults.csv",         "faults.yaml",         "regions.csv",
      "report.html", "run.sqlite",       "runs.csv",           "runs.sqlite",         "steps.csv",
      "worst.yaml",  "summary.json",     "run.sqlite-journal", "runs.sqlite-journal", "scenario.resolved.yaml"};
  const std::string folder = file.parent_path().filename();
  const bool unfinished = file.extension() == ".partial";  // a NewFile of a process that was killed
  return unfinished || names.contains(file.filename()) || folder == "processes" || folder == "journals" ||
         folder == "requests" || file.parent_path().parent_path().filename() == "keys";
}

/// Whether the directory has the mark of a record that is not complete, and nothing that no run writes. Not one that
/// cannot be read.
bool has_broken_record(const fs::path& folder) {
  bool marked = false;
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    marked = marked || entry->path().filename().string().starts_with("INCOMPLETE");
    const bool is_folder = entry->is_directory(failed);
    if (!failed && !is_folder && !is_of_run(entry->path())) {
      return false;
    }
  }
  return marked && !failed;
}

/// Removes what was being written when a process was killed.
void remove_partial_files(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (entry->path().extension() == ".partial") {
      std::error_code kept;
      fs::remove(entry->path(), kept);
    }
  }
}

}  // namespace

OutFolder::OutFolder(fs::path folder, const std::string& draws) : folder_(std::move(folder)) {
  const auto refuse = [&](const std::string& why) { return bad_input("--out: " + folder_.string() + " " + why); };
  const auto check = [&](const std::error_code& failed, const std::string& what) {
    if (failed) {
      throw refuse("cannot be " + what + " (" + failed.message() + "); give another one");
    }
  };
  std::error_code failed;
  if (fs::exists(folder_, failed) && !fs::is_directory(folder_, failed)) {
    throw refuse("is there and not an empty directory; give a new one");
  }
  fs::create_directories(folder_, failed);
  check(failed, "made");
  lock_.emplace(folder_);
  for (auto waited = 0ms; !lock_->held() && waited < patience; waited += 10ms) {
    std::this_thread::sleep_for(10ms);
    lock_.emplace(folder_);
  }
  if (!lock_->held()) {
    throw refuse("is being written by another run; give a new one");
  }
  const std::string own_mark = draws_mark + draws + "\n";
  const std::string mark = text_of_file(folder_ / "INCOMPLETE");
  if (mark == own_mark) {
    remove_partial_files(folder_);
    return;
  }
  if (mark.starts_with(draws_mark)) {
    throw refuse(
        "holds draws of another scenario, city pack, model or version of evbal, which broke off; give a new one, or to "
        "go on the command that began them");
  }
  const bool empty = fs::is_empty(folder_, failed);
  check(failed, "read");
  if (!empty && !has_broken_record(folder_)) {
    throw refuse("is there and not an empty directory; give a new one");
  }
  for (fs::directory_iterator entry(folder_, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code kept;
    fs::remove_all(entry->path(), kept);
    check(kept, "emptied");
  }
  check(failed, "read");
  if (!draws.empty()) {
    write_file(folder_ / "INCOMPLETE", own_mark);
  }
}

void OutFolder::complete() const {
  fs::remove(folder_ / "INCOMPLETE");
}

bool broke_off(const fs::path& folder) {
  try {
    return FolderLock(folder).held() && has_broken_record(folder);
  } catch (const Error&) {  // a folder that we may not look into is none of our runs
    return false;
  }
}

}  // namespace evbal
