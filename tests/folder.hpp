#pragma once

#include "common/scratch_folder.hpp"

#include <fstream>
#include <sstream>
#include <string>

namespace evbal {

/// A new, empty folder of a test, removed at its end.
class Folder : public ScratchFolder {
 public:
  /// Writes a file in it, with the folders it needs, and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path() / name).parent_path());
    std::ofstream(path() / name, std::ios::binary) << text;
    return path() / name;
  }
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace evbal
