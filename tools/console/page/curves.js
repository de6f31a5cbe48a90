"use strict";
// What has been heard of the day, and its curves beside those of the same day without faults.

const heard = {day: null, ticks: [], twin: [], faults: [], pace: null, log: []};

function forget(day) {
  Object.assign(heard, {day, ticks: [], twin: [], faults: day.faults, pace: null, log: []});
  report.map = day.map;
}

const timeOf = tick => clock(heard.day.start + tick * heard.day.tick_minutes);
const last = () => heard.ticks.at(-1);

const curves = [
  {title: "Lost passengers", note: "Since the day began.", axis: "passengers", value: tick => tick.lost},
  {title: "Waiting passengers", note: "At the end of the tick.", axis: "passengers", value: tick => tick.waiting},
  {title: "Queue for a charger", note: "Low-battery cars that are not charging.", axis: "cars", value: tick => tick.queue},
  {title: "Vacant cars", note: "In all regions.", axis: "cars", value: tick => tick.vacant},
  {title: "Served passengers", note: "Since the day began.", axis: "passengers", value: tick => tick.served},
  {title: "Driven empty", note: "To rebalance and to charge, since the day began.", axis: "km", value: tick => tick.empty_km},
];

function curveOf({axis, value}) {
  const {start, tick_minutes, ticks} = heard.day;
  const points = all => all.map(tick => ({x: start + (tick.tick + 1) * tick_minutes, y: value(tick)}));
  const series = [{label: "this day", style: 0, bare: true, points: points(heard.ticks)}];
  if (heard.twin.length > 0) {
    series.push({label: "without faults", style: 0, thin: true, bare: true, points: points(heard.twin)});
  }
  return {x: {label: "time of day", clock: true, domain: [start, start + ticks * tick_minutes]}, y: {label: axis},
    windows: heard.faults.map(({name, start: from, end: to}) => ({name, from: start + from, to: start + to})), series};
}

const curveCards = () => curves.map(curve => figure(curve.title, curve.note, () => curveOf(curve)));

// The plan's cost by term, and where it came from.
function planTable() {
  const tick = heard.ticks.findLast(one => one.plan);
  if (!tick) {
    return [element("p", "", "No plan has been made yet.")];
  }
  const {plan} = tick;
  const words = timeOf(tick.tick) + ": " + plan.controller + (plan.engine ? " by " + plan.engine + ", " +
    plan.iterations + " iterations" : "") + ", " + plan.moves.length + " moves" +
    (plan.fallback === "none" ? "" : "; fell back to " + plan.fallback + ": " + plan.reason) +
    (plan.rejected > 0 ? "; " + plan.rejected + " reports not believed" : "") +
    (plan.flags > 0 ? "; " + plan.flags + " sensors lie" : "");
  const rows = plan.costs.map(([term, cost]) => [term, brief(cost)]);
  return [element("p", "", words),
    ...(rows.length > 0 ? [table(["term", "km"], [...rows, ["objective", brief(plan.objective)]])] : [])];
}

function underWayTable() {
  const [passenger, rebalance, charge] = last()?.under_way ?? [0, 0, 0];
  return table(["cars under way", ""], [["with a passenger", number(passenger)], ["to rebalance", number(rebalance)],
    ["to charge", number(charge)], ["of the fleet", number(heard.day.fleet)]]);
}

function faultsTable() {
  const acting = new Map((last()?.acting ?? []).map(one => [one.fault, one]));
  return table(["fault", element("th", "text", "type"), element("th", "text", "time"), "seen now"],
    heard.faults.map((fault, position) => [fault.name, element("td", "text", fault.type),
      element("td", "text", clock(heard.day.start + fault.start) + " – " + clock(heard.day.start + fault.end)),
      acting.has(position) ? brief(acting.get(position).amount) : ""]));
}

// The processes, with the newest tick of which each has spoken.
function processTable(kill) {
  const {day, pace, ticks} = heard;
  if (!pace || pace.processes.length === 0) {
    return table(["process", "id"], [["all of the day", String(day.process)]]);
  }
  const spoke = new Map([["faults", last()?.tick], ["coordinator", ticks.findLast(tick => tick.plan)?.tick]]);
  const wordOf = name => spoke.has(name) ? spoke.get(name) : last()?.tick;
  return table(["process", "id", "last word", ""], pace.processes.map(({name, id, there}) => {
    const button = element("button", "", "kill -9");
    button.disabled = id === 0;
    button.addEventListener("click", () => kill(name));
    const word = wordOf(name);
    return [name, there ? String(id) : element("td", "gone", "gone"), word === undefined ? "" : timeOf(word), button];
  }));
}
