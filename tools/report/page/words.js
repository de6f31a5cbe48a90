"use strict";
// What the other scripts write with: numbers, times, elements, CSV.

const report = JSON.parse(document.getElementById("data").textContent);

const number = (value, digits = 0) =>
  value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits});

// As many digits as tell values of a chart apart.
const brief = value =>
  number(value, Number.isInteger(value) || Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 1 ? 1 : 3);

// "17:30" for a minute after midnight, and back.
const clock = minute => String(Math.floor(minute / 60)).padStart(2, "0") + ":" + String(minute % 60).padStart(2, "0");
const minuteOf = time => time.split(":").reduce((hours, minutes) => 60 * hours + Number(minutes), 0);

const sum = values => values.reduce((a, b) => a + b, 0);

function element(name, kind, ...children) {
  const made = document.createElement(name);
  made.className = kind;
  made.append(...children);
  return made;
}

// Cells are texts or elements; those that are td or th stand as they are.
function table(head, rows) {
  const made = element("table", "");
  const cells = (row, kind) => row.map(cell => /^T[DH]$/.test(cell.nodeName) ? cell : element(kind, "", cell));
  made.createTHead().insertRow().append(...cells(head, "th"));
  const body = made.createTBody();
  for (const row of rows) {
    body.insertRow().append(...cells(row, "td"));
  }
  return made;
}

function section(title, ...children) {
  document.getElementById("page").append(element("section", "", element("h2", "", title), ...children));
}

// Rows of cells as the text of a CSV file.
function csvText(rows) {
  const cell = value => /[",\n]/.test(value) ? '"' + String(value).replaceAll('"', '""') + '"' : String(value);
  return rows.map(row => row.map(cell).join(",") + "\n").join("");
}

// A link that gives the text that `make` makes when it is clicked.
function download(label, file, type, make) {
  const link = element("a", "", label);
  link.href = "#";
  link.download = file;
  link.addEventListener("click", () => { link.href = URL.createObjectURL(new Blob([make()], {type})); });
  return link;
}

// A choice among `options`, [{label}].
function choice(name, options, chosen) {
  const select = element("select", "", ...options.map(option => element("option", "", option.label)));
  select.setAttribute("aria-label", name);
  select.addEventListener("change", () => chosen(options[select.selectedIndex]));
  return select;
}

// Text beside a place of the window, such as the pointer's.
function showTip(text, x, y) {
  const tip = document.getElementById("tip");
  tip.textContent = text;
  tip.hidden = false;
  tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - tip.offsetWidth - 4)) + "px";
  tip.style.top = Math.max(4, Math.min(y + 14, innerHeight - tip.offsetHeight - 4)) + "px";
}

const hideTip = () => { document.getElementById("tip").hidden = true; };
