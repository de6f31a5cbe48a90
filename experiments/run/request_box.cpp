#include "experiments/run/request_box.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <system_error>
#include <thread>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto glance = 10ms;  // between looks for the answer
const char* const box_name = "requests";
const std::string yes = "yes\n";
const std::string no = "no\n";

/// Of the run whose directory it is, or of that one of several in it that is being played.
fs::path box_of(const fs::path& run) {
  std::error_code failed;
  for (fs::directory_iterator entry(run, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (fs::is_directory(entry->path() / box_name)) {
      return entry->path() / box_name;
    }
  }
  return run / box_name;
}

/// A name that sorts by time and that nobody else takes.
std::string new_name() {
  static std::atomic<int> count = 0;
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "%020lld-%d-%d",
                static_cast<long long>(std::chrono::system_clock::now().time_since_epoch().count()), getpid(), ++count);
  return name.data();
}

bool goes_on(const fs::path& box) {
  try {
    return fs::is_directory(box) && !FolderLock(box).held();
  } catch (const Error&) {  // it has been removed meanwhile
    return false;
  }
}

std::vector<fs::path> waiting(const fs::path& box) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator entry(box, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (entry->path().extension() == ".request") {
      files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string answer_to(const fs::path& file, const std::function<std::string(const std::string&)>& answer) {
  std::error_code failed;
  if (const auto size = fs::file_size(file, failed); failed || size > longest_request) {
    return no + "a request has at most " + std::to_string(longest_request) + " bytes";
  }
  try {
    return yes + answer(text_of_file(file));
  } catch (const Error& error) {
    if (error.status() != ExitStatus::bad_input) {
      throw;
    }
    return no + error.what();
  }
}

}  // namespace

RequestBox::RequestBox(const fs::path& run) : folder_(run / box_name) {
  std::error_code failed;
  fs::create_directory(folder_, failed);
  if (failed) {
    throw run_failed(folder_.string() + ": cannot be made: " + failed.message());
  }
  lock_.emplace(folder_);
  for (const auto deadline = Clock::now() + 2s; !lock_->held() && Clock::now() < deadline;) {
    std::this_thread::sleep_for(glance);  // somebody is looking whether a run goes on here
    lock_.emplace(folder_);
  }
}

RequestBox::~RequestBox() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void RequestBox::answer_all(const std::function<std::string(const std::string&)>& answer) {
  for (const fs::path& file : waiting(folder_)) {
    const std::string said = answer_to(file, answer);
    fs::remove(file);
    write_file(fs::path(file).replace_extension(".answer"), said);
  }
}

std::string ask_run(const fs::path& run, const std::string& request, std::chrono::seconds patience) {
  const fs::path box = box_of(run);
  if (!goes_on(box)) {
    throw bad_input(run.string() + ": no run goes on there; give the directory of a run while it plays its day");
  }
  const fs::path file = box / (new_name() + ".request");
  const fs::path answer = fs::path(file).replace_extension(".answer");
  write_file(file, request);
  for (const auto deadline = Clock::now() + patience; !fs::exists(answer); std::this_thread::sleep_for(glance)) {
    check_interrupt();
    if (!goes_on(box)) {
      throw run_failed(run.string() + ": the run ended before it answered");
    }
    if (Clock::now() > deadline) {
      std::error_code ignored;
      fs::remove(file, ignored);
      throw run_failed(run.string() + ": the run has not answered within " + std::to_string(patience.count()) + " s");
    }
  }
  const std::string said = text_of_file(answer);
  std::error_code ignored;
  fs::remove(answer, ignored);
  if (said.starts_with(no)) {
    throw bad_input(said.substr(no.size()));
  }
  return said.substr(std::min(said.size(), yes.size()));
}

}  // namespace evbal
