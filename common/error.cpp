#include "common/error.hpp"

namespace evbal {

Error bad_input(const std::string& message) {
  return {ExitStatus::bad_input, message};
}

Error bad_input(const std::string& file, int line, const std::string& message) {
  const std::string place = line > 0 ? file + ":" + std::to_string(line) : file;
  return {ExitStatus::bad_input, place + ": " + message};
}

Error run_failed(const std::string& message) {
  return {ExitStatus::run_failed, message};
}

}  // namespace evbal
