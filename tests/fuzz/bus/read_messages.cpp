// What libFuzzer calls: any bytes as a sample of each topic, as a reader of the bus takes it, and what is not refused
// as those take it whom it is meant for. Everything but an Error is found.

#include "agents/bus/cdr.hpp"
#include "agents/bus/hello.hpp"
#include "agents/protocol/message_check.hpp"
#include "agents/region/region_plant.hpp"
#include "agents/world/draws.hpp"
#include "agents/world/synthetic.hpp"
#include "common/error.hpp"
#include "coordinator/planning/announced.hpp"
#include "coordinator/planning/report_check.hpp"
#include "experiments/conductor/attendance.hpp"
#include "experiments/conductor/roads.hpp"

#include <cstdint>
#include <iterator>
#include <utility>

namespace evbal {
namespace {

constexpr int now = 6;  // tick

const World& world() {
  static const World small = [] {
    SyntheticCity synthetic = synthetic_city({});
    World world;
    world.city = std::move(synthetic.city);
    world.day = std::move(synthetic.days.front());
    return world;
  }();
  return small;
}

const MessageBounds& bounds() {
  static const MessageBounds all = bounds_of(world());
  return all;
}

template <class Message>
Message message(std::string_view bytes) {
  Sample<Message> sample = read_cdr<Message>(bytes);
  if (!sample.wrong.empty()) {
    throw run_failed(sample.wrong);
  }
  return sample.message;
}

void hear_hello(std::string_view bytes) {
  message<Hello>(bytes);
}

void hear_faults(std::string_view bytes) {
  auto said = message<Faults>(bytes);
  said.tick = now;
  refuse_garbage(said, bounds(), "the injector");
  attendance(said.effects, {1, world().city.size(), 2}, now, true);
}

void hear_tick(std::string_view bytes) {
  const auto said = message<Tick>(bytes);
  refuse_garbage(said, bounds(), "the conductor");
  announced_demand(said.effects, world().city.size());
  RegionPlant plant(region_worlds(world())[0]);
  plant.begin(said);
  plant.report();
  plant.live(nullptr);
}

void hear_plan(std::string_view bytes) {
  const auto said = message<Plan>(bytes);
  RegionPlant plant(region_worlds(world())[0]);
  Tick tick;
  tick.tick = said.tick == now ? now : 0;
  plant.begin(tick);
  plant.live(&said);
}

void hear_reports(std::string_view bytes) {
  const auto points = world().city.points();
  check_reports(message<std::vector<Report>>(bytes), now, 0,
                {world().city.fleet.vehicles, {points.begin(), points.end()}, world().clock});
}

void hear_departures(std::string_view bytes) {
  Roads roads(draw_fleet(world()));
  for (const auto& said : message<std::vector<Departures>>(bytes)) {
    refuse_garbage(said, bounds(), "region " + std::to_string(said.region));
    roads.take(said, world().clock.minute_of(said.tick + 1));
  }
}

}  // namespace
}  // namespace evbal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evbal;
  static constexpr void (*hearers[])(std::string_view){hear_hello, hear_faults,  hear_tick,
                                                       hear_plan,  hear_reports, hear_departures};
  if (size == 0) {
    return 0;
  }
  try {
    hearers[data[0] % std::size(hearers)]({reinterpret_cast<const char*>(data) + 1, size - 1});
  } catch (const Error&) {
  }
  return 0;
}
