#pragma once

#include "common/folder_lock.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// The directory that `evbal run` writes into. Held as long as the object lives, and no longer than the process does,
/// however it ends: so a run that goes on is told from one that broke off.
class OutFolder {
 public:
  /// Makes the directory, or takes an empty one, or one whose run broke off, of which everything is removed. Throws
  /// Error{bad_input} if it has anything else in it, or if a run goes on there.
  ///
  /// Of a day that is drawn many times, `draws` is a fingerprint of the draws; it is kept in the directory until
  /// complete(). Draws that broke off with the same fingerprint go on: nothing is removed. Those with another one are
  /// refused, whoever asks for the directory.
  explicit OutFolder(std::filesystem::path folder, const std::string& draws = "");

  /// The folder.
  const std::filesystem::path& path() const { return folder_; }

  /// Notes that all draws are played and their files written.
  void complete() const;

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
};

/// Whether a run was recorded there, broke off, and goes on no more.
bool broke_off(const std::filesystem::path& folder);

}  // namespace evbal
