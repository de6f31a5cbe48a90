"use strict";
// What the figures of a study are drawn with. They know nothing of the page: colours and fonts are written into the
// drawing, and lengths of text are estimated, so that the same code draws them on the page and into files (draw_files.js).

// Okabe and Ito's colours, told apart by every kind of colour vision; on paper, and as the page has them.
const paperInk = {
  ground: "#ffffff", ink: "#1b1f24", soft: "#57606a", line: "#d9dee3", grid: "#e8ebee", better: "#0072b2", worse: "#d55e00",
  series: ["#0072b2", "#d55e00", "#009e73", "#a8558a", "#8a6d00", "#57606a"],
};
const screenInk = {
  ground: "var(--card)", ink: "var(--ink)", soft: "var(--soft)", line: "var(--line)", grid: "var(--grid)",
  better: "var(--series-0)", worse: "var(--series-1)", series: d3.range(6).map(i => "var(--series-" + i + ")"),
};

const letterWidth = letter =>
  /[ijlt.,:;'|!()[\] \u00a0fr]/.test(letter) ? 0.38 : /[mwMW%−]/.test(letter) ? 0.9 : /[A-Z]/.test(letter) ? 0.7 : 0.61;
const textWidth = (text, size = 13) => size * d3.sum(text, letterWidth);
const boldWidth = (text, size = 13) => 1.12 * textWidth(text, size);

// The text in lines no longer than `width`.
function wrapped(text, width, size = 13) {
  const lines = [""];
  for (const word of text.split(" ")) {
    const longer = lines.at(-1) === "" ? word : lines.at(-1) + " " + word;
    lines.at(-1) === "" || textWidth(longer, size) <= width ? lines[lines.length - 1] = longer : lines.push(word);
  }
  return lines;
}

// A heading, cut off where it is longer than `width`.
function cutOff(text, width) {
  let end = text.length;
  while (boldWidth(text.slice(0, end)) > width) {
    --end;
  }
  return end < text.length ? text.slice(0, end - 1) + "…" : text;
}

const tenth = value => Math.round(10 * value) / 10;

function write(parent, text, x, y, {size = 13, weight = 400, fill, anchor = "start"}) {
  return put(parent.append("text"), {x: tenth(x), y: tenth(y), "text-anchor": anchor,
    style: "font:" + weight + " " + size + "px system-ui,'DejaVu Sans',sans-serif;fill:" + fill}).text(text);
}

// A path with its style; `d` is a list of commands and numbers.
function stroke(parent, d, colour, width, more = {}) {
  const path = d.map(part => typeof part === "number" ? tenth(part) : part).join(" ").replace(/ ?([MLHVZ]) ?/g, "$1");
  return put(parent.append("path"), {d: path, fill: "none", stroke: colour, "stroke-width": width, ...more});
}

const polyline = points => points.flatMap(([x, y], i) => [i === 0 ? "M" : "L", x, y]);

function mark(parent, style, x, y, colour, ink) {
  return put(parent.append("path"), {d: symbolOf(style).replace(/-?\d+\.\d+/g, tenth), fill: colour, stroke: ink.ground,
    transform: "translate(" + tenth(x) + "," + tenth(y) + ")"});
}

const counted = value => d3.format(",")(Math.abs(value) >= 10 ? Math.round(value) : Math.round(100 * value) / 100);
const perCent = (share, digits = 1) => {
  const text = (100 * Math.abs(share)).toFixed(digits);
  return (Number(text) === 0 ? "±" : share > 0 ? "+" : "−") + text + "\u00a0%";
};
const isKnown = ([, low, high]) => low !== null && high !== null;
const rangeWords = difference => isKnown(difference)
  ? perCent(difference[1]).replace("\u00a0%", "") + " to " + perCent(difference[2]) : "interval not known";

// Which side a row is on, as far as that is shown: by p where it has one, else by its interval.
const sideOf = ({difference, p_holm}) => {
  const shown = p_holm === null ? difference !== null && isKnown(difference) && difference[1] * difference[2] > 0 : p_holm < 0.05;
  return !shown ? 0 : difference[0] < 0 ? -1 : 1;
};
const sideColour = (side, ink) => side < 0 ? ink.better : side > 0 ? ink.worse : ink.soft;

// Where each of `count` panels lies, so many beside each other as have room.
function panelPlaces(count, width, height, least) {
  const columns = Math.max(1, Math.min(count, Math.floor(width / least)));
  return d3.range(count).map(i => ({
    x: i % columns * width / columns, y: Math.floor(i / columns) * height, width: width / columns, first: i % columns === 0,
  }));
}

// A panel's upright axis with its grid from `left` to `right`.
function uprightAxis(svg, scale, left, right, ink) {
  for (const tick of scale.ticks(5)) {
    stroke(svg, ["M", left, scale(tick), "H", right], ink.grid, 1);
    write(svg, counted(tick), left - 7, scale(tick) + 4, {size: 12, fill: ink.soft, anchor: "end"});
  }
}
