"use strict";
// Fields of reports that plans flagged: what was true, what was reported, and what the coordinator took to be true.

// Times in which a field was flagged, as windows of a chart; reports come every so many minutes.
function flaggedWindows(readings) {
  const every = Math.min(...readings.slice(1).map((reading, i) => reading.minute - readings[i].minute));
  const found = [];
  for (const {minute, estimate} of readings.filter(reading => reading.estimate !== null)) {
    const last = found.at(-1);
    last && minute <= last.to ? last.to = minute + every : found.push({name: "flagged", from: minute, to: minute + every});
  }
  return found;
}

function sensorChart({readings, field}) {
  const points = value => readings.filter(reading => value(reading) !== null).map(reading => (
    {x: reading.minute, y: value(reading)}));
  return {
    x: {label: "time of day", clock: true, domain: d3.extent(readings, reading => reading.minute)},
    y: {label: field.replace("_", " ")},
    windows: flaggedWindows(readings),
    series: [
      {label: "true", style: 0, bare: true, points: points(reading => reading.truth)},
      {label: "reported", style: 1, bare: true, points: points(reading => reading.reported)},
      {label: "estimate", style: 2, points: points(reading => reading.estimate)},
    ].filter(series => series.points.length > 0),
  };
}

function addSensors() {
  const charts = report.runs.flatMap(run => run.sensors.map(sensor => {
    const readings = sensor.readings.map(([minute, reported, estimate, truth]) => (
      {minute: dayStart + minute, reported, estimate, truth}));
    return figure(sensor.field.replace("_", " ") + " of region " + sensor.region + ", " + run.label,
      sensor.kinds.join(", ") + "; shaded while flagged", () => sensorChart({readings, field: sensor.field}));
  }));
  if (charts.length > 0) {
    section("Sensors that lie", element("p", "note", "Fields of reports that plans flagged, those that were flagged most " +
      "often. True is what the region said after the tick before, as far as it says."), figures(charts));
  }
}
