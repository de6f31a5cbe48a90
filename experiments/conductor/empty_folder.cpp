#include "experiments/conductor/empty_folder.hpp"

#include <system_error>
#include <utility>

namespace evbal {

EmptyFolder::EmptyFolder(std::filesystem::path path) : path_(std::move(path)) {
  std::filesystem::remove_all(path_);
  std::filesystem::create_directories(path_);
}

EmptyFolder::~EmptyFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace evbal
