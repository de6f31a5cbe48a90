"use strict";
// A figure is a card with a title, a note, a drawing and the drawing's files.

// Files know nothing of the page's style: the drawing as an SVG file with all of it written out.
function svgText(svg) {
  const properties = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "font-size", "font-family",
    "font-weight"];
  const copy = svg.cloneNode(true);
  const copies = copy.querySelectorAll("*");
  svg.querySelectorAll("*").forEach((original, i) => {
    const style = getComputedStyle(original);
    properties.forEach(name => copies[i].setAttribute(name, style.getPropertyValue(name)));
    copies[i].removeAttribute("style");
    copies[i].removeAttribute("class");
  });
  const {width, height} = svg.viewBox.baseVal;
  const ground = document.createElementNS(svg.namespaceURI, "rect");
  put(d3.select(ground), {width, height, fill: getComputedStyle(svg.closest(".card")).backgroundColor});
  copy.prepend(ground);
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  return new XMLSerializer().serializeToString(copy);
}

const fileName = title => title.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");

// The card of a drawing; `draw(frame, width)` draws it, anew whenever the width changes or card.redraw() is called;
// `rows()` are its numbers; `note` is a text or a list of texts and elements.
function drawing(title, note, draw, rows, ...controls) {
  const frame = element("div", "frame");
  const links = element("div", "links",
    download("SVG", fileName(title) + ".svg", "image/svg+xml", () => svgText(frame.querySelector("svg"))),
    download("CSV", fileName(title) + ".csv", "text/csv", () => csvText(rows())));
  const card = element("figure", "card", element("h3", "", title), element("p", "", ...[note].flat()), ...controls, frame, links);
  let drawn = 0;
  card.redraw = () => {
    drawn = Math.round(frame.clientWidth);
    if (drawn > 0) {
      frame.replaceChildren();
      draw(frame, drawn);
    }
  };
  new ResizeObserver(() => Math.round(frame.clientWidth) === drawn || card.redraw()).observe(frame);
  return card;
}

// The card of a chart that `chart()` gives.
const figure = (title, note, chart, ...controls) =>
  drawing(title, note, (frame, width) => drawChart(frame, chart(), width), () => chartRows(chart()), ...controls);

const figures = all => element("div", "figures", ...all);
