#!/usr/bin/env python3
"""Holds days of evbal against the macroscopic simulator of RL4AMOD, in its money (docs/rl4amod.md).

    rl4amod.py profit RUN PRICES        what a run of evbal earned; PRICES is prices.csv of its city pack
    rl4amod.py nothing SCENARIO         what that simulator earns if no car is ever sent empty; SCENARIO is its file
"""

import argparse
import csv
import gzip
import json
import math
import random
import sqlite3
import statistics
from collections import defaultdict
from pathlib import Path


def profit(run, prices, step, minutes, cost):
    """Served passengers, revenue, cost of their trips and cost of empty trips in a run's first minutes."""
    with open(prices, newline="") as file:
        trip = {tuple(int(row[key]) for key in ("step", "origin", "destination")):
                (float(row["price"]), float(row["minutes"])) for row in csv.DictReader(file)}
    record = sqlite3.connect(f"file:{run}/run.sqlite?mode=ro", uri=True)
    served, revenue, driving = 0, 0.0, 0.0
    for origin, destination, appeared in record.execute(
            "SELECT region, destination, appeared FROM fates WHERE served = 1 AND appeared < ?", (minutes,)):
        price, takes = trip[appeared // step, origin, destination]
        served, revenue, driving = served + 1, revenue + price, driving + cost * takes
    (empty,) = record.execute("SELECT coalesce(sum(arrival_minute - minute), 0) FROM vehicles "
                              "WHERE errand = 'rebalance' AND minute < ?", (minutes,)).fetchone()
    return served, revenue, driving, cost * empty


def read_scenario(file, ratio, step):
    """By step and pair: trips, price, and driving time in steps. Regions, and cars in each of them at the start."""
    file = Path(file)
    with (gzip.open if file.suffix == ".gz" else open)(file, "rt") as text:
        data = json.load(text)
    first = 60 * data["totalAcc"][0]["hour"]
    sums = defaultdict(lambda: [0.0, 0.0, 0.0])
    for entry in data["demand"]:
        trips = ratio * entry["demand"]
        total = sums[(entry["time_stamp"] - first) // step, entry["origin"], entry["destination"]]
        for i, value in enumerate((1.0, entry["price"], entry["travel_time"] / step)):
            total[i] += trips * value
    regions = data["nlat"] * data["nlon"]
    pairs = defaultdict(list)
    for (at, origin, destination), (trips, price, time) in sorted(sums.items()):
        if trips > 0.0:
            pairs[at].append((origin, destination, trips, price / trips, max(1, round(time / trips))))
    return pairs, regions, data["totalAcc"][0]["acc"] // regions


def poisson(draw, mean):
    count, left = 0, draw.random()
    while left > math.exp(-mean):
        count, left = count + 1, left * draw.random()
    return count


def episode(draw, pairs, regions, cars, steps, step, cost):
    """Served passengers, their revenue and the cost of their trips, as that simulator counts them."""
    vacant = [cars] * regions
    arrivals = {}
    served, revenue, driving = 0, 0.0, 0.0
    for at in range(steps):
        for origin, destination, mean, price, time in sorted(pairs[at], key=lambda pair: -pair[3]):
            asked = poisson(draw, mean)
            taken = min(asked, vacant[origin])
            if taken == 0:
                continue
            vacant[origin] -= taken
            # Cars that leave later and arrive at the same time replace those before: so it is written there.
            arrivals[origin, destination, at + time] = taken
            served, revenue = served + taken, revenue + taken * price
            driving += taken * time * step * cost
        for (_, destination, when), taken in arrivals.items():
            vacant[destination] += taken if when == at else 0
    return served, revenue, driving


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    run = commands.add_parser("profit")
    run.add_argument("run", help="directory of a run that begins with the pack's day")
    run.add_argument("prices", help="prices.csv of the city pack")
    run.add_argument("--step", type=int, default=15, help="minutes of the pack's steps")
    run.add_argument("--minutes", type=int, default=80, help="so many minutes from the start count")
    nothing = commands.add_parser("nothing")
    nothing.add_argument("scenario", help="scenario_CITY.json, plain or .gz")
    nothing.add_argument("--ratio", type=float, default=9.0, help="demand_ratio")
    nothing.add_argument("--step", type=int, default=4, help="test_tstep, minutes")
    nothing.add_argument("--steps", type=int, default=20, help="of an episode")
    nothing.add_argument("--episodes", type=int, default=100)
    for command in (run, nothing):
        command.add_argument("--cost", type=float, default=0.5, help="beta, of a minute's drive")
    given = parser.parse_args()
    if given.command == "profit":
        served, revenue, driving, empty = profit(given.run, given.prices, given.step, given.minutes, given.cost)
        spread = 0.0
    else:
        scenario = read_scenario(given.scenario, given.ratio, given.step)
        draw = random.Random(1)
        all_episodes = [episode(draw, *scenario, given.steps, given.step, given.cost) for _ in range(given.episodes)]
        served, revenue, driving = (statistics.mean(values) for values in zip(*all_episodes))
        empty, spread = 0.0, statistics.stdev(one[1] - one[2] for one in all_episodes)
    print(f"served {served:.0f}, revenue {revenue:.0f}, their trips cost {driving:.0f}, empty trips cost {empty:.0f}")
    print(f"profit {revenue - driving - empty:.0f}" + (f", deviation of an episode {spread:.0f}" if spread else ""))


if __name__ == "__main__":
    main()
