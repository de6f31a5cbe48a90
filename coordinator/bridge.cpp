// evbal-bridge COMMAND...: takes part in a run as its coordinator; COMMAND makes the plans, in any language.

#include "coordinator/bridge/run_bridge.hpp"

int main(int argc, char** argv) {
  return evbal::run_bridge(argc, argv);
}
