#include "experiments/conductor/dds_players.hpp"

#include "agents/bus/ports.hpp"
#include "agents/bus/surroundings.hpp"
#include "agents/hosting/process.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "common/log.hpp"
#include "experiments/conductor/collected.hpp"
#include "experiments/conductor/machine_needs.hpp"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace evbal {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto glance = 20ms;    // between looks at the processes while nothing comes
constexpr auto reminder = 5min;  // between two times that the others hear of us while the day stands still

/// No two runs that could hear each other have the same.
std::string new_run_id() {
  return std::to_string(getpid()) + "-" + std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
}

std::string listed(const std::set<std::string>& names) {
  std::string text;
  for (const auto& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

struct DdsPlayers::Topics {
  explicit Topics(Participant& participant)
      : hello(participant),
        faults(participant),
        tick(participant),
        ticks(participant),
        reports(participant),
        plan(participant),
        departures(participant) {}

  Reader<Hello> hello;
  Reader<Faults> faults;
  Writer<Tick> tick;
  Reader<Tick> ticks;  ///< for what others write there
  Reader<std::vector<Report>> reports;
  Reader<Plan> plan;
  Reader<std::vector<Departures>> departures;

  /// What was refused on any topic since the last call.
  std::map<std::string, int> refused() {
    ticks.take();
    std::map<std::string, int> all;
    const auto gather = [&](auto&... readers) { (all.merge(readers.refused()), ...); };
    gather(hello, faults, ticks, reports, plan, departures);
    return all;
  }
};

DdsPlayers::DdsPlayers(const DdsRun& run) : run_(run), journals_(run.folder / "journals") {
  const auto begin = Clock::now();
  said_.tick = -1;
  for (const auto& need : machine_needs(run_.programs)) {
    if (!need.met) {
      throw run_failed(need.what + ": " + need.cure);
    }
  }
  if (const auto complaint = buffer_complaint(granted_socket_buffer(), run_.participants()); !complaint.empty()) {
    log_line(LogLevel::warn, complaint);
  }
  ignore_surroundings();
  if (run_.network) {
    network_.emplace(*run_.network, run_.agents(), run_.seed);
  }
  write_agent_worlds();
  domain_.emplace(run_.participants());
  while (!begins_in_domain()) {
    domain_.emplace(run_.participants(), domain_->domain() + 1);
  }
  ready_seconds_ = std::chrono::duration<double>(Clock::now() - begin).count();
  log_line(LogLevel::info, std::to_string(run_.participants()) + " processes in domain " +
                               std::to_string(domain_->domain()) + " ready after " + std::to_string(ready_seconds_) +
                               " s");
}

DdsPlayers::~DdsPlayers() = default;

bool DdsPlayers::begins_in_domain() {
  const std::string own = address_towards(addresses(run_.hosts));
  BusAddress address{.run = new_run_id(),
                     .domain = domain_->domain(),
                     .participant = BusAddress::conductor,
                     .participants = run_.participants(),
                     .apart = run_.network.has_value(),
                     .host = own,
                     .launcher = own,
                     .profiles = run_.profiles,
                     .regions_per_process = run_.regions_per_process};
  try {
    make_keys(address);
    address.keys = keys_of(BusAddress::conductor);
    supervisor_.emplace(run_.folder / "processes", connect_hosts());
    participant_.emplace(address, "conductor");
    topics_ = std::make_unique<Topics>(*participant_);
    start_processes(address);
    await_hellos();
    return true;
  } catch (const Error&) {
    const bool reached_hosts = supervisor_.has_value() && !run_.hosts.empty();
    supervisor_.reset();
    topics_.reset();
    participant_.reset();
    absent_.clear();
    if (domain_->complaint().empty() && (!reached_hosts || complaint_of_hosts().empty())) {
      throw;
    }
    return false;
  }
}

std::string DdsPlayers::host_of(int region) const {
  return name_of(BusAddress::first_agent + region / run_.regions_per_process);
}

template <class Message>
void DdsPlayers::await(const std::string& what, const Reader<Message>& reader, const std::function<bool()>& come,
                       const std::function<std::set<std::string>()>& missing, std::size_t but) {
  const auto deadline = Clock::now() + run_.patience;
  while (!come()) {
    const auto now = Clock::now();
    if (now > deadline) {
      const auto names = missing();
      throw run_failed("no " + what + " from " + listed(names) + " within " + std::to_string(run_.patience.count()) +
                       " s" + supervisor_->last_words(*names.begin()));
    }
    if (now - looked_ >= glance) {
      check_interrupt();
      look_after_processes();
      looked_ = now;
    }
    if (const std::size_t awaited = missing().size(); awaited > but) {
      reader.wait(glance, awaited - but);
    }
  }
}

/// Waits until no more than `but` have yet to say hello.
void DdsPlayers::await_hellos(std::size_t but) {
  const auto come = [&] {
    take_hellos();
    return absent_.size() <= but;
  };
  await(
      "hello", topics_->hello, come, [&] { return absent_; }, but);
}

void DdsPlayers::look_after_processes() {
  const std::vector<Death> deaths = supervisor_->revive();
  for (const auto& host : supervisor_->hosts_gone()) {
    log_line(LogLevel::warn, "host gone: " + host);
    incidents_.push_back({"host gone", host});
  }
  for (const auto& death : deaths) {
    log_line(LogLevel::info, death.process + ": " + death.how + ", started again");
    incidents_.push_back({"process ended", death.process + ": " + death.how});
    absent_.insert(death.process);
    deaths_[death.process] = Clock::now();
  }
  take_hellos();
}

void DdsPlayers::take_hellos() {
  for (const auto& [from, hello] : topics_->hello.take()) {
    if (hello.process_id == supervisor_->process_id(hello.name) && absent_.erase(hello.name) > 0 &&
        deaths_.contains(hello.name)) {
      const double seconds = std::chrono::duration<double>(Clock::now() - deaths_[hello.name]).count();
      incidents_.push_back({"process back", hello.name + ": process " + std::to_string(hello.process_id) + ", after " +
                                                std::to_string(seconds) + " s"});
    }
  }
}

void DdsPlayers::take_away(const Absences& away) {
  for (const auto& [name, how] : away_) {
    const auto now = away.find(name);
    if (now == away.end() || now->second != how) {
      bring_back(name, how);
    }
  }
  await_hellos();
  for (const auto& [name, how] : away) {
    const auto before = away_.find(name);
    if (before == away_.end() || before->second != how) {
      how == Absence::killed ? supervisor_->kill(name) : supervisor_->stop(name);
    }
  }
  away_ = away;
}

void DdsPlayers::bring_back(const std::string& name, Absence how) {
  if (how == Absence::killed) {
    supervisor_->start_again(name);
    absent_.insert(name);
  } else {
    supervisor_->go_on(name);
  }
}

std::vector<ProcessLegs> DdsPlayers::end() {
  supervisor_.reset();
  auto all = Players::end();
  for (int participant = BusAddress::coordinator; participant < run_.participants(); ++participant) {
    const std::string name = name_of(participant);
    all.push_back({name, read_legs(legs_file(journals_.path() / name))});
  }
  return all;
}

void DdsPlayers::say(const Tick& tick) {
  topics_->tick.write(tick);
  said_at_ = Clock::now();
}

void DdsPlayers::amended(int fault) {
  newest_fault_ = fault;
  say(said_);
}

void DdsPlayers::stand_still() {
  look_after_processes();
  if (Clock::now() - said_at_ > reminder) {
    say(said_);
  }
}

std::vector<PlayerProcess> DdsPlayers::processes() const {
  std::vector<PlayerProcess> all;
  for (int participant = BusAddress::coordinator; participant < run_.participants(); ++participant) {
    const std::string name = name_of(participant);
    all.push_back({name, process_id(name), !absent_.contains(name) && !away_.contains(name)});
  }
  return all;
}

void DdsPlayers::kill(const std::string& name) {
  for (const auto& process : processes()) {
    if (process.name == name && process.id != 0) {
      supervisor_->strike(name);
      return;
    }
  }
  Players::kill(name);
}

Faults DdsPlayers::faults(int tick) {
  std::optional<Faults> found;
  const auto knows_newest = [&](const Faults& said) {
    return newest_fault_ < 0 ||
           std::ranges::any_of(said.effects, [&](const Effect& effect) { return effect.fault == newest_fault_; });
  };
  const auto come = [&] {
    for (auto& [from, faults] : topics_->faults.take()) {
      if (faults.tick == tick && knows_newest(faults)) {
        found = std::move(faults);
      }
    }
    return found.has_value();
  };
  legs().time("faults", [&] {
    await("faults of tick " + std::to_string(tick), topics_->faults, come,
          [] { return std::set<std::string>{"faults"}; });
  });
  newest_fault_ = -1;
  return std::move(*found);
}

Exchange DdsPlayers::play(const Tick& tick) {
  const std::string of_tick = " of tick " + std::to_string(tick.tick);
  const auto hosts = [&](const std::set<int>& regions) {
    std::set<std::string> names;
    for (const int region : regions) {
      names.insert(host_of(region));
    }
    return names;
  };
  newest_ = std::max(newest_, tick.tick);
  said_ = tick;
  if (!run_.hosts.empty()) {
    told_.emplace_back(tick, std::nullopt);
  }
  legs().time("tick", [&] { say(tick); });
  Exchange exchange;
  if (tick.plan_due && !tick.unattended) {
    Collected<Report> reports(tick.tick, tick.due);
    const auto all_reported = [&] {
      reports.add(topics_->reports.take(), newest_);
      return reports.missing().empty();
    };
    legs().time("reports", [&] {
      await("report" + of_tick, topics_->reports, all_reported, [&] { return hosts(reports.missing()); });
    });
    exchange.reports = reports.by_region();
    const auto planned = [&] {
      for (auto& [from, plan] : topics_->plan.take()) {
        if (plan.tick == tick.tick) {
          exchange.plan = std::move(plan);
        }
      }
      return exchange.plan.has_value();
    };
    legs().time("plan", [&] {
      await("plan" + of_tick, topics_->plan, planned, [] { return std::set<std::string>{"coordinator"}; });
    });
    if (!told_.empty()) {
      told_.back().second = exchange.plan;
    }
  }
  Collected<Departures> departures(tick.tick, tick.due);
  const auto all_departed = [&] {
    departures.add(topics_->departures.take(), newest_);
    return departures.missing().empty();
  };
  legs().time("departures", [&] {
    await("departures" + of_tick, topics_->departures, all_departed, [&] { return hosts(departures.missing()); });
  });
  exchange.departures = departures.by_region();
  supervisor_->progress();
  for (const auto& [what, times] : topics_->refused()) {
    incidents_.push_back({"sample refused", std::to_string(times) + " of " + what});
  }
  for (const auto& who : participant_->strangers()) {
    incidents_.push_back({"stranger kept out", who});
  }
  exchange.incidents = std::exchange(incidents_, {});
  return exchange;
}

}  // namespace evbal
