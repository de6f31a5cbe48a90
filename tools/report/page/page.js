"use strict";
// Puts the page together from what the data holds.

const title = report.runs[0].scenario;
document.title = title + ", " + report.runs[0].date;
document.getElementById("title").textContent = title;
document.getElementById("subtitle").textContent = "What the controllers made of it; faults in their windows are shaded.";
addRuns();
