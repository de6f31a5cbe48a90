"use strict";
// A map of one variant against another: a cell a scenario and schedule of faults. What is not shown has no colour.

function drawCell(svg, row, x, y, width, height, most, ink) {
  const side = row.difference === null ? 0 : sideOf(row);
  const share = row.difference === null ? 0 : Math.min(1, Math.abs(row.difference[0]) / most);
  put(svg.append("rect"), {x: tenth(x + 2), y: y + 2, width: tenth(width - 4), height: height - 4, rx: 4,
    fill: side === 0 ? ink.ground : sideColour(side, ink), "fill-opacity": side === 0 ? 1 : tenth(10 * (0.12 + 0.43 * share)) / 10,
    stroke: side === 0 ? ink.soft : sideColour(side, ink), "stroke-dasharray": side === 0 ? "3 3" : "none"});
  const middle = {anchor: "middle"};
  if (row.difference === null) {
    write(svg, "not compared", x + width / 2, y + height / 2 + 4, {...middle, size: 12, fill: ink.soft});
    return;
  }
  write(svg, perCent(row.difference[0]), x + width / 2, y + 20,
    {...middle, weight: side === 0 ? 400 : 700, fill: side === 0 ? ink.soft : ink.ink});
  write(svg, rangeWords(row.difference), x + width / 2, y + 36, {...middle, size: 11, fill: side === 0 ? ink.soft : ink.ink});
}

function drawHeatMap(svg, {groups}, width, ink) {
  const columns = groups[0].rows.map(row => row.name);
  const names = Math.min(0.3 * width, 16 + d3.max(groups, group => textWidth(group.title)));
  const cell = {width: Math.min(190, (width - names - 8) / columns.length), height: 46};
  const heads = columns.map(name => wrapped(name, cell.width - 10, 12));
  const top = 10 + 15 * d3.max(heads, lines => lines.length);
  const most = Math.max(0.01, d3.max(groups.flatMap(group => group.rows), row => Math.abs(row.difference?.[0] ?? 0)));
  heads.forEach((lines, i) => lines.forEach((line, j) => write(svg, line, names + (i + 0.5) * cell.width, 15 + 15 * j,
    {size: 12, weight: 600, fill: ink.ink, anchor: "middle"})));
  groups.forEach((group, i) => {
    const y = top + cell.height * i;
    wrapped(group.title, names - 12).slice(0, 2).forEach((line, j, all) =>
      write(svg, line, 6, y + cell.height / 2 + 4 + 15 * (j - (all.length - 1) / 2), {fill: ink.ink}));
    group.rows.forEach((row, j) => drawCell(svg, row, names + j * cell.width, y, cell.width, cell.height, most, ink));
  });
  const bottom = top + cell.height * groups.length;
  const legend = wrapped("Blue: fewer lost. Orange: more. Dashed, without colour: the 95 % interval, below, holds 0, so nothing is shown.",
    width - 12, 12);
  legend.forEach((line, i) => write(svg, line, 6, bottom + 18 + 15 * i, {size: 12, fill: ink.soft}));
  return bottom + 12 + 15 * legend.length;
}
