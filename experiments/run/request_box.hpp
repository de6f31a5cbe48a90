#pragma once

#include "common/folder_lock.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

/// How a run that goes on is asked for something, from whatever process: by files in `requests/` of its directory.
namespace evbal {

/// Longest request, in bytes.
constexpr std::size_t longest_request = 16'384;

/// Where a run takes requests. The folder is made, and removed again with all that is in it; as long as the object
/// lives it is locked, so that a run that goes on is told from one that broke off.
class RequestBox {
 public:
  /// Of the run whose directory is `run`. Throws Error{run_failed} if the folder cannot be made.
  explicit RequestBox(const std::filesystem::path& run);
  ~RequestBox();
  RequestBox(const RequestBox&) = delete;
  RequestBox& operator=(const RequestBox&) = delete;

  /// Answers the requests that have come, the oldest first; does not wait. `answer` gives what is to be said, or throws
  /// Error for a no.
  void answer_all(const std::function<std::string(const std::string& request)>& answer);

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
};

/// Asks the run whose directory is `run`, or that one of several in it that is being played, and gives its answer.
/// Throws Error{bad_input} with the reason if it is a no, or if no run goes on there; Error{run_failed} if the run ends
/// meanwhile or does not answer within `patience`.
std::string ask_run(const std::filesystem::path& run, const std::string& request, std::chrono::seconds patience);

}  // namespace evbal
