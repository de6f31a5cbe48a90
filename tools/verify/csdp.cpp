#include "tools/verify/csdp.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/run_program.hpp"
#include "common/scratch_folder.hpp"
#include "common/spawn.hpp"

#include <sys/wait.h>

#include <chrono>
#include <fstream>
#include <sstream>

namespace evbal {
std::vector<double> solve_with_csdp(const std::string& problem) {
  constexpr int not_found = 127;
  constexpr auto at_most = std::chrono::minutes(2);
  const ScratchFolder folder;
  write_file(folder.path() / "problem.dat-s", problem);
  const ProgramResult result = run_program(
      {"/usr/bin/env", "--chdir=" + folder.path().string(), "OMP_NUM_THREADS=1", "csdp", "problem.dat-s", "solution"},
      at_most);
  if (WIFEXITED(result.status) && WEXITSTATUS(result.status) == not_found) {
    throw run_failed("csdp is not installed; Debian's package coinor-csdp has it");
  }
  if (result.status != 0) {
    throw run_failed("csdp " + ending(result.status) + ", and has no full accuracy");
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
