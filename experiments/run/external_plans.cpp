#include "experiments/run/external_plans.hpp"

#include "common/error.hpp"
#include "coordinator/bridge/external_controller.hpp"
#include "experiments/conductor/last_words.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// What a child prints on stderr.
class Log {
 public:
  explicit Log(const fs::path& folder) : file_(open_in(folder)) {
    if (!file_) {
      throw run_failed("no file for what the coordinator prints can be made in " +
                       (folder.empty() ? fs::temp_directory_path() : folder).string());
    }
  }

  int number() const { return fileno(file_.get()); }

  /// For a message, also of a file that has no name.
  std::string last_words() const { return evbal::last_words("/proc/self/fd/" + std::to_string(number())); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  static File open_in(const fs::path& folder) {
    if (folder.empty()) {
      return File(std::tmpfile());
    }
    fs::create_directories(folder / "processes");
    return File(std::fopen((folder / "processes" / "coordinator.log").c_str(), "ae"));
  }

  File file_;
};

/// The controller, and where what it prints goes.
class Logged {
 public:
  Logged(const Scenario& scenario, const fs::path& folder) : log_(folder) {
    controller_ = told([&] {
      return start_controller(scenario.world, scenario.planning, resolved_yaml(scenario, scenario.planning.controller),
                              log_.number());
    });
  }

  Plan plan(const Tick& tick, const std::vector<Report>& reports) {
    return told([&] { return controller_->plan(tick, reports); });
  }

 private:
  /// What `work` gives, or its error with what the controller printed.
  template <class Work>
  auto told(const Work& work) -> decltype(work()) {
    try {
      return work();
    } catch (const Error& error) {
      throw Error(error.status(), error.what() + log_.last_words());
    }
  }

  Log log_;
  std::unique_ptr<ExternalController> controller_;
};

}  // namespace

InprocPlayers::Planner external_plans(const Scenario& scenario, const fs::path& folder) {
  const auto logged = std::make_shared<Logged>(scenario, folder);
  return [logged](const Tick& tick, const std::vector<Report>& reports) { return logged->plan(tick, reports); };
}

}  // namespace evbal
