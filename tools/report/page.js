"use strict";

// Okabe and Ito's colours, told apart by every kind of colour vision; light and dark page.
const palette = [["#0072B2", "#56B4E9"], ["#D55E00", "#F0883E"], ["#009E73", "#2FC79B"],
                 ["#A8558A", "#E29BC6"], ["#8A6D00", "#F0E442"], ["#57606A", "#AEB7C0"]];
const dashes = [[], [7, 4], [2, 3], [10, 3, 2, 3], [4, 4], [1, 2]];
const markers = ["circle", "rect", "triangle", "rectRot", "star", "cross"];

const dark = matchMedia("(prefers-color-scheme: dark)");
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const colour = i => palette[i % palette.length][dark.matches ? 1 : 0];

const [startHours, startMinutes] = report.day_start.split(":").map(Number);
const dayStart = 60 * startHours + startMinutes;
const clock = minute => String(Math.floor(minute / 60)).padStart(2, "0") + ":" + String(minute % 60).padStart(2, "0");
const number = (value, digits) => value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits});

// --- hours ---------------------------------------------------------------------------------------------------------

const sum = values => values.reduce((a, b) => a + b, 0);

// [{from, to, steps}] of the clock's hours, in minutes after midnight.
function hours() {
  const found = new Map();
  report.runs[0].steps.step.forEach((_, step) => {
    const hour = Math.floor((dayStart + step * report.step_minutes) / 60);
    found.set(hour, [...(found.get(hour) ?? []), step]);
  });
  return [...found.values()].map(steps => ({
    from: dayStart + steps[0] * report.step_minutes,
    to: dayStart + (steps.at(-1) + 1) * report.step_minutes,
    steps,
  }));
}

const ofHour = (run, column, hour) => sum(hour.steps.map(step => run.steps[column][step]));

const figures = [
  {title: "Idle distance", note: "Driven without a passenger to rebalance or to charge, low-battery cars weighted by beta.",
   axis: "km per hour", value: (run, hour) => ofHour(run, "idle_km", hour)},
  {title: "Unfairness of the supply-demand ratio", note: "Sum over regions of the distance from the city's ratio; lower is fairer.",
   axis: "sum of |difference|", value: (run, hour) => ofHour(run, "unfairness_demand", hour)},
  {title: "Unfairness of utilisation", note: "The same for charged cars over cars that need a charger, regions with points.",
   axis: "sum of |difference|", value: (run, hour) => ofHour(run, "unfairness_charging", hour)},
  {title: "Lost passengers", note: "Those whose patience ended; less driving with more of them is no saving.",
   axis: "passengers per hour", value: (run, hour) => ofHour(run, "lost", hour)},
  {title: "Queue for a charger", note: "Low-battery cars waiting where there is a station, mean over the hour.",
   axis: "cars", value: (run, hour) => ofHour(run, "queue_minutes", hour) / (hour.to - hour.from)},
  {title: "Passenger's wait", note: "Of the served passengers, mean over the hour.",
   axis: "minutes", value: (run, hour) => ofHour(run, "wait_minutes", hour) / Math.max(1, ofHour(run, "served", hour))},
];

// --- charts --------------------------------------------------------------------------------------------------------

const windows = {
  id: "windows",
  beforeDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {x}} = chart;
    ctx.save();
    ctx.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    let labelsEnd = -Infinity;
    let row = 0;
    for (const fault of report.faults) {
      const from = Math.max(area.left, x.getPixelForValue(dayStart + fault.start));
      const to = Math.min(area.right, x.getPixelForValue(dayStart + fault.end));
      ctx.fillStyle = css("--window");
      ctx.fillRect(from, area.top, to - from, area.bottom - area.top);
      ctx.fillStyle = css("--soft");
      const width = ctx.measureText(fault.name).width;
      const left = Math.max(area.left + 2, Math.min((from + to - width) / 2, area.right - width - 2));
      row = left < labelsEnd + 8 ? 1 - row : 0;
      labelsEnd = left + width;
      ctx.fillText(fault.name, left, area.top - 7 - 14 * row);
    }
    ctx.restore();
  },
};

function options(figure) {
  const text = {color: css("--soft"), font: {size: 13}};
  const title = words => ({display: true, text: words, ...text});
  return {
    animation: false,
    maintainAspectRatio: false,
    interaction: {mode: "index", intersect: false},
    layout: {padding: {top: report.faults.length > 1 ? 34 : 20}},
    scales: {
      x: {type: "linear", min: dayStart, max: dayStart + report.step_minutes * report.runs[0].steps.step.length,
          title: title("time of day"), grid: {color: css("--grid")},
          ticks: {...text, stepSize: 180, maxRotation: 0, includeBounds: false, callback: clock},
          afterBuildTicks: axis => { axis.ticks = axis.ticks.map(t => 180 * Math.ceil(t.value / 180))
            .filter((v, i, all) => v <= axis.max && all.indexOf(v) === i).map(value => ({value})); }},
      y: {beginAtZero: true, title: title(figure.axis), grid: {color: css("--grid")}, ticks: text},
    },
    plugins: {
      legend: {display: report.runs.length > 1, position: "bottom",
               labels: {...text, color: css("--ink"), boxWidth: 36, boxHeight: 0, padding: 14}},
      tooltip: {callbacks: {
        title: items => { const hour = hours()[items[0].dataIndex]; return clock(hour.from) + " – " + clock(hour.to); },
        label: item => " " + item.dataset.label + ": " + number(item.parsed.y, item.parsed.y < 100 ? 1 : 0),
      }},
    },
  };
}

function datasets(figure) {
  return report.runs.map((run, i) => ({
    label: run.label,
    data: hours().map(hour => ({x: (hour.from + hour.to) / 2, y: figure.value(run, hour)})),
    borderColor: colour(i), backgroundColor: colour(i), borderWidth: 2.2,
    borderDash: dashes[i % dashes.length], pointStyle: markers[i % markers.length], pointRadius: 3.2,
  }));
}

// What a day brought, step by step, over what was forecast of it and twice the standard deviation around that.
function forecastDatasets(forecast) {
  const points = value => forecast.observed.map((_, step) =>
    ({x: dayStart + (step + 0.5) * report.step_minutes, y: Math.max(0, value(step))}));
  const line = (label, i, value, more) =>
    ({label, data: points(value), borderColor: colour(i), backgroundColor: colour(i), borderWidth: 2.2, pointRadius: 0, ...more});
  const edge = (label, sign, fill) => line(label, 1, step => forecast.forecast[step] + sign * 2 * forecast.deviation[step],
    {borderWidth: 0, backgroundColor: colour(1) + "30", fill});
  return [
    line("real", 0, step => forecast.observed[step], {pointRadius: 2.5}),
    line("forecast one step before", 1, step => forecast.forecast[step], {borderDash: dashes[1]}),
    edge("", 1, false),
    edge("± 2 standard deviations", -1, "-1"),
  ];
}

function forecastOptions(forecast) {
  const chosen = options({axis: forecast.unit});
  chosen.plugins.legend = {...chosen.plugins.legend, display: true};
  chosen.plugins.legend.labels.filter = item => item.text !== "";
  chosen.plugins.legend.labels.boxHeight = 8;
  chosen.plugins.tooltip = {filter: item => item.datasetIndex < 2, callbacks: {title: items => clock(items[0].parsed.x)}};
  return chosen;
}

let charts = [];

function draw() {
  charts.forEach(chart => chart.destroy());
  charts = figures.map((figure, i) => new Chart(document.getElementById("figure-" + i), {
    type: "line", data: {datasets: datasets(figure)}, options: options(figure), plugins: [windows],
  }));
  report.forecasts.forEach((forecast, i) => charts.push(new Chart(document.getElementById("forecast-" + i), {
    type: "line", data: {datasets: forecastDatasets(forecast)}, options: forecastOptions(forecast), plugins: [windows],
  })));
  document.querySelectorAll(".swatch").forEach((swatch, i) => { swatch.style.background = colour(i); });
}

// --- words and numbers ---------------------------------------------------------------------------------------------

// better: -1 where less is better, 1 where more is.
const rows = [
  {name: "Idle distance", unit: "km", digits: 0, better: -1, value: run => run.totals.idle_km},
  {name: "Unfairness of the supply-demand ratio", digits: 1, better: -1, value: run => run.totals.unfairness_demand},
  {name: "Unfairness of utilisation", digits: 1, better: -1, value: run => run.totals.unfairness_charging},
  {name: "Served passengers", digits: 0, better: 1, value: run => run.totals.served},
  {name: "Lost passengers", digits: 0, better: -1, value: run => run.totals.lost},
  {name: "Lost share of passengers", unit: "%", digits: 1, better: -1, value: run => 100 * run.totals.unserved_ratio},
  {name: "Lost share, worst tenth of regions", unit: "%", digits: 1, better: -1, value: run => 100 * run.totals.p90_regional_loss},
  {name: "Passenger's wait", unit: "min", digits: 1, better: -1, value: run => run.totals.passenger_wait_min},
  {name: "Charger wait per session", unit: "min", digits: 1, better: -1, value: run => run.totals.charger_wait_min_per_session},
  {name: "Idle distance per served passenger", unit: "km", digits: 2, better: -1, value: run => run.totals.idle_km_per_served},
  {name: "Stranded cars", digits: 0, better: -1, value: run => run.totals.stranded},
  {name: "Energy charged", unit: "kWh", digits: 0, better: 0, value: run => run.totals.charged_kwh},
  {name: "Plans that fell back", digits: 0, better: 0, value: run => run.fallbacks},
  {name: "Solver time per plan, median", unit: "s", digits: 2, better: 0, value: run => run.solve_seconds_median},
];

const element = (name, text, kind) => {
  const made = document.createElement(name);
  made.textContent = text ?? "";
  made.className = kind ?? "";
  return made;
};

// The change against the first run, in percent.
function change(row, run) {
  const base = row.value(report.runs[0]);
  if (base === 0 || row.better === 0) {
    return element("td");
  }
  const percent = 100 * (row.value(run) / base - 1);
  const shown = (percent > 0 ? "+" : percent < 0 ? "−" : "±") + number(Math.abs(percent), 1) + " %";
  const kind = Math.abs(percent) < 0.05 ? "" : percent * row.better > 0 ? "better" : "worse";
  return element("td", shown, kind);
}

function fillTable() {
  const head = document.getElementById("totals").createTHead().insertRow();
  head.append(element("th", "The day"));
  report.runs.forEach((run, i) => {
    const cell = element("th");
    cell.append(element("span", "", "swatch"), run.label);
    head.append(cell);
    if (i > 0) {
      head.append(element("th", "against " + report.runs[0].label));
    }
  });
  const body = document.getElementById("totals").createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    const name = element("td", row.name + " ");
    name.append(element("small", row.unit));
    line.append(name);
    report.runs.forEach((run, i) => {
      line.append(element("td", number(row.value(run), row.digits)));
      if (i > 0) {
        line.append(change(row, run));
      }
    });
  }
}

function fillWords() {
  const first = report.runs[0];
  const weekday = new Date(first.date + "T12:00:00").toLocaleDateString("en-GB",
    {weekday: "long", day: "numeric", month: "long", year: "numeric"});
  document.title = first.scenario + ", " + first.date;
  document.getElementById("title").textContent = first.scenario;
  document.getElementById("subtitle").textContent = weekday + ", " + number(first.regions) + " regions, " +
    number(first.fleet) + " vehicles, seed " + first.seed + ". Hour by hour; faults in their windows are shaded.";
  const notes = document.getElementById("notes");
  for (const run of report.runs) {
    const line = element("div", run.label + ": digest ");
    line.append(element("code", run.digest), ", over " + run.transport + ", " + number(run.wall_seconds, 0) +
      " s; the same again: ", element("code", "evbal replay " + run.folder));
    notes.append(line);
  }
  for (const fault of report.faults) {
    notes.append(element("div", "Fault " + fault.name + ": " + fault.type + ", " + clock(dayStart + fault.start) +
      " – " + clock(dayStart + fault.end)));
  }
}

function addFigure(id, title, axis, note) {
  const card = element("figure", "", "card");
  card.style.margin = 0;
  const frame = element("div", "", "chart");
  const canvas = element("canvas");
  canvas.id = id;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", title + ", " + axis);
  frame.append(canvas);
  card.append(element("h2", title), element("p", note), frame);
  document.getElementById("figures").append(card);
}

function addFigures() {
  figures.forEach((figure, i) => addFigure("figure-" + i, figure.title, figure.axis + ", by hour", figure.note));
  report.forecasts.forEach((forecast, i) => addFigure("forecast-" + i, forecast.title, forecast.unit,
    "The whole city, " + report.runs[0].label + "; faults are in what came, not in the forecast."));
}

fillWords();
fillTable();
addFigures();
draw();
dark.addEventListener("change", draw);
