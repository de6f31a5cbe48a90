"use strict";
// What a sweep was asked: the verdict, its figures, how to read them, its tables.

function addMarkdown(text, kind) {
  if (text !== "") {
    document.getElementById("page").append(element("section", kind, ...markdownBlocks(text)));
  }
}

const addVerdict = () => addMarkdown(report.sweep.page.verdict, "verdict");
const addTables = () => addMarkdown(report.sweep.page.tables, "");

function addReading() {
  addMarkdown(report.sweep.page.decided_after, "");
  addMarkdown(report.sweep.page.reading, "");
}

const studyCard = (title, note, shown, ...controls) => drawing(title, note,
  (frame, width) => drawStudy(frame, shown(), width, screenInk), () => studyRows(shown()), ...controls);

function addStudyFigures() {
  document.getElementById("page").append(...report.sweep.page.figures.map((shown, i) =>
    element("div", "study", studyCard("Figure " + (i + 1) + ". " + shown.title, inline(shown.caption), () => shown))));
}

// Lost passengers day by day, of a variant that is chosen against a reference.
function addDays() {
  const options = report.sweep.answers.filter(({metric, at}) => metric === "lost" && (at === "idle_km" || at === null))
    .flatMap(({reference, rows}) => distinct(rows.filter(row => row.by_day?.length > 0).map(row => row.variant))
      .map(variant => ({reference, variant, rows: rows.filter(row => row.variant === variant && row.by_day?.length > 0),
        label: variant + " against " + reference})));
  if (options.length === 0) {
    return;
  }
  let chosen = options[0];
  const shown = () => ({kind: "slopes", title: "Lost passengers day by day", from: chosen.reference, to: chosen.variant,
    fronts: [], groups: [], slopes: chosen.rows.map(row => ({title: placeWords(row) || row.variant, days: row.by_day}))});
  const card = studyCard("Lost passengers day by day", "A line a day, from the reference to the variant: at equal idle km if " +
    "the reference has several settings. A day on which more were lost is named.", shown,
  element("div", "controls", choice("variant against reference", options, option => {
    chosen = option;
    card.redraw();
  })));
  section("Day by day", card);
}
