#include "common/new_folder.hpp"

#include "common/error.hpp"

namespace evbal {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& folder)
    : target_(fs::absolute(folder / "").lexically_normal().parent_path()), partial_(target_.string() + ".partial") {
  if (fs::exists(target_) && !(fs::is_directory(target_) && fs::is_empty(target_))) {
    throw bad_input(folder.string(), 0, "exists and is not an empty folder; give a new one");
  }
  std::error_code failed;
  fs::remove_all(partial_, failed);
  fs::create_directories(partial_, failed);
  if (failed) {
    throw run_failed(folder.string() + ": cannot be written: " + failed.message());
  }
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
}

void NewFolder::keep() {
  std::error_code failed;
  fs::rename(partial_, target_, failed);
  if (failed) {
    throw run_failed(target_.string() + ": cannot be written: " + failed.message());
  }
}

}  // namespace evbal
