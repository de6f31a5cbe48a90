#include "experiments/study/executors/slurm.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/installation.hpp"
#include "common/interrupt.hpp"
#include "experiments/study/executors/play_into.hpp"
#include "experiments/study/executors/slurm_commands.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <thread>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::chrono::milliseconds glance = 500ms;  // between looks into the folder, which cost Slurm nothing
constexpr std::chrono::milliseconds first_question = 2s;
constexpr std::chrono::milliseconds rarest_question = 30s;
constexpr std::chrono::milliseconds end_of_cancelled = 5min;  // well above the 90 s after which Slurm gives a task up

/// When to ask Slurm, which serves many users: soon at first, then ever more rarely.
class Questions {
 public:
  /// Whether to ask now that this time has passed.
  bool due(std::chrono::milliseconds passed) {
    waited_ += passed;
    if (waited_ < interval_) {
      return false;
    }
    waited_ = 0ms;
    interval_ = std::min(2 * interval_, rarest_question);
    return true;
  }

 private:
  std::chrono::milliseconds waited_ = 0ms;
  std::chrono::milliseconds interval_ = first_question;
};

/// Throws Error{run_failed} if a task does not end. Where there is no Slurm, nothing is to be cancelled.
void cancel_all_in(const fs::path& folder, const Pause& pause) {
  auto arrays = arrays_in(folder).value_or(std::set<std::string>{});
  cancel(arrays);
  Questions questions;
  for (auto waited = 0ms; waited < end_of_cancelled && !arrays.empty(); waited += glance) {
    pause(glance);
    if (questions.due(glance)) {
      arrays = arrays_in(folder).value_or(arrays);
    }
  }
  if (!arrays.empty()) {
    throw run_failed("job array " + *arrays.begin() +
                     " was cancelled and goes on: ask again when `squeue --me` no longer lists it");
  }
}

/// The tasks in `folder` that have left a result.
std::set<std::string> results_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".sqlite") {
      names.insert(entry.path().stem());
    }
  }
  return names;
}

/// What a task that left no result has said.
std::string complaint_of(const fs::path& log) {
  const std::string said = text_of_file(log);
  return said.empty() ? "its task has ended without a result" : said;
}

/// Days that were submitted and of which nothing was heard yet. Cancelled when the object dies.
class Submitted {
 public:
  Submitted(const SlurmTasks& tasks, const Done& done)
      : tasks_(tasks), done_(done), folder_(fs::absolute(tasks.folder)) {
    fs::create_directories(folder_);
  }
  ~Submitted() { cancel({arrays_.begin(), arrays_.end()}); }
  Submitted(const Submitted&) = delete;
  Submitted& operator=(const Submitted&) = delete;

  /// As arrays side by side, of which each may be followed by others: so no more tasks run at a time than may.
  void submit_all(const std::vector<std::size_t>& days) {
    const std::size_t longest_array = tasks_.longest_array;
    const std::size_t arrays = (days.size() + longest_array - 1) / longest_array;
    const auto at_a_time = static_cast<std::size_t>(tasks_.at_a_time);
    const std::size_t side_by_side =
        at_a_time == 0 ? arrays : std::clamp<std::size_t>((at_a_time + longest_array - 1) / longest_array, 1, arrays);
    for (std::size_t i = 0; i < arrays; ++i) {
      const auto first = days.begin() + static_cast<std::ptrdiff_t>(i * longest_array);
      const auto last = days.begin() + static_cast<std::ptrdiff_t>(std::min(days.size(), (i + 1) * longest_array));
      submit_array({first, last}, static_cast<int>(at_a_time / side_by_side),
                   i < side_by_side ? "" : arrays_[i - side_by_side]);
    }
  }

  bool any() const { return !left_.empty(); }

  void take_results() {
    for (const auto& name : results_in(folder_)) {
      const auto task = left_.find(name);
      if (task != left_.end()) {
        const fs::path result = folder_ / (name + ".sqlite");
        tasks_.merge(result);
        for (const auto& file : {result, log_of(task->second), folder_ / (name + ".yaml")}) {
          fs::remove(file);
        }
        end(task, "");
      }
    }
  }

  /// Takes note of tasks that have ended without a result, if Slurm says so.
  void ask() {
    const auto going_on = arrays_in(folder_);
    if (!going_on) {
      return;
    }
    take_results();  // of tasks that ended before Slurm was asked
    for (auto next = left_.begin(); next != left_.end();) {
      const auto task = next++;
      if (!going_on->contains(task->second.array)) {
        end(task, complaint_of(log_of(task->second)));
      }
    }
    std::erase_if(arrays_, [&](const std::string& id) { return !going_on->contains(id); });
  }

 private:
  struct Task {
    std::size_t day = 0;
    std::string array;       ///< its id
    std::size_t number = 0;  ///< in the array, from 1
  };
  using Tasks = std::map<std::string, Task>;  ///< by name

  void submit_array(const std::vector<std::size_t>& days, int at_a_time, const std::string& after) {
    std::vector<std::string> names;
    std::string list;
    for (const std::size_t day : days) {
      const SlurmTask task = tasks_.task(day);
      write_file(folder_ / (task.name + ".yaml"), task.scenario);
      names.push_back(task.name);
      list += task.name + "\n";
      check_interrupt();
    }
    const fs::path list_file = folder_ / ("array-" + names.front() + ".txt");
    const fs::path script = folder_ / ("array-" + names.front() + ".sh");
    write_file(list_file, list);
    write_file(script, "#!/bin/sh\nname=$(sed -n \"${SLURM_ARRAY_TASK_ID}p\" " + shell_word(list_file.string()) +
                           ")\nexec " + shell_word((own_folder() / "evbal").string()) + " slurm-task \"$name.yaml\"\n");
    arrays_.push_back(submitted({script, folder_, days.size(), at_a_time, tasks_.task_limit, after}));
    for (std::size_t i = 0; i < days.size(); ++i) {
      left_[names[i]] = {days[i], arrays_.back(), i + 1};
    }
  }

  /// The id of the array, which Slurm has taken. What it took without saying its id is cancelled.
  std::string submitted(const JobArray& array) const {
    try {
      return submit(array);
    } catch (const Error&) {
      cancel(arrays_in(folder_).value_or(std::set<std::string>{}));
      throw;
    }
  }

  fs::path log_of(const Task& task) const {
    return folder_ / (task.array + "-" + std::to_string(task.number) + ".log");
  }

  void end(Tasks::iterator task, const std::string& complaint) {
    done_(task->second.day, complaint);
    left_.erase(task);
  }

  const SlurmTasks& tasks_;
  const Done& done_;
  fs::path folder_;
  Tasks left_;
  std::vector<std::string> arrays_;  ///< ids of those that are not over
};

}  // namespace

void pause_unless_interrupted(std::chrono::milliseconds length) {
  std::this_thread::sleep_for(length);
  check_interrupt();
}

void merge_left(const fs::path& folder, const std::function<void(const fs::path&)>& merge, const Pause& pause) {
  if (!fs::exists(folder)) {
    return;
  }
  cancel_all_in(folder, pause);
  for (const auto& name : results_in(folder)) {
    merge(folder / (name + ".sqlite"));
  }
  fs::remove_all(folder);
}

void work_on_slurm(const std::vector<std::size_t>& days, const SlurmTasks& tasks, const Done& done) {
  Submitted submitted(tasks, done);
  submitted.submit_all(days);
  Questions questions;
  while (submitted.any()) {
    tasks.pause(glance);
    submitted.take_results();
    if (submitted.any() && questions.due(glance)) {
      submitted.ask();
    }
  }
}

void play_slurm_task(const fs::path& scenario_file) {
  const Scenario scenario = read_scenario(scenario_file);
  const std::string key = scenario_file.stem().string();
  fs::path unfinished = scenario_file;
  unfinished.replace_extension(".unfinished");
  fs::remove(unfinished);
  begin_results(unfinished);
  play_into(unfinished, key, scenario);
  fs::rename(unfinished, fs::path(scenario_file).replace_extension(".sqlite"));
}

}  // namespace evbal
