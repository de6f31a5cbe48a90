#include "agents/hosting/process.hpp"

#include "agents/protocol/bytes.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/pin.hpp"

#include <CLI/CLI.hpp>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <thread>
#include <utility>

namespace evbal {
namespace {

std::mutex farewell_mutex;
std::function<void()> farewell;

void write_legs(const std::filesystem::path& file) {
  try {
    write_file(file, to_bytes(process_legs().taken()));
  } catch (const Error& error) {
    log_line(LogLevel::warn, error.what());
  }
}

/// Ends this process with its conductor, at any moment: what must last is written before it is said.
void end_with_conductor(const std::filesystem::path& legs) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // also reaches a process that is stopped
  std::thread([legs] {
    std::array<char, 64> ignored{};
    while (read(STDIN_FILENO, ignored.data(), ignored.size()) > 0) {
    }
    write_legs(legs);
    const std::lock_guard lock(farewell_mutex);
    if (farewell) {
      farewell();
    }
    _exit(EXIT_SUCCESS);
  }).detach();
}

void add_options(CLI::App& app, ProcessOptions& options) {
  app.add_option("--name", options.name, "Name of this process in the run")->required();
  app.add_option("--run", options.address.run, "Id of the run")->required();
  app.add_option("--domain", options.address.domain, "DDS domain of the run")->required();
  app.add_option("--participant", options.address.participant, "This process's number in the domain")->required();
  app.add_option("--participants", options.address.participants, "Processes of the run")->required();
  app.add_flag("--apart", options.address.apart, "Each agent is on a host of its own");
  app.add_option("--host", options.address.host, "IPv4 address of the host of this process");
  app.add_option("--launcher", options.address.launcher, "IPv4 address of the host of conductor and coordinator");
  app.add_option("--dds-profiles", options.address.profiles, "XML file of Fast DDS that the run asks for");
  app.add_option("--keys", options.address.keys, "By which this process proves that it belongs to the run");
  app.add_option("--regions-per-process", options.address.regions_per_process, "Regions that each agent hosts");
  app.add_option("--scenario", options.scenario, "The run's scenario.resolved.yaml")->required();
  app.add_option("--journal", options.journal, "What the process must know if it is started again")->required();
  app.add_option_function<int>(
         "--patience", [&](int seconds) { options.patience = std::chrono::seconds(seconds); },
         "Longest wait for what another process says, in seconds")
      ->required();
  app.add_option("--world", options.world, "What an agent is told of its regions");
  app.add_option("--first-region", options.first_region, "First of the regions that an agent hosts");
  app.add_option("--last-region", options.last_region, "Last of them");
  app.add_option_function<std::string>(
      "--log-level", [&](const std::string& word) { options.log_level = log_level_of(word); },
      "Log from which level on: debug, info, warn or error");
}

}  // namespace

std::vector<std::string> arguments(const ProcessOptions& options) {
  std::vector<std::string> words = {"--name",         options.name,
                                    "--run",          options.address.run,
                                    "--domain",       std::to_string(options.address.domain),
                                    "--participant",  std::to_string(options.address.participant),
                                    "--participants", std::to_string(options.address.participants),
                                    "--scenario",     options.scenario.string(),
                                    "--journal",      options.journal.string(),
                                    "--patience",     std::to_string(options.patience.count()),
                                    "--first-region", std::to_string(options.first_region),
                                    "--last-region",  std::to_string(options.last_region)};
  if (options.address.apart) {
    words.emplace_back("--apart");
  }
  const std::string local = BusAddress{}.host;
  if (options.address.host != local) {
    words.insert(words.end(), {"--host", options.address.host});
  }
  if (options.address.launcher != local) {
    words.insert(words.end(), {"--launcher", options.address.launcher});
  }
  if (!options.world.empty()) {
    words.insert(words.end(), {"--world", options.world.string()});
  }
  if (options.log_level != LogLevel::warn) {
    words.insert(words.end(), {"--log-level", log_levels()[static_cast<std::size_t>(options.log_level)]});
  }
  if (options.address.regions_per_process != 1) {
    words.insert(words.end(), {"--regions-per-process", std::to_string(options.address.regions_per_process)});
  }
  if (!options.address.keys.empty()) {
    words.insert(words.end(), {"--keys", options.address.keys.string()});
  }
  if (!options.address.profiles.empty()) {
    words.insert(words.end(), {"--dds-profiles", options.address.profiles.string()});
  }
  return words;
}

Legs& process_legs() {
  static Legs& only = *new Legs;  // in use until the process's very end
  return only;
}

std::filesystem::path legs_file(const std::filesystem::path& journal) {
  return journal.string() + ".legs";
}

std::vector<Leg> read_legs(const std::filesystem::path& file) {
  const std::string bytes = text_of_file(file);
  return bytes.empty() ? std::vector<Leg>{} : from_bytes<std::vector<Leg>>(bytes);
}

int run_process(int argc, char** argv, const std::string& description,
                const std::function<void(const ProcessOptions&, Participant&)>& body) {
  pin_arithmetic(argv);
  ProcessOptions options;
  CLI::App app(description);
  add_options(app, options);
  try {
    app.parse(argc, argv);
    begin_log(options.name, options.log_level);
    end_with_conductor(legs_file(options.journal));
    options.address.returns = std::filesystem::exists(options.journal);
    Participant participant(options.address, options.name);
    log_line(LogLevel::info, "is participant " + std::to_string(options.address.participant) + " of domain " +
                                 std::to_string(options.address.domain) +
                                 (options.address.returns ? ", started again" : ""));
    body(options, participant);
    return static_cast<int>(ExitStatus::ok);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? static_cast<int>(ExitStatus::ok) : static_cast<int>(ExitStatus::bad_input);
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.status());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(ExitStatus::run_failed);
  }
}

Farewell::Farewell(std::function<void()> say) {
  const std::lock_guard lock(farewell_mutex);
  farewell = std::move(say);
}

Farewell::~Farewell() {
  const std::lock_guard lock(farewell_mutex);  // waits for one that is being said, after which the process ends
  farewell = nullptr;
}

}  // namespace evbal
