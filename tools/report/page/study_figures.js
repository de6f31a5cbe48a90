"use strict";
// The figures of a study, each of its kind: drawn, as numbers, and in words.

const studyKinds = {
  fronts: {draw: drawFronts, rows: frontRows},
  claims: {draw: drawForest, rows: forestRows},
  forest: {draw: drawForest, rows: forestRows},
  slopes: {draw: drawSlopes, rows: slopeRows},
  ablation: {draw: drawForest, rows: forestRows},
  map: {draw: drawHeatMap, rows: forestRows},
  bars: {draw: drawBars, rows: barRows},
};
const studyRows = figure => studyKinds[figure.kind].rows(figure);

// What a figure shows, for those who do not see it.
function studyWords({fronts, groups, slopes, bars, shares}) {
  return [
    ...fronts.map(panel => panel.title + ": " + panel.lines.map(({name, hull}) => name + " from " + counted(hull[0][0]) +
      " km and " + counted(hull[0][1]) + " lost to " + counted(hull.at(-1)[0]) + " km and " + counted(hull.at(-1)[1])).join("; ")),
    ...groups.map(group => group.title + ": " + group.rows.map(row => row.name + " " + forestWords(row)).join("; ")),
    ...slopes.map(panel => panel.title + ": fewer lost on " + panel.days.filter(day => day.value < day.reference).length +
      " of " + panel.days.length + " days"),
    ...bars.map(group => group.title + ": " + group.bars.map(({name, value}) => name + " " + barWords(value, shares)).join("; ")),
  ].join(". ") + ".";
}

// Draws a figure into `place`, `width` pixels wide, at least as wide as it can be read; a narrower place scales it.
function drawStudy(place, figure, width, ink) {
  const wide = Math.max(560, width);
  const svg = put(d3.select(place).append("svg"), {xmlns: "http://www.w3.org/2000/svg", role: "img"});
  svg.append("title").text(figure.title);
  svg.append("desc").text(studyWords(figure));
  const height = Math.ceil(studyKinds[figure.kind].draw(svg, figure, wide, ink));
  return put(svg, {viewBox: "0 0 " + wide + " " + height});
}

// A figure as the text of an SVG file, on paper.
function studyFile(figure) {
  const width = 1000;
  const place = document.createElement("div");
  const svg = drawStudy(place, figure, width, paperInk);
  const [, , , height] = svg.attr("viewBox").split(" ");
  put(svg, {width, height});
  put(svg.insert("rect", ":nth-child(3)"), {width, height, fill: paperInk.ground});
  return new XMLSerializer().serializeToString(svg.node()) + "\n";
}
