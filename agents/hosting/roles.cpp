#include "agents/hosting/roles.hpp"

#include "agents/hosting/journal.hpp"
#include "agents/hosting/journal_entries.hpp"
#include "agents/protocol/origin.hpp"
#include "common/error.hpp"
#include "common/legs.hpp"
#include "common/log.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds nap = 1s;  // between looks at the clock while nothing comes

bool attended(const Tick& tick) {
  return !tick.unattended;
}

bool contains(const std::vector<std::int32_t>& regions, int region) {
  return std::find(regions.begin(), regions.end(), region) != regions.end();
}

/// What an agent says in a tick.
struct Answers {
  std::vector<Report> reports;
  std::vector<Departures> departures;
};

/// What each region says, in turn, with its origin.
template <class Message>
std::vector<Message> ask(const std::vector<HostedRegion>& regions,
                         const std::function<Message(const HostedRegion&)>& question) {
  std::vector<Message> answers;
  answers.reserve(regions.size());
  for (const auto& region : regions) {
    answers.push_back(with_origin([&] { return question(region); }));
  }
  return answers;
}

void begin(const std::vector<HostedRegion>& regions, const Tick& tick) {
  for (const auto& region : regions) {
    region.begin(tick);
  }
}

std::vector<Report> ask_reports(const std::vector<HostedRegion>& regions) {
  return ask<Report>(regions, [](const auto& region) { return region.report(); });
}

std::vector<Departures> ask_departures(const std::vector<HostedRegion>& regions, const AgentEntry& told) {
  const Plan* plan = told.plan.empty() ? nullptr : &told.plan.front();
  return ask<Departures>(regions, [&](const auto& region) { return region.live(plan); });
}

Answers live_again(const std::vector<HostedRegion>& regions, const AgentEntry& told) {
  Answers said;
  begin(regions, told.tick);
  if (told.tick.plan_due) {
    said.reports = ask_reports(regions);
  }
  if (!attended(told.tick)) {
    said.reports.clear();
  }
  said.departures = ask_departures(regions, told);
  return said;
}

/// Waits until `come`, by naps of at most `nap`, and tells whether it did within `patience`. A process that stood still
/// meanwhile has waited no longer for that.
bool comes(std::chrono::seconds patience, const std::function<bool()>& come, const std::function<void()>& sleep) {
  std::chrono::steady_clock::duration waited{};
  while (!come()) {
    if (waited >= patience) {
      return false;
    }
    const auto before = std::chrono::steady_clock::now();
    sleep();
    waited += std::min<std::chrono::steady_clock::duration>(std::chrono::steady_clock::now() - before, nap);
  }
  return true;
}

Error none(const std::string& what, std::chrono::seconds patience) {
  return run_failed("no " + what + " within " + std::to_string(patience.count()) + " s");
}

template <class Connected>
void say_hello(Participant& participant, const ProcessOptions& options, Connected connected) {
  Writer<Hello> hello(participant);
  const auto all_connected = [&] { return hello.readers() > 0 && connected(); };
  if (!comes(options.patience, all_connected, [&] { participant.wait_for_match(nap); })) {
    throw none("conductor on the bus", options.patience);
  }
  hello.write({.name = options.name, .process_id = getpid()});
  hello.wait_until_heard(nap);  // by then the conductor has found all other writers, too, and misses nothing they write
  log_line(LogLevel::info, "hears all whom it must hear");
}

/// Waits for the newest tick after `last` that `concerns` the process. Whatever the conductor says meanwhile, such as
/// the last tick again while the day stands still, shows that it is there: the wait begins anew. `said_again` is called
/// for a tick that is not after `last`.
template <class Concerns>
Tick next_tick(
    Reader<Tick>& ticks, int last, std::chrono::seconds patience, Concerns concerns,
    const std::function<void()>& said_again = [] {}) {
  std::optional<Tick> heard;
  const auto come = [&] {
    auto all = ticks.take();
    if (!all.empty()) {
      heard = std::move(all.back().message);
    }
    return heard.has_value();
  };
  const auto next = [&] {
    for (; comes(patience, come, [&] { ticks.wait(nap); }); heard.reset()) {
      if (heard->tick > last && concerns(*heard)) {
        return true;
      }
      if (heard->tick <= last) {
        said_again();
      }
    }
    return false;
  };
  if (!process_legs().time("wait for the tick", next)) {
    throw none("tick after " + std::to_string(last) + " from the conductor", patience);
  }
  if (is_logged(LogLevel::debug)) {
    log_line(LogLevel::debug, "tick " + std::to_string(heard->tick));
  }
  return std::move(*heard);
}

Plan plan_of(Reader<Plan>& plans, int tick, std::chrono::seconds patience) {
  std::optional<Plan> plan;
  const auto come = [&] {
    auto heard = plans.take();
    if (!heard.empty() && heard.back().message.tick == tick) {
      plan = std::move(heard.back().message);
    }
    return plan.has_value();
  };
  const bool came =
      process_legs().time("wait for the plan", [&] { return comes(patience, come, [&] { plans.wait(nap); }); });
  if (!came) {
    throw none("plan of tick " + std::to_string(tick) + " from the coordinator", patience);
  }
  return std::move(*plan);
}

/// The regions, in words: "region 3 and 17 more".
std::string some_of(const std::set<int>& regions) {
  const std::string more = regions.size() > 1 ? " and " + std::to_string(regions.size() - 1) + " more" : "";
  return "region " + std::to_string(*regions.begin()) + more;
}

std::vector<Report> reports_of(Reader<std::vector<Report>>& reader, const BusAddress& address, const Tick& tick,
                               std::chrono::seconds patience) {
  std::map<int, Report> found;
  std::set<int> missing(tick.due.begin(), tick.due.end());
  for (const int region : tick.unheard) {
    missing.erase(region);
  }
  const auto come = [&] {
    for (auto& batch : reader.take()) {
      for (auto& report : batch.message) {
        if (report.tick == tick.tick && missing.erase(report.region) > 0) {
          found.emplace(report.region, std::move(report));
        }
      }
    }
    return missing.empty();
  };
  const auto sleep = [&] {
    std::set<int> agents;
    for (const int region : missing) {
      agents.insert(address.agent_of(region));
    }
    reader.wait(nap, agents.size());
  };
  const bool came = process_legs().time("wait for the reports", [&] { return comes(patience, come, sleep); });
  if (!came) {
    throw none("report of tick " + std::to_string(tick.tick) + " from " + some_of(missing), patience);
  }
  std::vector<Report> reports;
  reports.reserve(found.size());
  for (auto& [region, report] : found) {
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace

void serve_agent(Participant& participant, const ProcessOptions& options, const std::vector<HostedRegion>& regions) {
  Journal journal(options.journal);
  Answers said;
  int last = -1;
  for (const auto& bytes : journal.entries()) {
    const auto told = from_bytes<AgentEntry>(bytes);
    said = live_again(regions, told);
    last = told.tick.tick;
  }
  const RegionRange own{options.first_region, options.last_region};
  Reader<Tick> ticks(participant, own);
  Reader<Plan> plans(participant, own);
  Writer<std::vector<Report>> report_writer(participant);
  Writer<std::vector<Departures>> departure_writer(participant);
  say_hello(participant, options,
            [&] { return ticks.writers() > 0 && report_writer.readers() > 0 && departure_writer.readers() > 0; });
  if (last >= 0) {
    if (!said.reports.empty()) {
      report_writer.write(said.reports);
    }
    departure_writer.write(said.departures);
  }
  const auto due = [&](const Tick& tick) { return contains(tick.due, own.first); };
  Legs& legs = process_legs();
  for (;;) {
    AgentEntry told{.tick = next_tick(ticks, last, options.patience, due), .plan = {}};
    last = told.tick.tick;
    legs.time("begin", [&] { begin(regions, told.tick); });
    if (told.tick.plan_due) {
      const auto reports = legs.time("report", [&] { return ask_reports(regions); });
      if (attended(told.tick)) {
        legs.time("send", [&] { report_writer.write(reports); });
      }
    }
    if (waits_for_plan(told.tick, own)) {
      told.plan.push_back(plan_of(plans, last, options.patience));
    }
    legs.time("journal", [&] { journal.append(to_bytes(told)); });
    const auto departures = legs.time("live", [&] { return ask_departures(regions, told); });
    legs.time("send", [&] { departure_writer.write(departures); });
  }
}

void serve_coordinator(Participant& participant, const ProcessOptions& options, const Planner& planner) {
  Journal journal(options.journal);
  CoordinatorEntry last;
  last.tick.tick = -1;
  for (const auto& bytes : journal.entries()) {
    last = from_bytes<CoordinatorEntry>(bytes);
    planner.recall(last.tick, last.reports, last.memory);
  }
  Reader<Tick> ticks(participant);
  Reader<std::vector<Report>> reports(participant);
  Writer<Plan> plans(participant);
  say_hello(participant, options, [&] { return ticks.writers() > 0 && plans.readers() > 0; });
  if (last.tick.tick >= 0) {
    plans.write(last.plan);
  }
  Legs& legs = process_legs();
  for (;;) {
    last.tick = next_tick(ticks, last.tick.tick, options.patience, attended);
    if (last.tick.plan_due) {
      last.reports = reports_of(reports, participant.address(), last.tick, options.patience);
      last.plan = legs.time("plan", [&] { return with_origin([&] { return planner.plan(last.tick, last.reports); }); });
      legs.time("journal", [&] {
        last.memory = planner.memory();
        journal.append(to_bytes(last));
      });
      legs.time("send", [&] { plans.write(last.plan); });
    }
  }
}

void serve_injector(Participant& participant, const ProcessOptions& options, const Schedules& schedules) {
  Reader<Tick> ticks(participant);
  Writer<Faults> writer(participant);
  say_hello(participant, options, [&] { return ticks.writers() > 0 && writer.readers() > 0; });
  const auto say = [&](int tick) {
    const Faults faults =
        process_legs().time("faults", [&] { return with_origin([&] { return schedules.faults(tick); }); });
    process_legs().time("send", [&] { writer.write(faults); });
  };
  for (int tick = -1;;) {
    say(tick + 1);
    const auto said_again = [&] {
      if (schedules.amended()) {
        say(tick + 1);
      }
    };
    tick = next_tick(ticks, tick, options.patience, attended, said_again).tick;
  }
}

}  // namespace evbal
