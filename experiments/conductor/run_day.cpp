#include "experiments/conductor/run_day.hpp"

#include "common/interrupt.hpp"
#include "experiments/conductor/conductor.hpp"

namespace evbal {

void run_day(const World& world, Players& players, const std::function<void(const TickRecord&)>& observe,
             const std::function<void(int tick)>& before_tick) {
  Conductor conductor(world, players, observe);
  while (!conductor.over()) {
    check_interrupt();
    before_tick(conductor.next());
    const Tick& tick = conductor.begin_tick();
    conductor.end_tick(players.play(tick));
  }
  conductor.end_day();
}

}  // namespace evbal
