#include "agents/bus/roles.hpp"

#include "agents/protocol/origin.hpp"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <optional>
#include <thread>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr auto nap = 1000ms;  // between looks at the clock while nothing comes
constexpr auto glance = 2ms;  // between looks at who is connected

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

template <class Connected>
void say_hello(Participant& participant, const std::string& name, Connected connected) {
  Writer<Hello> hello(participant);
  while (hello.readers() == 0 || !connected()) {
    std::this_thread::sleep_for(glance);
  }
  hello.write({.name = name, .process_id = getpid()});
}

/// Waits for the newest tick after `last`.
Tick next_tick(Reader<Tick>& ticks, int last) {
  for (;;) {
    auto come = ticks.take();
    if (!come.empty() && come.back().tick > last) {
      return std::move(come.back());
    }
    ticks.wait(nap);
  }
}

Plan plan_of(Reader<Plan>& plans, int tick) {
  for (;;) {
    auto come = plans.take();
    if (!come.empty() && come.back().tick == tick) {
      return std::move(come.back());
    }
    plans.wait(nap);
  }
}

std::vector<Report> reports_of(Reader<std::vector<Report>>& reader, const Tick& tick) {
  std::map<int, Report> found;
  const auto missing = [&](int region) { return !found.contains(region); };
  while (std::any_of(tick.due.begin(), tick.due.end(), missing)) {
    for (auto& batch : reader.take()) {
      for (auto& report : batch) {
        if (report.tick == tick.tick) {
          found.emplace(report.region, std::move(report));
        }
      }
    }
    if (std::any_of(tick.due.begin(), tick.due.end(), missing)) {
      reader.wait(nap);
    }
  }
  std::vector<Report> reports;
  reports.reserve(found.size());
  for (auto& [region, report] : found) {
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace

void serve_agent(Participant& participant, const std::string& name, const std::vector<HostedRegion>& regions) {
  Reader<Tick> ticks(participant);
  Reader<Plan> plans(participant);
  Writer<std::vector<Report>> report_writer(participant);
  Writer<std::vector<Departures>> departure_writer(participant);
  say_hello(participant, name, [&] {
    const int listeners = 2;  // the conductor records what the coordinator gets
    return ticks.writers() > 0 && plans.writers() > 0 && report_writer.readers() >= listeners &&
           departure_writer.readers() > 0;
  });
  for (int last = -1;;) {
    const Tick tick = next_tick(ticks, last);
    last = tick.tick;
    for (const auto& region : regions) {
      region.begin(tick);
    }
    std::optional<Plan> plan;
    if (tick.plan_due) {
      report_writer.write(ask<Report>(regions, [](const auto& region) { return region.report(); }));
      plan = plan_of(plans, tick.tick);
    }
    departure_writer.write(
        ask<Departures>(regions, [&](const auto& region) { return region.live(plan ? &*plan : nullptr); }));
  }
}

void serve_coordinator(Participant& participant, const std::string& name,
                       const std::function<Plan(const Tick&, const std::vector<Report>&)>& make_plan) {
  Reader<Tick> ticks(participant);
  Reader<std::vector<Report>> reports(participant);
  Writer<Plan> plans(participant);
  say_hello(participant, name, [&] { return ticks.writers() > 0 && plans.readers() > 0; });
  for (int last = -1;;) {
    const Tick tick = next_tick(ticks, last);
    last = tick.tick;
    if (tick.plan_due) {
      const auto due = reports_of(reports, tick);
      plans.write(with_origin([&] { return make_plan(tick, due); }));
    }
  }
}

void serve_injector(Participant& participant, const std::string& name,
                    const std::function<Faults(int tick)>& faults_of) {
  Reader<Tick> ticks(participant);
  Writer<Faults> writer(participant);
  say_hello(participant, name, [&] { return ticks.writers() > 0 && writer.readers() > 0; });
  for (int tick = -1;; tick = next_tick(ticks, tick).tick) {
    writer.write(with_origin([&] { return faults_of(tick + 1); }));
  }
}

}  // namespace evbal
