"use strict";
// The answers that a sweep wrote as Markdown: headings, paragraphs, tables, lists and code, which is all it writes.

// Text with `code`, **strong** words and [links](of which the words are kept); a backslash before a mark makes it a
// character.
function inline(text) {
  const plain = text.replace(/(?<!\\)\[([^\]]*)\]\([^)]*\)/g, "$1");
  const read = part => part.replace(/\\([\\`*_[\]<>|#])/g, "$1");
  return plain.split(/(?<!\\)(`[^`]*`|\*\*.+?\*\*)/).map(part =>
    part.startsWith("**") ? element("strong", "", read(part.slice(2, -2)))
      : part.startsWith("`") ? element("code", "", read(part.slice(1, -1))) : read(part));
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
    return element(heading[1].length < 3 ? "h2" : "h3", "answer", ...inline(heading[2]));
  }
  if (block.startsWith("|")) {
    return markdownTable(lines);
  }
  if (block.startsWith("    ")) {
    return element("pre", "", lines.map(line => line.trim()).join("\n"));
  }
  if (block.startsWith("> ")) {
    return element("blockquote", "", ...markdownBlocks(lines.map(line => line.replace(/^> ?/, "")).join("\n")));
  }
  if (block.startsWith("- ")) {
    return element("ul", "", ...lines.map(line => element("li", "", ...inline(line.slice(2)))));
  }
  return element("p", "note", ...inline(lines.join(" ")));
}

// The blocks of a text, which stand apart by empty lines.
const markdownBlocks = text =>
  text.split(/\n\n+/).map(block => block.replace(/^\n+|\n+$/g, "")).filter(Boolean).map(markdownBlock);
