"use strict";
// Slopes: a line for each day from what one variant lost to what another did, so that a bad day is seen.

// Heights as near as may be to `wanted`, which rise, at least `apart` from each other.
function spread(wanted, apart) {
  const heights = [];
  wanted.forEach(height => heights.push(Math.max(height, (heights.at(-1) ?? -Infinity) + apart)));
  return heights;
}

function drawSlopePanel(svg, panel, {from, to}, place, height, ink) {
  const [left, right] = [place.x + 54, place.x + place.width - 92];
  const scale = d3.scaleLinear().domain([0, d3.max(panel.days, day => Math.max(day.value, day.reference)) ?? 1]).nice(5)
    .range([place.y + height - 52, place.y + 44]);
  const [bottom, top] = scale.range();
  const bad = panel.days.filter(day => day.value > day.reference);
  const good = panel.days.filter(day => day.value < day.reference).length;
  write(svg, cutOff(panel.title, place.width - 24), place.x + 20, place.y + 16, {weight: 600, fill: ink.ink});
  write(svg, panel.days.length === 0 ? "no day on which both could be compared"
    : "fewer lost on " + good + " of " + panel.days.length + (panel.days.length === 1 ? " day" : " days"),
  place.x + 20, place.y + 32, {size: 12, fill: ink.soft});
  uprightAxis(svg, scale, left, right, ink);
  [[from, left, place.x + 8, "start"], [to, right, place.x + place.width - 8, "end"]].forEach(([name, x, end, anchor]) => {
    stroke(svg, ["M", x, top, "V", bottom], ink.soft, 1.2);
    wrapped(name, place.width / 2 - 16, 12).slice(0, 3).forEach((line, i) =>
      write(svg, line, end, bottom + 17 + 14 * i, {size: 12, fill: ink.soft, anchor}));
  });
  for (const day of panel.days) {
    const colour = sideColour(Math.sign(day.value - day.reference), ink);
    stroke(svg, ["M", left, scale(day.reference), "L", right, scale(day.value)], colour, 1.8)
      .append("title").text(day.day + ": " + counted(day.reference) + " → " + counted(day.value));
    put(svg.append("circle"), {cx: right, cy: tenth(scale(day.value)), r: 3, fill: colour});
  }
  const sorted = [...bad].sort((a, b) => b.value - a.value);
  spread(sorted.map(day => scale(day.value)), 13).forEach((y, i) =>
    write(svg, sorted[i].day, right + 8, y + 4, {size: 11.5, fill: ink.worse}));
}

function drawSlopes(svg, figure, width, ink) {
  const height = 300;
  const places = panelPlaces(figure.slopes.length, width, height, 245);
  figure.slopes.forEach((panel, i) => drawSlopePanel(svg, panel, figure, {...places[i], width: Math.min(places[i].width, 480)}, height, ink));
  return d3.max(places, place => place.y) + height;
}

const slopeRows = ({from, to, slopes}) => [["scenario", "day", from, to],
  ...slopes.flatMap(panel => panel.days.map(day => [panel.title, day.day, day.reference, day.value]))];
