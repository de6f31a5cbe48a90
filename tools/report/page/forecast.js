"use strict";
// What was forecast of a day, and how wrong the city's model takes its forecasts to be.

// What a day brought, step by step, over what was forecast of it and twice the standard deviation around that.
function forecastChart({unit, start, step_minutes: length, observed, forecast, deviation}) {
  const points = more => observed.map((_, step) => ({x: start + (step + 0.5) * length, ...more(step)}));
  return {
    x: {label: "time of day", clock: true, domain: [start, start + length * observed.length]},
    y: {label: unit},
    windows: report.runs.length > 0 ? windows() : [],
    series: [
      {label: "± 2 standard deviations", style: 1, band: true, bare: true, points: points(step => (
        {low: Math.max(0, forecast[step] - 2 * deviation[step]), high: forecast[step] + 2 * deviation[step]}))},
      {label: "real", style: 0, points: points(step => ({y: observed[step]}))},
      {label: "forecast one step before", style: 1, bare: true, points: points(step => ({y: forecast[step]}))},
    ],
  };
}

// The paper's table, of five regions and two steps, by the size of a resample.
const paperThresholds = [[10, 1.504, 3.715], [20, 0.964, 2.832], [50, 0.576, 2.006], [100, 0.399, 1.768],
  [500, 0.296, 1.374], [1000, 0.176, 1.317]];

function thresholdTable() {
  const fixed = value => number(value, 3);
  return table(["", "resample", "g1", "root of g1", "g2"], [
    ...report.thresholds.map(({series, steps, g1, g2}) =>
      [series + ", " + steps + (steps === 1 ? " step" : " steps"), "500", fixed(g1), fixed(Math.sqrt(g1)), fixed(g2)]),
    ...paperThresholds.map(([resample, g1, g2]) => ["paper, 10 dimensions", String(resample), "", fixed(g1), fixed(g2)]),
  ]);
}

function addForecasts() {
  const thresholds = report.thresholds.length === 0 ? [] : [element("div", "card wide",
    element("h3", "", "Thresholds of the ambiguity set"),
    element("p", "", "At 75 %, as the city's model has them. The paper's g1 fits the root of ours. They fall as resamples " +
      "grow, and rise with the dimension."),
    thresholdTable())];
  const charts = report.forecasts.map(one => figure(one.title, one.note, () => forecastChart(one)));
  section("Forecast", figures(charts), ...thresholds);
}
