"use strict";
// What the draws of one schedule of faults came to, which `evbal run` wrote as Markdown.

function addDraws() {
  const blocks = report.draws.split(/\n\n+/).map(block => block.replace(/^\n+|\n+$/g, "")).filter(Boolean);
  document.getElementById("page").append(element("section", "", ...blocks.map(markdownBlock)));
}
