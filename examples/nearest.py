"""A controller that sends vacant cars to the nearest region where passengers wait for more cars than there are.

    evbal run experiments/scenarios/toy.yaml --coordinator "evbal-bridge python3 examples/nearest.py" --controller nearest
"""

import json
import sys


def balance(km, spare, missing, errand):
    """Whole cars from regions that can spare them to the nearest that miss some."""
    pairs = sorted((km[i][j], i, j) for i in range(len(km)) for j in range(len(km)) if i != j)
    for _, i, j in pairs:
        count = min(spare[i], missing[j])
        if count > 0:
            spare[i] -= count
            missing[j] -= count
            yield {"from": i, "to": j, "count": count, "errand": errand}


def plan(km, reports):
    coming = [sum(cars["count"] for cars in r["bound"] if cars["errand"] == "rebalance") for r in reports]
    vacant = [r["vacant"] - r["waiting"] for r in reports]
    free = [r["points"] - r["plugged"] - r["low_battery"] for r in reports]
    yield from balance(km, [max(0, v) for v in vacant], [max(0, -v - c) for v, c in zip(vacant, coming)], "rebalance")
    yield from balance(km, [min(r["low_battery"], max(0, -f)) for r, f in zip(reports, free)],
                       [max(0, f) for f in free], "charge")


km = json.loads(sys.stdin.readline())["city"]["km"]
for line in sys.stdin:
    print(json.dumps({"moves": list(plan(km, json.loads(line)["reports"]))}), flush=True)
