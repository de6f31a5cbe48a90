"use strict";
// Fronts: lost passengers against km driven empty, a panel a scenario, a line a variant, the bound below them.

const boundName = "bound: no planner can be below it";

// The part of a falling line of points that lies within the panel, drawn on to its right edge.
function clipped(points, {x, y}) {
  const [xEnd, yEnd] = [x.domain()[1], y.domain()[1]];
  const all = [...points, [Math.max(xEnd, points.at(-1)[0]), points.at(-1)[1]]];
  const at = (a, b, share) => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
  const inside = [];
  all.forEach((point, i) => {
    const before = all[i - 1];
    if (before && before[1] > yEnd && point[1] <= yEnd) {
      inside.push(at(before, point, (before[1] - yEnd) / (before[1] - point[1])));
    }
    if (point[1] <= yEnd && point[0] <= xEnd) {
      inside.push(point);
    } else if (before && before[0] < xEnd && point[0] > xEnd) {
      inside.push(at(before, point, (xEnd - before[0]) / (point[0] - before[0])));
    }
  });
  return inside;
}

function frontScales(panel, place, height) {
  const ends = panel.lines.flatMap(line => [...line.points, ...(line.km && line.km[2] !== null ? [[line.km[2], line.lost[2]]] : [])]);
  const highest = d3.max(ends, point => point[1]) ?? 1;
  return {
    x: d3.scaleLinear().domain([0, d3.max(ends, point => point[0]) ?? 1]).nice(4)
      .range([place.x + 58, place.x + place.width - 24]),
    y: d3.scaleLinear().domain([0, highest]).nice(5).range([place.y + height - 46, place.y + 28 + (panel.note === "" ? 0 : 16)]),
  };
}

function drawBound(svg, panel, scales, ink) {
  const corners = clipped(panel.bound, scales).map(([km, lost]) => [scales.x(km), scales.y(lost)]);
  if (corners.length > 1) {
    const floor = scales.y(0);
    stroke(svg, [...polyline(corners), "L", corners.at(-1)[0], floor, "L", corners[0][0], floor, "Z"], "none", 0,
      {fill: ink.ink, "fill-opacity": 0.1});
    stroke(svg, polyline(corners), ink.ink, 1.8, {"stroke-dasharray": "6 3"});
  }
}

// A single setting with its intervals over days.
function drawFrozen(svg, line, style, {x, y}, ink) {
  const colour = ink.series[style % 6];
  const within = (scale, value) => scale(Math.min(scale.domain()[1], Math.max(0, value)));
  if (isKnown(line.km) && isKnown(line.lost)) {
    const [km, kmLow, kmHigh] = line.km;
    const [lost, lostLow, lostHigh] = line.lost;
    stroke(svg, ["M", within(x, kmLow), y(lost), "H", within(x, kmHigh), "M", x(km), within(y, lostLow), "V", within(y, lostHigh)],
      colour, 1.4, {"stroke-opacity": 0.6});
  }
}

function drawFrontLine(svg, line, style, scales, ink) {
  const colour = ink.series[style % 6];
  stroke(svg, polyline(line.hull.map(([km, lost]) => [scales.x(km), scales.y(lost)])), colour, 2.2,
    {"stroke-dasharray": dashOf({style})});
  if (line.km) {
    drawFrozen(svg, line, style, scales, ink);
  }
  for (const [km, lost] of line.points) {
    mark(svg, style, scales.x(km), scales.y(lost), colour, ink)
      .append("title").text(line.name + ": " + counted(km) + " km, " + counted(lost) + " lost");
  }
}

// Gives the height of the legend.
function frontLegend(svg, names, bound, width, ink) {
  const all = [...names, ...(bound ? [boundName] : [])];
  const places = inRows(all.map(name => 56 + textWidth(name)), width - 8);
  all.forEach((name, i) => {
    const [x, y] = [8 + places[i].left, 16 + 20 * places[i].row];
    const colour = i < names.length ? ink.series[i % 6] : ink.ink;
    stroke(svg, ["M", x, y - 4, "H", x + 30], colour, 2, {"stroke-dasharray": i < names.length ? dashOf({style: i}) : "6 3"});
    if (i < names.length) {
      mark(svg, i, x + 15, y - 4, colour, ink);
    }
    write(svg, name, x + 36, y, {fill: ink.ink});
  });
  return 20 * (places.at(-1).row + 1) + 8;
}

function drawFronts(svg, {fronts}, width, ink) {
  const names = [...new Set(fronts.flatMap(panel => panel.lines.map(line => line.name)))];
  const top = frontLegend(svg, names, fronts.some(panel => panel.bound.length > 0), width, ink);
  const height = 258;
  const places = panelPlaces(fronts.length, width, height, 245);
  fronts.forEach((panel, i) => {
    const place = {...places[i], y: places[i].y + top};
    const scales = frontScales(panel, place, height);
    const [left, right] = scales.x.range();
    const [bottom, ceiling] = scales.y.range();
    write(svg, cutOff(panel.title, place.width - 24), place.x + 20, place.y + 15, {weight: 600, fill: ink.ink});
    write(svg, panel.note, place.x + 20, place.y + 31, {size: 11, fill: ink.soft});
    uprightAxis(svg, scales.y, left, right, ink);
    for (const tick of scales.x.ticks(place.width / 90)) {
      write(svg, counted(tick), scales.x(tick), bottom + 17, {size: 12, fill: ink.soft, anchor: "middle"});
    }
    write(svg, "km driven empty", (left + right) / 2, bottom + 34, {size: 12, fill: ink.soft, anchor: "middle"});
    if (place.first) {
      put(write(svg, "passengers lost", 0, 0, {size: 12, fill: ink.soft, anchor: "middle"}),
        {transform: "translate(11," + tenth((bottom + ceiling) / 2) + ") rotate(-90)"});
    }
    if (panel.bound.length > 0) {
      drawBound(svg, panel, scales, ink);
    }
    panel.lines.forEach(line => drawFrontLine(svg, line, names.indexOf(line.name), scales, ink));
  });
  return top + d3.max(places, place => place.y) + height;
}

const frontRows = ({fronts}) => [["scenario", "variant", "km driven empty", "passengers lost"],
  ...fronts.flatMap(panel => [
    ...panel.lines.flatMap(line => line.points.map(([km, lost]) => [panel.title, line.name, km, lost])),
    ...panel.bound.map(([km, lost]) => [panel.title, "bound", km, lost]),
  ])];
