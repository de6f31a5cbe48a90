"use strict";
// Bars: what metrics of variants came to, a group a scenario and schedule of faults. A colour is a variant or metric.

const barHeight = 17;
const barWords = ([mean], shares) => shares ? Math.round(100 * mean) + "\u00a0%" : counted(mean);

function drawBar(svg, {name, value}, y, scale, shares, colour, ink) {
  const [left, end] = [scale(0), scale(value[0])];
  put(svg.append("rect"), {x: tenth(left), y: y + 2, width: tenth(Math.max(0, end - left)), height: barHeight - 4, fill: colour})
    .append("title").text(name + ": " + barWords(value, shares));
  if (isKnown(value)) {
    stroke(svg, ["M", scale(Math.max(0, value[1])), y + barHeight / 2, "H", scale(value[2])], ink.ink, 1.2);
  }
  write(svg, barWords(value, shares), scale(isKnown(value) ? Math.max(value[0], value[2]) : value[0]) + 6, y + barHeight / 2 + 4,
    {size: 12, fill: ink.ink});
}

function drawBars(svg, {bars, shares}, width, ink) {
  const names = [...new Set(bars.flatMap(group => group.bars.map(bar => bar.name)))];
  const left = Math.min(0.4 * width, 24 + (d3.max(bars, group => boldWidth(group.title)) ?? 0));
  const most = shares ? 1 : d3.max(bars.flatMap(group => group.bars), ({value}) => Math.max(value[0], value[2] ?? 0)) ?? 1;
  const scale = d3.scaleLinear().domain([0, most]).nice(5).range([left, width - 64]);
  const heights = bars.map(group => barHeight * group.bars.length + 10);
  const [top, bottom] = [30, 30 + d3.sum(heights)];
  for (const tick of scale.ticks(5)) {
    stroke(svg, ["M", scale(tick), top, "V", bottom], ink.grid, 1);
    write(svg, barWords([tick], shares), scale(tick), bottom + 16, {size: 12, fill: ink.soft, anchor: "middle"});
  }
  const colours = names.map((_, i) => ink.series[i % ink.series.length]);
  const places = inRows(names.map(name => 34 + textWidth(name, 12)), width - 24);
  const rows = (places.at(-1)?.row ?? 0) + 1;
  names.forEach((name, i) => {
    const [x, y] = [12 + places[i].left, bottom + 36 + 18 * places[i].row];
    put(svg.append("rect"), {x: tenth(x), y: y - 10, width: 12, height: 12, fill: colours[i]});
    write(svg, name, x + 18, y, {size: 12, fill: ink.ink});
  });
  let y = top;
  bars.forEach((group, i) => {
    write(svg, cutOff(group.title, left - 8), left - 10, y + (heights[i] - 10) / 2 + 4, {fill: ink.ink, anchor: "end"});
    group.bars.forEach((bar, j) =>
      drawBar(svg, bar, y + barHeight * j, scale, shares, colours[names.indexOf(bar.name)], ink));
    y += heights[i];
  });
  return bottom + 28 + 18 * rows;
}

const barRows = ({bars}) => [["scenario and faults", "bar", "mean", "low", "high"],
  ...bars.flatMap(group => group.bars.map(({name, value}) => [group.title, name, ...value]))];
