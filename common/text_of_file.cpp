#include "common/text_of_file.hpp"

#include <fstream>
#include <sstream>

namespace evbal {

std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace evbal
