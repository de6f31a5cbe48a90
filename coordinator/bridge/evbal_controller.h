/* A controller as a shared library, which evbal loads into the process of a day: what such a library defines, in C. Any
 * language that makes C libraries will do. docs/your-own-controller.md says how it is named to evbal.
 *
 * Regions count from 0. Times are minutes since the day's start, but for `start` and `end`. Pointers that evbal hands
 * over are valid during the call only. Functions are called by one thread, in turn; several controllers may be alive at a
 * time. They print nothing on standard output. */
#ifndef EVBAL_CONTROLLER_H
#define EVBAL_CONTROLLER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A parameter of the scenario. */
typedef struct evbal_parameter {
  const char* name;
  const char* text; /* its value: "0.5", "near", "true" */
  double number;    /* the same as a number, 1 and 0 for true and false; NaN if it is none */
} evbal_parameter;

/* What is known of a day before its first plan. */
typedef struct evbal_day {
  const char* controller; /* name that the scenario gives */
  const char* city;       /* its name */
  const char* date;       /* "2024-01-11" */
  int32_t regions;        /* their number N */
  const int32_t* points;  /* N: charging points */
  const double* km;       /* N x N, from origin i to destination j at [i * N + j] */
  const double* minutes;  /* N x N likewise, of travel */
  int32_t start;          /* minutes after midnight */
  int32_t end;            /* minutes after midnight */
  int32_t tick;           /* minutes of a tick */
  int32_t step;           /* minutes of a step */
  int32_t plan_every;     /* minutes between plans */
  int32_t top_up;         /* 1 if vacant cars may be told to charge where they stand, else 0 */
  int32_t parameter_count;
  const evbal_parameter* parameters; /* by name */
} evbal_day;

/* Why a car is on the road. */
enum { EVBAL_PASSENGER = 0, EVBAL_REBALANCE = 1, EVBAL_CHARGE = 2 };

/* Cars on their way to a region. */
typedef struct evbal_bound {
  int32_t minute; /* when they arrive */
  int32_t errand; /* EVBAL_PASSENGER, ... */
  int32_t count;
} evbal_bound;

/* What a region reports. */
typedef struct evbal_report {
  int32_t region;
  int32_t vacant;      /* cars without passengers, with charge enough */
  int32_t low_battery; /* cars that wait for a charger */
  int32_t plugged;     /* cars at charging points */
  int32_t points;      /* that work */
  int32_t waiting;     /* passengers */
  int32_t demand;      /* passengers who appeared since the last report */
  int32_t completions; /* sessions that ended charged since the last report */
  int32_t chargeable;  /* vacant cars with less than 85 % of their battery */
  int32_t plugged_count;
  const int32_t* plugged_since; /* minute at which each plugged car began, ascending */
  int32_t reach_count;
  const int32_t* reach_m; /* metres that low-battery cars can still drive, of those that do not get to every region */
  int32_t bound_count;
  const evbal_bound* bound; /* cars on their way to here, by minute */
} evbal_report;

/* What evbal's own controllers are told of faults: demand that is announced, and faults of their solver. */
enum { EVBAL_DEMAND_SCALE = 0, EVBAL_DEMAND_ADD = 2, EVBAL_SOLVER_FAIL = 21, EVBAL_SOLVER_STARVE = 22 };

typedef struct evbal_effect {
  int32_t type;
  int32_t region;   /* of demand */
  double magnitude; /* factor on the passengers who appear, further passengers an hour, iterations of a solve */
} evbal_effect;

/* A plan is due. */
typedef struct evbal_question {
  int32_t tick;         /* from 0 */
  int32_t minute;       /* tick times minutes of a tick */
  int32_t report_count; /* reports may be missing, under faults */
  const evbal_report* reports;
  int32_t effect_count;
  const evbal_effect* effects;
} evbal_question;

/* An order to send vacant cars (EVBAL_REBALANCE) or low-battery cars (EVBAL_CHARGE) to another region or, where the day
 * has top_up, vacant cars to the chargers of their own (EVBAL_CHARGE, from == to). No region can send more than it
 * reports, and two moves may not have the same from, to and errand. */
typedef struct evbal_move {
  int32_t from;
  int32_t to;
  int32_t count; /* at least 1 */
  int32_t errand;
} evbal_move;

/* Makes a controller for a day, or gives NULL. */
void* evbal_create(const evbal_day* day);

/* Plans: writes moves, of which there is room for 2 N N, and gives their number, or -1 if it cannot. Called for each tick
 * at which a plan is due, in turn. */
int32_t evbal_plan(void* controller, const evbal_question* question, evbal_move* moves);

/* Frees the controller. */
void evbal_destroy(void* controller);

#ifdef __cplusplus
}
#endif

#endif
