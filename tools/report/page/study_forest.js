"use strict";
// A forest plot: differences with their intervals, a row each, under headings; what the paper reports beside them.

// Ends far beyond the differences themselves are cut off, and drawn as arrows.
function forestScale(rows, left, right) {
  const means = rows.flatMap(row => [row.difference?.[0], row.paper]).filter(Number.isFinite);
  const farthest = Math.max(0.1, 4 * (d3.max(means, Math.abs) ?? 0));
  const ends = rows.flatMap(row => [...(row.difference ?? []), row.paper]).filter(Number.isFinite)
    .map(end => Math.max(-farthest, Math.min(farthest, end)));
  return d3.scaleLinear().domain(d3.extent([0, ...ends])).nice((right - left) / 75).range([left, right]);
}

function drawForestAxis(svg, scale, top, bottom, ink) {
  for (const tick of scale.ticks((scale.range()[1] - scale.range()[0]) / 75)) {
    stroke(svg, ["M", scale(tick), top, "V", bottom], tick === 0 ? ink.soft : ink.grid, tick === 0 ? 1.4 : 1);
    write(svg, perCent(tick, 0).replace("±", ""), scale(tick), bottom + 17, {size: 12, fill: ink.soft, anchor: "middle"});
  }
  write(svg, "← better", scale(0) - 8, top - 6, {size: 12, weight: 600, fill: ink.better, anchor: "end"});
  write(svg, "worse →", scale(0) + 8, top - 6, {size: 12, weight: 600, fill: ink.worse});
}

function drawInterval(svg, [mean, low, high], y, scale, colour, ink) {
  const [first, last] = scale.domain();
  if (low !== null && high !== null) {
    const [from, to] = [Math.max(first, low), Math.min(last, high)];
    stroke(svg, ["M", scale(from), y, "H", scale(to)], colour, 2.4);
    for (const [end, cut, out] of [[from, low < first, -1], [to, high > last, 1]]) {
      cut ? stroke(svg, ["M", scale(end) - 7 * out, y - 5, "L", scale(end), y, "L", scale(end) - 7 * out, y + 5], colour, 2)
        : stroke(svg, ["M", scale(end), y - 4, "V", y + 4], colour, 1.6);
    }
  }
  put(svg.append("circle"), {cx: tenth(scale(Math.max(first, Math.min(last, mean)))), cy: y, r: 4.5,
    fill: low === null || high === null ? ink.ground : colour, stroke: colour, "stroke-width": 1.6});
}

function forestWords({difference, p_holm, paper}) {
  if (paper !== null) {
    return perCent(paper);
  }
  return difference === null ? "nothing could be compared" : perCent(difference[0]) + " (" + rangeWords(difference) + ")" +
    (p_holm === null ? "" : p_holm < 0.0005 ? ", p < 0.001" : ", p = " + p_holm.toFixed(3));
}

function drawForestRow(svg, row, y, {scale, names, numbers}, ink) {
  const side = row.difference === null ? 0 : sideOf(row);
  const colour = sideColour(side, ink);
  wrapped(row.name, names - 26).forEach((line, i, all) =>
    write(svg, line, 18, y + 4 + 15 * (i - (all.length - 1) / 2), {fill: ink.ink}));
  if (row.paper !== null) {
    put(svg.append("path"), {d: "M0,-6L6,0L0,6L-6,0Z", transform: "translate(" + tenth(scale(row.paper)) + "," + tenth(y) + ")",
      fill: ink.ink});
  } else if (row.difference !== null) {
    drawInterval(svg, row.difference, tenth(y), scale, colour, ink);
  }
  write(svg, forestWords(row), numbers, y + 4, {size: 12.5, fill: side === 0 ? ink.ink : colour, weight: side === 0 ? 400 : 600});
}

function drawForest(svg, {groups}, width, ink) {
  const rows = groups.flatMap(group => group.rows);
  const numbers = width - 12 - d3.max(rows, row => boldWidth(forestWords(row), 12.5));
  const names = Math.min(0.4 * width, 30 + d3.max(rows, row => textWidth(row.name)));
  const scale = forestScale(rows, names + 8, numbers - 22);
  const heightOf = row => Math.max(25, 16 * wrapped(row.name, names - 26).length + 8);
  const top = 24;
  const bottom = top + d3.sum(groups, group => 27 + d3.sum(group.rows, heightOf)) + 4;
  drawForestAxis(svg, scale, top, bottom, ink);
  let y = top;
  for (const group of groups) {
    write(svg, group.title, 6, y + 18, {weight: 600, fill: ink.ink});
    y += 27;
    const paper = group.rows.find(row => row.paper !== null);
    if (paper) {
      stroke(svg, ["M", scale(paper.paper), y, "V", y + d3.sum(group.rows, heightOf) - 4], ink.ink, 1.2, {"stroke-dasharray": "2 3"});
    }
    for (const row of group.rows) {
      drawForestRow(svg, row, y + heightOf(row) / 2, {scale, names, numbers}, ink);
      y += heightOf(row);
    }
  }
  return bottom + 28;
}

const forestRows = ({groups}) => [["group", "row", "difference", "low", "high", "p, Holm", "the paper", "days"],
  ...groups.flatMap(group => group.rows.map(row => [group.title, row.name, row.difference?.[0] ?? "",
    row.difference?.[1] ?? "", row.difference?.[2] ?? "", row.p_holm ?? "", row.paper ?? "", row.days]))];
