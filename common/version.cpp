#include "common/version.hpp"

#include "common/digest.hpp"

namespace evbal {

std::string version() {
  return EVBAL_VERSION;
}

std::string this_program() {
  static const std::string program =
      "evbal " + version() + " (build " + file_digest("/proc/self/exe").substr(0, 8) + ")";
  return program;
}

}  // namespace evbal
