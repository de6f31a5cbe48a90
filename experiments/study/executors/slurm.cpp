#include "experiments/study/executors/slurm.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"
#include "common/interrupt.hpp"
#include "common/text_of_file.hpp"
#include "experiments/record/text.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <thread>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::size_t longest_array = 1000;  // Slurm's MaxArraySize, unless a site sets another, is 1001
constexpr auto between_looks = 500ms;
constexpr int looks_at_cancelled = 600;  // well above the 90 s after which Slurm gives a task up

/// For a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? "'\\''" : std::string{c};
  }
  return result + "'";
}

/// What a command of Slurm says. Throws Error{run_failed} if it fails.
std::string said_by(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    throw run_failed("`" + command + "`: no process can be started");
  }
  std::string said;
  std::array<char, 4096> part{};
  for (std::size_t length = 0; (length = fread(part.data(), 1, part.size(), pipe)) > 0;) {
    said.append(part.data(), length);
  }
  if (pclose(pipe) != 0) {
    throw run_failed("`" + command + "` failed: " + said);
  }
  return said;
}

void cancel(const std::string& array) {
  [[maybe_unused]] const int status = std::system(("scancel " + quoted(array)).c_str());
}

/// A job array, cancelled if it is left before its end.
class JobArray {
 public:
  /// `names`: of tasks, in the order of their numbers.
  JobArray(const fs::path& folder, std::vector<std::string> names, int at_a_time) : names_(std::move(names)) {
    const fs::path list = folder / ("array-" + names_.front() + ".txt");
    const fs::path script = folder / ("array-" + names_.front() + ".sh");
    std::string text;
    for (const auto& name : names_) {
      text += name + "\n";
    }
    write_file(list, text);
    write_file(script, "#!/bin/sh\nname=$(sed -n \"${SLURM_ARRAY_TASK_ID}p\" " + quoted(list.string()) + ")\nexec " +
                           quoted((own_folder() / "evbal").string()) + " slurm-task \"$name.yaml\"\n");
    const std::string limit = at_a_time > 0 ? "%" + std::to_string(at_a_time) : "";
    id_ = said_by("sbatch --parsable --job-name=evbal --ntasks=1 --output=%A-%a.log --array=1-" +
                  std::to_string(names_.size()) + limit + " --chdir=" + quoted(folder.string()) + " " +
                  quoted(script.string()));
    id_ = id_.substr(0, id_.find_first_of(";\n"));  // a cluster's name may follow
  }
  ~JobArray() {
    if (!id_.empty()) {
      cancel(id_);
    }
  }
  JobArray(JobArray&& other) noexcept : names_(std::move(other.names_)), id_(std::exchange(other.id_, "")) {}
  JobArray& operator=(JobArray&&) = delete;
  JobArray(const JobArray&) = delete;
  JobArray& operator=(const JobArray&) = delete;

  const std::string& id() const { return id_; }
  const std::vector<std::string>& names() const { return names_; }
  void ended() { id_.clear(); }

 private:
  std::vector<std::string> names_;
  std::string id_;  ///< empty once it has ended
};

/// The arrays of which tasks in `folder` wait, run or are being ended; nothing if Slurm does not say now.
std::optional<std::set<std::string>> working_in(const fs::path& folder) {
  try {
    std::set<std::string> arrays;
    for (const auto& line : split(said_by("squeue --me --noheader --format='%F %Z'"), '\n')) {
      const auto space = line.find(' ');
      std::error_code no_such_place;
      if (fs::equivalent(line.substr(space + 1), folder, no_such_place)) {
        arrays.insert(line.substr(0, space));
      }
    }
    return arrays;
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Throws Error{run_failed} if a task does not end. Where there is no Slurm, nothing is to be cancelled.
void cancel_all_in(const fs::path& folder) {
  auto arrays = working_in(folder).value_or(std::set<std::string>{});
  std::ranges::for_each(arrays, cancel);
  for (int look = 0; look < looks_at_cancelled && !arrays.empty(); ++look) {
    std::this_thread::sleep_for(between_looks);
    check_interrupt();
    arrays = working_in(folder).value_or(arrays);
  }
  if (!arrays.empty()) {
    throw run_failed("job array " + *arrays.begin() +
                     " was cancelled and goes on: ask again when `squeue --me` no longer lists it");
  }
}

/// What a task that left no result has said.
std::string complaint_of(const fs::path& log) {
  const std::string said = fs::exists(log) ? text_of_file(log) : "";
  return said.empty() ? "its task has ended without a result" : said;
}

/// Days that were submitted and of which nothing was heard yet.
class Submitted {
 public:
  Submitted(const std::vector<std::size_t>& days, const SlurmTasks& tasks) : folder_(fs::absolute(tasks.folder)) {
    fs::create_directories(folder_);
    for (std::size_t first = 0; first < days.size(); first += longest_array) {
      std::vector<std::string> names;
      for (std::size_t i = first; i < std::min(days.size(), first + longest_array); ++i) {
        const SlurmTask task = tasks.task(days[i]);
        write_file(folder_ / (task.name + ".yaml"), task.scenario);
        left_[task.name] = days[i];
        names.push_back(task.name);
        check_interrupt();
      }
      arrays_.emplace_back(folder_, std::move(names), tasks.at_a_time);
    }
  }

  bool any() const { return !left_.empty(); }

  void look(const SlurmTasks& tasks, const Done& done) {
    const auto going_on = working_in(folder_);
    for (auto& array : arrays_) {
      const bool over = going_on && !going_on->contains(array.id());
      for (std::size_t i = 0; i < array.names().size() && !array.id().empty(); ++i) {
        take(array, i, over, tasks, done);
      }
      if (over) {
        array.ended();
      }
    }
  }

 private:
  void take(const JobArray& array, std::size_t i, bool over, const SlurmTasks& tasks, const Done& done) {
    const std::string& name = array.names()[i];
    const auto day = left_.find(name);
    const fs::path result = folder_ / (name + ".sqlite");
    if (day == left_.end() || !(over || fs::exists(result))) {
      return;
    }
    const fs::path log = folder_ / (array.id() + "-" + std::to_string(i + 1) + ".log");
    std::string complaint;
    if (fs::exists(result)) {
      tasks.merge(result);
      for (const auto& file : {result, log, folder_ / (name + ".yaml")}) {
        fs::remove(file);
      }
    } else {
      complaint = complaint_of(log);
    }
    done(day->second, complaint);
    left_.erase(day);
  }

  fs::path folder_;
  std::map<std::string, std::size_t> left_;  ///< positions by name
  std::vector<JobArray> arrays_;
};

}  // namespace

void merge_left(const fs::path& folder, const std::function<void(const fs::path&)>& merge) {
  if (!fs::exists(folder)) {
    return;
  }
  cancel_all_in(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".sqlite") {
      merge(entry.path());
    }
  }
  fs::remove_all(folder);
}

void work_on_slurm(const std::vector<std::size_t>& days, const SlurmTasks& tasks, const Done& done) {
  Submitted submitted(days, tasks);
  while (submitted.any()) {
    std::this_thread::sleep_for(between_looks);
    check_interrupt();
    submitted.look(tasks, done);
  }
}

void play_slurm_task(const fs::path& scenario_file) {
  const Scenario scenario = read_scenario(scenario_file);
  const std::string key = scenario_file.stem().string();
  fs::path unfinished = scenario_file;
  unfinished.replace_extension(".unfinished");
  fs::remove(unfinished);
  begin_results(unfinished);
  add_result(unfinished, key, scenario.world.clock, play_day(scenario));
  fs::rename(unfinished, fs::path(scenario_file).replace_extension(".sqlite"));
}

}  // namespace evbal
