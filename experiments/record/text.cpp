#include "experiments/record/text.hpp"

#include "common/error.hpp"

#include <fstream>
#include <sstream>

namespace evbal {

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) {
    throw run_failed(file.string() + ": cannot be written");
  }
}

}  // namespace evbal
