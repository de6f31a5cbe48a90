#include "common/scratch_folder.hpp"

#include "common/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace evbal {

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) {
  std::string name = (parent / "evbal-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw run_failed(parent.string() + ": no folder can be made here: " + std::generic_category().message(errno));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace evbal
