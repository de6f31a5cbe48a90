#!/usr/bin/env python3
"""A controller that sends vacant cars to the nearest region where more passengers wait than there are cars.

    evbal run toy.yaml --transport inproc --coordinator "python3 nearest.py" --controller nearest

Parameters: `reach`, the km that vacant cars are sent at most, and `ahead`, how many times the demand since the last report
is expected to come before the next cars do.
"""

import json
import math
import sys


def balance(km, spare, missing, errand, reach=math.inf):
    """Whole cars from regions that can spare them to the nearest that miss some."""
    for far, i, j in sorted((km[i][j], i, j) for i in spare for j in missing if i != j):
        count = min(spare[i], missing[j])
        if count > 0 and far <= reach:
            spare[i] -= count
            missing[j] -= count
            yield {"from": i, "to": j, "count": count, "errand": errand}


def plan(opening, reports):
    km = opening["city"]["km"]
    reach = opening["parameters"].get("reach", math.inf)
    ahead = opening["parameters"].get("ahead", 0)
    spare, missing, low, free = {}, {}, {}, {}
    for report in reports:  # a region without a report sends and gets nobody
        i = report["region"]
        coming = sum(cars["count"] for cars in report["bound"] if cars["errand"] == "rebalance")
        spare[i] = report["vacant"] - report["waiting"] - math.floor(ahead * report["demand"] + 0.5)
        missing[i] = -spare[i] - coming
        free[i] = report["points"] - report["plugged"] - report["low_battery"]
        low[i] = min(report["low_battery"], -free[i])
    yield from balance(km, spare, missing, "rebalance", reach)
    yield from balance(km, low, free, "charge")
    for report in reports if opening["top_up"] else []:  # who is still to spare charges where it is
        i = report["region"]
        count = min(spare[i], report["chargeable"], free[i])
        if count > 0:
            yield {"from": i, "to": i, "count": count, "errand": "charge"}


opening = json.loads(sys.stdin.readline())
for line in sys.stdin:
    print(json.dumps({"moves": list(plan(opening, json.loads(line)["reports"]))}), flush=True)
