#include "common/version.hpp"

namespace evbal {

std::string version() {
  return EVBAL_VERSION;
}

}  // namespace evbal
