"use strict";
// Faults: as requested and as seen to act, what they cost, and when the day was back to what it is without them.

// What the amounts of a type of fault count in a tick.
const amountUnits = [
  [/^demand[.]/, "passengers"], [/^charger[.](outage|block)/, "points"], [/^charger[.]derate/, "kWh not charged"],
  [/^fleet[.]breakdown/, "cars"], [/^fleet[.]drain/, "kWh lost"], [/^travel[.]/, "minutes"], [/^sensor[.]/, "said too much"],
  [/^process[.]/, "processes away"], [/^network[.]/, "samples not in time"], [/^solver[.]/, "plans that fell back"],
];
const unitOf = type => amountUnits.find(([pattern]) => pattern.test(type))?.[1] ?? "";

const costNames = {
  served: "Served passengers", lost: "Lost passengers", waiting: "Waiting passengers, mean",
  wait_minutes: "Passengers' wait, min", queue_minutes: "Queue for a charger, min", idle_km: "Idle distance, km",
  unfairness_demand: "Unfairness of the supply-demand ratio", unfairness_charging: "Unfairness of utilisation",
};

const between = (start, end) => clock(dayStart + start) + " – " + clock(dayStart + end);

function faultTable(run) {
  const text = words => element("td", "text", words);
  const head = name => element("th", "text", name);
  return table(["fault", head("type"), head("requested"), "min said", "regions", head("seen"), "min seen", "regions",
    head("most at a time"), "sum over ticks", "cars evicted"], run.faults.map(fault => [
    fault.name, text(fault.type), text(between(fault.start, fault.end)), String(fault.said_minutes),
    String(fault.regions.length), text(fault.seen ? between(...fault.seen) : "not at all"), String(fault.seen_minutes),
    String(fault.seen_regions), text(brief(fault.amount.largest) + " " + unitOf(fault.type)), brief(fault.amount.total),
    String(fault.evicted),
  ]));
}

const backAfter = minutes => minutes === null ? "not seen before the day ended" : minutes + " min";

function costTable(run) {
  const head = ["", "with", "without", "cost", "area, × hours", "back after",
    ...run.faults.map(fault => "after " + fault.name)];
  return table(head, run.costs.map(cost => [
    costNames[cost.metric] ?? cost.metric, brief(cost.with), brief(cost.without), brief(cost.cost), brief(cost.area),
    backAfter(cost.recovered), ...cost.by_fault.map(backAfter),
  ]));
}

function addFaults() {
  const card = (title, made) => element("div", "card wide narrow", element("h3", "", title), made);
  const cards = report.runs.filter(run => run.faults.length > 0).flatMap(run => [
    card("Faults, " + run.label, faultTable(run)), ...(run.costs ? [card("What they cost, " + run.label, costTable(run))] : []),
  ]);
  section("Faults", element("p", "note", "Requested by the schedule, said by the injector, seen by agents and " +
    "coordinator. Cost: the day less the same day without faults; area: between both curves. Back after the end of the " +
    "last fault, and of each: when the curves come together again and stay so for two hours or until the next fault."),
    ...cards);
}
