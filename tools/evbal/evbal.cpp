#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "common/heap.hpp"
#include "common/pin.hpp"
#include "common/plain_text.hpp"
#include "common/version.hpp"
#include "tools/evbal/bound_command.hpp"
#include "tools/evbal/compare_command.hpp"
#include "tools/evbal/complete_command.hpp"
#include "tools/evbal/doctor_command.hpp"
#include "tools/evbal/fit_command.hpp"
#include "tools/evbal/ingest_command.hpp"
#include "tools/evbal/inject_command.hpp"
#include "tools/evbal/list_command.hpp"
#include "tools/evbal/replay_command.hpp"
#include "tools/evbal/report_command.hpp"
#include "tools/evbal/run_command.hpp"
#include "tools/evbal/search_command.hpp"
#include "tools/evbal/show_command.hpp"
#include "tools/evbal/slurm_task_command.hpp"
#include "tools/evbal/study_command.hpp"
#include "tools/evbal/sweep_command.hpp"
#include "tools/evbal/tune_command.hpp"
#include "tools/evbal/usage_error.hpp"
#include "tools/evbal/verify_command.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace {

/// What is typed ends up in records and pages, which hold text.
void check_words(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (const auto complaint = evbal::validate_line(argv[i]); !complaint.empty()) {
      throw evbal::bad_input("word " + std::to_string(i) + " of the command line " + complaint);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  evbal::pin_arithmetic(argv);
  evbal::keep_heap_pages();
  evbal::share_pack_folders();
  CLI::App app("Multi-agent MPC testbed with fault injection for electric taxi fleets", "evbal");
  app.set_version_flag("--version", "evbal " + evbal::version());
  app.require_subcommand(1);
  evbal::add_run_command(app);
  evbal::add_inject_command(app);
  evbal::add_show_command(app);
  evbal::add_list_command(app);
  evbal::add_sweep_command(app);
  evbal::add_tune_command(app);
  evbal::add_study_command(app);
  evbal::add_search_command(app);
  evbal::add_slurm_task_command(app);
  evbal::add_compare_command(app);
  evbal::add_bound_command(app);
  evbal::add_report_command(app);
  evbal::add_replay_command(app);
  evbal::add_ingest_command(app);
  evbal::add_fit_command(app);
  evbal::add_verify_command(app);
  evbal::add_doctor_command(app);
  evbal::add_complete_command(app);
  try {
    check_words(argc, argv);
    app.parse(argc, argv);
    return static_cast<int>(evbal::ExitStatus::ok);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "evbal: %s\n", evbal::usage_error(app, error).c_str());
    return static_cast<int>(evbal::ExitStatus::bad_input);
  } catch (const evbal::Error& error) {
    std::fprintf(stderr, "evbal: %s\n", error.what());
    return static_cast<int>(error.status());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "evbal: %s\n", error.what());
    return static_cast<int>(evbal::ExitStatus::run_failed);
  }
}
