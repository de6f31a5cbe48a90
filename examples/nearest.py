"""A controller that sends vacant cars to the nearest region where passengers wait for more cars than there are.

    evbal run experiments/scenarios/toy.yaml --coordinator "evbal-bridge python3 examples/nearest.py" --controller nearest
"""

import json
import sys


def balance(km, spare, missing, errand):
    """Whole cars from regions that can spare them to the nearest that miss some."""
    for _, i, j in sorted((km[i][j], i, j) for i in spare for j in missing if i != j):
        count = min(spare[i], missing[j])
        if count > 0:
            spare[i] -= count
            missing[j] -= count
            yield {"from": i, "to": j, "count": count, "errand": errand}


def plan(opening, reports):
    km = opening["city"]["km"]
    spare, missing, low, free = {}, {}, {}, {}
    for report in reports:  # a region without a report sends and gets nobody
        i = report["region"]
        coming = sum(cars["count"] for cars in report["bound"] if cars["errand"] == "rebalance")
        spare[i] = report["vacant"] - report["waiting"]
        missing[i] = -spare[i] - coming
        free[i] = report["points"] - report["plugged"] - report["low_battery"]
        low[i] = min(report["low_battery"], -free[i])
    yield from balance(km, spare, missing, "rebalance")
    yield from balance(km, low, free, "charge")
    for report in reports if opening["top_up"] else []:  # who is still to spare charges where it is
        i = report["region"]
        count = min(spare[i], report["chargeable"], free[i])
        if count > 0:
            yield {"from": i, "to": i, "count": count, "errand": "charge"}


opening = json.loads(sys.stdin.readline())
for line in sys.stdin:
    print(json.dumps({"moves": list(plan(opening, json.loads(line)["reports"]))}), flush=True)
