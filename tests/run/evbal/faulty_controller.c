/* A controller that goes wrong as its parameter `fault` says. */
#include <evbal_controller.h>
#include <stdlib.h>
#include <string.h>

static const char* fault_of(const evbal_day* day) {
  return day->parameter_count == 1 ? day->parameters[0].text : "";
}

void* evbal_create(const evbal_day* day) {
  char* fault = calloc(32, 1);
  strncpy(fault, fault_of(day), 31);
  if (strcmp(fault, "create") == 0) {
    free(fault);
    return NULL;
  }
  return fault;
}

int32_t evbal_plan(void* controller, const evbal_question* question, evbal_move* moves) {
  const char* fault = controller;
  const evbal_report* report = question->reports;
  while (report->vacant < 2) {
    ++report;
  }
  const int32_t from = report->region, to = (from + 1) % 5;
  moves[0] = (evbal_move){from, to, 1, EVBAL_REBALANCE};
  moves[1] = moves[0];
  if (strcmp(fault, "refuse") == 0) {
    return -1;
  }
  if (strcmp(fault, "region") == 0) {
    moves[0].to = 5;
  }
  if (strcmp(fault, "errand") == 0) {
    moves[0].errand = EVBAL_PASSENGER;
  }
  if (strcmp(fault, "count") == 0) {
    moves[0].count = 1000000;
  }
  if (strcmp(fault, "crash") == 0) {
    abort();
  }
  return strcmp(fault, "twice") == 0 ? 2 : strcmp(fault, "room") == 0 ? 51 : 1;
}

void evbal_destroy(void* controller) {
  free(controller);
}
