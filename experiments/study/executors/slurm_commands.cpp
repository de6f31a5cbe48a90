#include "experiments/study/executors/slurm_commands.hpp"

#include "common/command.hpp"
#include "common/error.hpp"
#include "common/run_program.hpp"

#include <chrono>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto longest_answer = 2min;  // a controller with much to do makes its programs wait and try again

bool is_id(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// What a program of Slurm says on its standard output. Throws Error{run_failed} if it fails.
std::string answer(const Command& command) {
  const ProgramResult result = run_program(command, longest_answer);
  if (result.status != 0) {
    throw run_failed("`" + shown(command) + "` failed: " + result.errors);
  }
  return result.output;
}

}  // namespace

std::string submit(const JobArray& array) {
  const std::string limit = array.at_a_time > 0 ? "%" + std::to_string(array.at_a_time) : "";
  Command command = {"sbatch",
                     "--parsable",
                     "--job-name=evbal",
                     "--ntasks=1",
                     "--output=%A-%a.log",
                     "--array=1-" + std::to_string(array.tasks) + limit,
                     "--chdir=" + array.folder.string()};
  if (array.limit > 0s) {
    command.push_back("--time=" + std::to_string(array.limit.count() / 60) + ":" +
                      std::to_string(array.limit.count() % 60));
  }
  if (!array.after.empty()) {
    command.push_back("--dependency=afterany:" + array.after);
  }
  command.push_back(array.script.string());
  const std::string said = answer(command);
  std::string id = said.substr(0, said.find_first_of(";\n"));  // a cluster's name may follow
  if (!is_id(id)) {
    throw run_failed("`" + shown(command) + "` said `" + said + "`, which is no job id; see `squeue --me`");
  }
  return id;
}

std::optional<std::set<std::string>> arrays_in(const fs::path& folder) {
  try {
    std::set<std::string> ids;
    std::istringstream lines(answer({"squeue", "--me", "--noheader", "--format=%F %Z"}));
    for (std::string line; std::getline(lines, line);) {
      const auto space = line.find(' ');
      const std::string id = line.substr(0, space);
      if (space == std::string::npos || !is_id(id)) {
        return std::nullopt;
      }
      std::error_code no_such_place;
      if (fs::equivalent(line.substr(space + 1), folder, no_such_place)) {
        ids.insert(id);
      }
    }
    return ids;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void cancel(const std::set<std::string>& ids) {
  if (ids.empty()) {
    return;
  }
  Command command = {"scancel"};
  command.insert(command.end(), ids.begin(), ids.end());
  try {
    run_program(command, longest_answer);
  } catch (const Error&) {
    return;  // as if Slurm had not done it
  }
}

}  // namespace evbal
