#include "experiments/study/store/sweep_folder.hpp"

#include "common/error.hpp"

#include <utility>

namespace evbal {

namespace fs = std::filesystem;

SweepFolder::SweepFolder(fs::path folder, const std::string& file) : folder_(std::move(folder)), file_(folder_ / file) {
  const bool is_ours = fs::exists(folder_ / sweep_file_name) || fs::exists(folder_ / tuning_file_name) ||
                       fs::exists(folder_ / search_file_name);
  if (fs::exists(folder_) && !is_ours && !(fs::is_directory(folder_) && fs::is_empty(folder_))) {
    throw bad_input("--out: " + folder_.string() + " is there and holds no sweep; give a new one");
  }
  fs::create_directories(folder_);
  lock_.emplace(folder_);
  if (!lock_->held()) {
    throw bad_input(folder_.string() + ": another evbal is at work there; wait for it or give another --out");
  }
}

}  // namespace evbal
