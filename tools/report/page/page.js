"use strict";
// Puts the page together from what the data holds.

document.title = report.title;
document.getElementById("title").textContent = report.title;
document.getElementById("subtitle").textContent = report.subtitle;
document.getElementById("page").append(...report.left_out.map(words => element("p", "note", words)));
if (report.draws) {
  addDraws();
}
if (report.sweep) {
  addSweep();
}
if (report.runs.length > 0) {
  addRuns();
}
if (report.forecasts.length > 0) {
  addForecasts();
}
