#include "tests/support/source_folder.hpp"

namespace evbal::test {

std::filesystem::path in_source(const std::string& path) {
  return std::filesystem::path(EVBAL_SOURCE_DIR) / path;
}

}  // namespace evbal::test
