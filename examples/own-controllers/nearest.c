/* The controller of ../nearest.py as a shared library: it makes the same plans.
 *
 *     cc -O2 -shared -fPIC -I/usr/include/evbal -o libnearest.so nearest.c -lm
 *     evbal run toy.yaml --transport inproc --coordinator ./libnearest.so --controller nearest
 */
#include <evbal_controller.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  double km;
  int32_t from, to;
} Pair;

typedef struct {
  int32_t regions, top_up;
  double reach; /* km that vacant cars are sent at most */
  double ahead; /* how many times the demand since the last report is expected to come */
  Pair* pairs;  /* of different regions, the nearest first */
} Nearest;

static int by_km(const void* one, const void* other) {
  const Pair *a = one, *b = other;
  if (a->km != b->km) {
    return a->km < b->km ? -1 : 1;
  }
  return a->from != b->from ? a->from - b->from : a->to - b->to;
}

static double parameter(const evbal_day* day, const char* name, double otherwise) {
  for (int32_t i = 0; i < day->parameter_count; ++i) {
    if (strcmp(day->parameters[i].name, name) == 0) {
      return day->parameters[i].number;
    }
  }
  return otherwise;
}

void* evbal_create(const evbal_day* day) {
  const int32_t n = day->regions;
  Nearest* me = malloc(sizeof *me);
  Pair* pairs = malloc(sizeof *pairs * (size_t)n * (size_t)n);
  if (me == NULL || pairs == NULL) {
    free(me);
    free(pairs);
    return NULL;
  }
  *me = (Nearest){n, day->top_up, parameter(day, "reach", INFINITY), parameter(day, "ahead", 0.0), pairs};
  for (int32_t i = 0; i < n; ++i) {
    for (int32_t j = 0; j < n; ++j) {
      pairs[i * n + j] = (Pair){day->km[i * n + j], i, j};
    }
  }
  qsort(pairs, (size_t)n * (size_t)n, sizeof *pairs, by_km);
  return me;
}

/* Whole cars from regions that can spare them to the nearest that miss some; gives the number of moves. */
static int32_t balance(const Nearest* me, int32_t* spare, int32_t* missing, double reach, int32_t errand,
                       evbal_move* moves) {
  int32_t made = 0;
  for (int32_t p = 0; p < me->regions * me->regions && me->pairs[p].km <= reach; ++p) {
    const int32_t i = me->pairs[p].from, j = me->pairs[p].to;
    const int32_t count = spare[i] < missing[j] ? spare[i] : missing[j];
    if (i != j && count > 0) {
      spare[i] -= count;
      missing[j] -= count;
      moves[made++] = (evbal_move){i, j, count, errand};
    }
  }
  return made;
}

int32_t evbal_plan(void* controller, const evbal_question* question, evbal_move* moves) {
  const Nearest* me = controller;
  const size_t n = (size_t)me->regions;
  int32_t* const counts = calloc(4 * n, sizeof *counts); /* a region without a report sends and gets nobody */
  if (counts == NULL) {
    return -1;
  }
  int32_t *spare = counts, *missing = counts + n, *low = counts + 2 * n, *unused = counts + 3 * n;
  for (int32_t r = 0; r < question->report_count; ++r) {
    const evbal_report* report = &question->reports[r];
    const int32_t i = report->region;
    int32_t coming = 0;
    for (int32_t c = 0; c < report->bound_count; ++c) {
      coming += report->bound[c].errand == EVBAL_REBALANCE ? report->bound[c].count : 0;
    }
    spare[i] = report->vacant - report->waiting - (int32_t)floor(me->ahead * report->demand + 0.5);
    missing[i] = -spare[i] - coming;
    unused[i] = report->points - report->plugged - report->low_battery;
    low[i] = report->low_battery < -unused[i] ? report->low_battery : -unused[i];
  }
  int32_t made = balance(me, spare, missing, me->reach, EVBAL_REBALANCE, moves);
  made += balance(me, low, unused, INFINITY, EVBAL_CHARGE, moves + made);
  for (int32_t r = 0; me->top_up && r < question->report_count; ++r) { /* who is still to spare charges where it is */
    const int32_t i = question->reports[r].region;
    int32_t count = question->reports[r].chargeable;
    count = count < spare[i] ? count : spare[i];
    count = count < unused[i] ? count : unused[i];
    if (count > 0) {
      moves[made++] = (evbal_move){i, i, count, EVBAL_CHARGE};
    }
  }
  free(counts);
  return made;
}

void evbal_destroy(void* controller) {
  Nearest* me = controller;
  free(me->pairs);
  free(me);
}
