"use strict";
// The answers that a sweep wrote as Markdown: headings, paragraphs, tables, lists and code, which is all it writes.

// Text with `code` and [links](of which the words are kept); a backslash before a mark makes it a character.
function inline(text) {
  const plain = text.replace(/(?<!\\)\[([^\]]*)\]\([^)]*\)/g, "$1");
  const parts = plain.split(/(?<!\\)`/).map(part => part.replace(/\\([\\`*_[\]<>|#])/g, "$1"));
  return parts.map((part, i) => i % 2 === 1 ? element("code", "", part) : part);
}

function markdownTable(lines) {
  const cells = line => line.trim().replace(/^\||(?<!\\)\|$/g, "").split(/(?<!\\)\|/).map(cell => cell.trim());
  const left = cells(lines[1]).map(rule => !rule.endsWith(":"));
  const made = kind => (cell, i) => element(kind, left[i] ? "text" : "", ...inline(cell));
  return element("div", "card wide narrow",
    table(cells(lines[0]).map(made("th")), lines.slice(2).map(line => cells(line).map(made("td")))));
}

function markdownBlock(block) {
  const lines = block.split("\n");
  const heading = /^(#+) (.*)/.exec(block);
  if (heading) {
    return element(heading[1].length === 1 ? "h2" : "h3", "answer", heading[2]);
  }
  if (block.startsWith("|")) {
    return markdownTable(lines);
  }
  if (block.startsWith("    ")) {
    return element("pre", "", lines.map(line => line.trim()).join("\n"));
  }
  if (block.startsWith("- ")) {
    return element("ul", "", ...lines.map(line => element("li", "", ...inline(line.slice(2)))));
  }
  return element("p", "note", ...inline(lines.join(" ")));
}

function addAnswers() {
  const blocks = report.sweep.page.split(/\n\n+/).map(block => block.replace(/^\n+|\n+$/g, "")).filter(Boolean);
  if (blocks.length > 0) {
    document.getElementById("page").append(element("section", "", ...blocks.map(markdownBlock)));
  }
}
