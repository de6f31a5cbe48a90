"use strict";
// Breaking the day by hand: what is asked of the run, and the form that asks for faults.

const token = new URLSearchParams(location.search).get("token");
const chosen = new Set();  // regions

function answer(kind, words) {
  const place = document.getElementById("answer");
  place.className = kind;
  place.textContent = words;
}

// Asks the run, which answers before its next tick; its answer is shown, and whether it was a yes.
async function ask(request) {
  try {
    const response = await fetch("/ask?token=" + token, {method: "POST", headers: {"Content-Type": "application/json"},
      body: JSON.stringify(request, null, 1)});
    const words = await response.text();
    answer(response.ok ? "yes" : "no", words === "done" ? "" : words);
    return response.ok;
  } catch (error) {
    answer("no", "The run does not answer: " + error.message);
    return false;
  }
}

const presets = [
  {label: "Outage", type: "charger.outage", minutes: 30},
  {label: "Spike", type: "demand.scale", minutes: 60, magnitude: 2},
  {label: "Breakdown", type: "fleet.breakdown", minutes: 60, magnitude: 2},
  {label: "Slow travel", type: "travel.slow", minutes: 60, magnitude: 2},
  {label: "Lying sensor", type: "sensor.biased", minutes: 60, magnitude: 10},
  {label: "Kill", type: "process.kill", minutes: 10},
  {label: "Stop", type: "process.pause", minutes: 10},
  {label: "Partition", type: "network.partition", minutes: 30},
  {label: "Starve the solver", type: "solver.starve", minutes: 60, magnitude: 1},
];

function options(names) {
  return names.map(name => element("option", "", name));
}

function labelled(words, input) {
  const label = element("label", "", words + " ", input);
  label.input = input;
  return label;
}

function input(type, value) {
  const made = element("input", "");
  Object.assign(made, {type, value});
  return made;
}

const magnitudeHint = type => type.unit === "count" ? type.counted + (type.counted === "points" ? ", else all" : "")
  : type.unit === "minutes" ? "minutes" : type.low + " to " + type.high;

// What a schedule would have for what the form says.
function faultOf(type, fields) {
  const regions = [...chosen].sort((a, b) => a - b);
  const fault = {type: type.name};
  const {who, field, topic, magnitude, minutes, to, start, invisible} = fields;
  if (type.target === "regions") {
    fault.target = {regions};
  } else if (type.target === "sensors") {
    fault.target = {regions, field: field.input.value};
  } else if (type.target === "topics") {
    fault.target = {regions, topic: topic.input.value};
  } else if (type.target === "processes") {
    fault.target = who.input.value === "agents" ? {agents: regions} : {[who.input.value]: true};
  }
  fault[type.duration] = minutes.input.value + "min";
  const amount = magnitude.input.value;
  if (type.unit === "count") {
    fault[type.magnitude] = amount === "" && type.counted === "points" ? {fraction_of_points: 1} : {[type.counted]: Number(amount)};
  } else if (type.unit !== "none") {
    fault[type.magnitude] = type.unit === "minutes" ? amount + "min" : Number(amount);
  }
  if (type.to) {
    fault.to = Number(to.input.value);
  }
  if (type.on_start) {
    fault.on_start = start.input.value;
  }
  if (type.invisible && invisible.input.checked) {
    fault.visible = false;
  }
  return fault;
}

// The card by which a fault is asked for; card.paint() shows the regions that are chosen.
function breakingCard() {
  const {types, fields: reported} = heard.day;
  const select = names => element("select", "", ...options(names));
  const kind = labelled("fault", select(types.map(type => type.name)));
  const fields = {
    who: labelled("of", select(["agents", "coordinator", "injector"])),
    field: labelled("field", select(reported)),
    topic: labelled("topic", select(["all", "report", "plan"])),
    minutes: labelled("minutes", input("number", 30)),
    magnitude: labelled("magnitude", input("text", "")),
    to: labelled("to region", input("number", 0)),
    start: labelled("cars there", select(["drain", "evict"])),
    invisible: labelled("nobody is told", input("checkbox", "")),
  };
  const where = element("p", "");
  const hint = element("small", "");
  const typeNow = () => types.find(type => type.name === kind.input.value);
  const show = () => {
    const type = typeNow();
    const shown = {who: type.target === "processes", field: type.target === "sensors", topic: type.target === "topics",
      minutes: true, magnitude: type.unit !== "none", to: type.to, start: type.on_start, invisible: type.invisible};
    Object.entries(fields).forEach(([name, label]) => { label.hidden = !shown[name]; });
    hint.textContent = type.unit === "none" ? "" : magnitudeHint(type);
  };
  kind.input.addEventListener("change", show);
  const quick = presets.map(({label, type, minutes, magnitude}) => {
    const button = element("button", "", label);
    button.addEventListener("click", () => {
      kind.input.value = type;
      fields.minutes.input.value = minutes;
      fields.magnitude.input.value = magnitude ?? "";
      show();
    });
    return button;
  });
  const act = element("button", "", "At the next tick");
  act.id = "inject";
  act.addEventListener("click", () => ask({do: "fault", fault: faultOf(typeNow(), fields)}));
  const none = element("button", "", "Choose none");
  none.addEventListener("click", () => { chosen.clear(); repaint(); });
  const save = element("a", "", "The day's faults as a schedule");
  save.href = "/faults.yaml?token=" + token;
  save.download = "faults.yaml";
  const card = element("figure", "card", element("h3", "", "Break it"), where, element("div", "controls", ...quick),
    element("div", "form", kind, ...Object.values(fields), hint, act, none), element("div", "links", save));
  card.paint = () => {
    const names = [...chosen].sort((a, b) => a - b).map(region => region + " " + heard.day.map.names[region]);
    where.textContent = names.length > 0 ? "Regions " + names.join(", ") : "Click regions on the map.";
  };
  kind.input.value = presets[0].type;
  show();
  return card;
}
