#include "tools/verify/csdp.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/scratch_folder.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace evbal {
std::vector<double> solve_with_csdp(const std::string& problem) {
  constexpr int not_found = 127;
  const ScratchFolder folder;
  write_file(folder.path() / "problem.dat-s", problem);
  const std::string command =
      "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 csdp problem.dat-s solution >log 2>&1";
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe): the shell finds it
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_found) {
    throw run_failed("csdp is not installed; Debian's package coinor-csdp has it");
  }
  if (status != 0) {
    throw run_failed("csdp ended with status " + std::to_string(WEXITSTATUS(status)) + " and no full accuracy");
  }
  std::ifstream solution(folder.path() / "solution");
  std::string first;
  std::getline(solution, first);
  std::istringstream numbers(first);
  std::vector<double> values;
  for (double value = 0.0; numbers >> value;) {
    values.push_back(value);
  }
  return values;
}

}  // namespace evbal
