// evbal-coordinator: makes the plans of a run.

#include "coordinator/serving/run_coordinator.hpp"

int main(int argc, char** argv) {
  return evbal::run_coordinator(argc, argv);
}
