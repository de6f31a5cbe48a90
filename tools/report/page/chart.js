"use strict";
// A chart of lines as SVG. A chart is
//   {x: {label, domain, clock, mark}, y: {label, fitted}, windows: [{name, from, to}],
//    series: [{label, style, thin, bare, band, points: [{x, y, low, high, name}]}]}
// x.clock: x are minutes after midnight; x.mark: one of them, marked; y.fitted: the axis need not start at 0; style
// counts colours, dashes and symbols; thin: a dotted line; bare: without symbols; band: shown in the legend as the area
// from low to high.

const plotHeight = 240;
const rightMargin = 22;  // half a time of day
const dashes = ["none", "7 4", "2 3", "10 3 2 3", "4 4", "1 2"];
const symbols = [d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle, d3.symbolDiamond, d3.symbolCross, d3.symbolStar];
const colourOf = style => "var(--series-" + style % 6 + ")";
const dashOf = ({style, thin}) => thin ? "1 3" : dashes[(style + Math.floor(style / 6)) % 6];
const symbolOf = style => d3.symbol().size(42).type(symbols[(style + 2 * Math.floor(style / 6)) % 6])();

// Sets several attributes of what is selected.
function put(selection, attributes) {
  Object.entries(attributes).forEach(([name, value]) => selection.attr(name, value));
  return selection;
}

function chartScales(chart, left, width, top) {
  const points = chart.series.flatMap(series => series.points);
  const heights = points.flatMap(point => [point.y, point.low, point.high]).filter(Number.isFinite);
  const x = d3.scaleLinear().domain(chart.x.domain ?? d3.extent(points, point => point.x))
    .range([left, width - rightMargin]);
  const y = d3.scaleLinear().domain(d3.extent(chart.y.fitted ? heights : [0, ...heights]))
    .range([top + plotHeight, top]).nice(6);
  return {x: chart.x.domain ? x : x.nice(), y};
}

function drawAxes(svg, chart, scales, left, width) {
  const [bottom, top] = scales.y.range();
  const x = d3.axisBottom(scales.x).tickSize(top - bottom).tickPadding(8);
  if (chart.x.clock) {
    const every = width < 420 ? 360 : 180;
    const [from, to] = scales.x.domain();
    x.tickValues(d3.range(every * Math.ceil(from / every), to + 1, every)).tickFormat(clock);
  } else {
    x.ticks(width / 110);
  }
  const y = d3.axisLeft(scales.y).ticks(6).tickSize(left - width + rightMargin).tickPadding(8);
  svg.append("g").attr("class", "axis").attr("transform", "translate(0," + bottom + ")").call(x);
  svg.append("g").attr("class", "axis").attr("transform", "translate(" + left + ",0)").call(y);
  put(svg.append("text"), {x: (left + width - rightMargin) / 2, y: bottom + 38, "text-anchor": "middle"})
    .text(chart.x.label);
  put(svg.append("text"), {transform: "translate(14," + (bottom + top) / 2 + ") rotate(-90)", "text-anchor": "middle"})
    .text(chart.y.label);
}

// Places `texts` in rows no longer than `width`: [{left, row}].
function inRows(lengths, width) {
  let [left, row] = [0, 0];
  return lengths.map(length => {
    if (left > 0 && left + length > width) {
      [left, row] = [0, row + 1];
    }
    left += length;
    return {left: left - length, row};
  });
}

// The windows' shades, and their names in three rows at most above the plot; where there is no room a name is left out.
function drawWindows(svg, chart, scales) {
  const [bottom, top] = scales.y.range();
  const [left, right] = scales.x.range();
  const ends = [-Infinity, -Infinity, -Infinity];
  for (const {name, from, to} of chart.windows ?? []) {
    const x = Math.max(left, scales.x(from));
    const width = Math.min(right, scales.x(to)) - x;
    put(svg.append("rect"), {class: "window", x, y: top, width: Math.max(0, width), height: bottom - top})
      .append("title").text(name);
    const text = svg.append("text").attr("y", top - 6).text(name);
    const length = text.node().getComputedTextLength();
    const start = Math.max(left, Math.min(x + (width - length) / 2, right - length));
    const row = ends.findIndex(end => start > end + 8);
    row < 0 ? text.remove() : put(text, {x: start, y: top - 6 - 15 * row});
    ends[row] = start + length;
  }
}

function drawSeries(svg, series, scales) {
  const colour = colourOf(series.style);
  const bounded = series.points.filter(point => Number.isFinite(point.low) && Number.isFinite(point.high));
  if (bounded.length > 1) {
    svg.append("path").attr("class", "band").style("fill", colour).attr("d", d3.area()
      .x(point => scales.x(point.x)).y0(point => scales.y(point.low)).y1(point => scales.y(point.high))(bounded));
  }
  const points = series.points.filter(point => Number.isFinite(point.y));
  svg.append("path").attr("class", series.thin ? "line thin" : "line")
    .style("stroke", colour).style("stroke-dasharray", dashOf(series))
    .attr("d", d3.line().x(point => scales.x(point.x)).y(point => scales.y(point.y))(points));
  if (!series.bare) {
    svg.selectAll(".mark").data(points).enter().append("path").style("fill", colour).attr("d", symbolOf(series.style))
      .attr("transform", point => "translate(" + scales.x(point.x) + "," + scales.y(point.y) + ")");
  }
}

// Gives the height of the whole.
function drawLegend(svg, chart, left, width, top) {
  const legend = svg.append("g").attr("class", "legend");
  const labelled = chart.series.filter(series => series.label);
  if (labelled.length < 2) {
    return top;
  }
  const texts = labelled.map(series => legend.append("text").text(series.label));
  const places = inRows(texts.map(text => 52 + text.node().getComputedTextLength()), width - left);
  texts.forEach((text, i) => {
    const {style, bare, thin, band} = labelled[i];
    const [x, y] = [left + places[i].left, top + 14 + 20 * places[i].row];
    put(text, {x: x + 38, y});
    if (band) {
      put(legend.append("rect"), {class: "band", x, y: y - 10, width: 32, height: 11}).style("fill", colourOf(style));
      return;
    }
    put(legend.append("path"), {class: thin ? "line thin" : "line", d: "M" + x + "," + (y - 4) + "h32"})
      .style("stroke", colourOf(style)).style("stroke-dasharray", dashOf(labelled[i]));
    if (!bare) {
      put(legend.append("path"), {d: symbolOf(style), transform: "translate(" + (x + 16) + "," + (y - 4) + ")"})
        .style("fill", colourOf(style));
    }
  });
  return top + 24 + 20 * places.at(-1).row;
}

// What lies nearest to the pointer: on a clock all that is said of the time, else the one point.
function tipAt(chart, scales, [x, y]) {
  const all = chart.series.filter(series => series.label).flatMap(series =>
    series.points.filter(point => Number.isFinite(point.y)).map(point => ({series, point})));
  const distance = ({point}) =>
    Math.hypot(scales.x(point.x) - x, chart.x.clock ? 0 : scales.y(point.y) - y);
  const nearest = all.reduce((best, one) => distance(one) < distance(best) ? one : best, all[0]);
  const said = chart.x.clock ? all.filter(one => one.point.x === nearest.point.x) : [nearest];
  const lines = said.map(({series, point}) => chart.x.clock
    ? series.label + ": " + brief(point.y)
    : [series.label, point.name, chart.x.label + ": " + brief(point.x), chart.y.label + ": " + brief(point.y)]
      .filter(Boolean).join("\n"));
  const head = chart.x.clock ? [nearest.point.name ?? clock(nearest.point.x)] : [];
  return {point: nearest.point, text: [...head, ...lines].join("\n")};
}

function listen(svg, chart, scales) {
  const [bottom, top] = scales.y.range();
  const here = svg.append("path").attr("class", "here");
  svg.node().addEventListener("mousemove", event => {
    const {point, text} = tipAt(chart, scales, d3.clientPoint(svg.node(), event));
    here.attr("d", chart.x.clock ? "M" + scales.x(point.x) + "," + top + "V" + bottom
      : "M" + (scales.x(point.x) - 9) + "," + scales.y(point.y) + "h18m-9,-9v18");
    showTip(text, event.clientX, event.clientY);
  });
  svg.node().addEventListener("mouseleave", () => {
    here.attr("d", null);
    hideTip();
  });
}

// Draws the chart into the empty element `place`, `width` pixels wide.
function drawChart(place, chart, width) {
  const svg = put(d3.select(place).append("svg"), {xmlns: "http://www.w3.org/2000/svg", role: "img"});
  const top = 14 + 15 * Math.min(3, chart.windows?.length ?? 0);
  const left = 76;
  const scales = chartScales(chart, left, width, top);
  drawAxes(svg, chart, scales, left, width);
  drawWindows(svg, chart, scales);
  chart.series.forEach(series => drawSeries(svg, series, scales));
  if (chart.x.mark !== undefined) {
    put(svg.append("path"), {class: "here", d: "M" + scales.x(chart.x.mark) + "," + top + "v" + plotHeight});
  }
  const height = drawLegend(svg, chart, left, width, top + plotHeight + 50);
  put(svg, {viewBox: "0 0 " + width + " " + height, "aria-label": chart.y.label + " by " + chart.x.label});
  listen(svg, chart, scales);
}

// The chart's numbers, a row a point.
function chartRows(chart) {
  const rows = [["series", "name", chart.x.label, chart.y.label, "low", "high"]];
  for (const series of chart.series) {
    for (const {name, x, y, low, high} of series.points) {
      rows.push([series.label, name ?? "", chart.x.clock ? clock(x) : x, y ?? "", low ?? "", high ?? ""]);
    }
  }
  return rows;
}
