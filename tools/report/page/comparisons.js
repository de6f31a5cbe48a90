"use strict";
// Variants of a sweep against one of them, pair by pair, with intervals; and against what the paper reports.

// Relative differences in per cent; where the reference is 0 somewhere, plain ones.
const signed = (value, digits) => (value > 0 ? "+" : value < 0 ? "−" : "±") + number(Math.abs(value), digits);
const difference = ([mean], relative) => relative ? signed(100 * mean, 1) + " %" : signed(mean, 1);
const range = (interval, relative) => !interval ? "" : interval[1] === null ? "not known"
  : signed((relative ? 100 : 1) * interval[1], 1) + " … " + signed((relative ? 100 : 1) * interval[2], 1);

// Less is better of all that is compared.
const verdict = ({by_t: [mean], p_holm: p}) => p >= 0.05 ? "" : mean < 0 ? "better" : "worse";

const result = (row, text) => element("td", verdict(row), text);

// The cells of a row of a comparison, and of the same row with what happens before 07:00 left out.
function comparisonCells(row, after, at) {
  return [
    ...(at ? [number(row.at)] : []), brief(row.value), brief(row.reference),
    result(row, difference(row.by_t, row.relative)), result(row, range(row.by_t, row.relative)),
    range(row.by_bootstrap, true), number(row.p_holm, 4),
    after?.pairs > 0 ? result(after, difference(after.by_t, after.relative) + ", " + range(after.by_t, after.relative)) : "",
  ];
}

function comparisonTable({metric, at, reference, rows}) {
  const later = report.sweep.answers.find(other => other.metric === metric + late && other.reference === reference);
  const keys = ["scenario", "faults", "variant", "settings"];
  const same = row => later?.rows.find(other => keys.every(key => other[key] === row[key]));
  const head = [...(at ? [lower(metricNames[at])] : []), "mean", reference, "difference", "95 % by t", "95 % by bootstrap",
    "p, Holm", later ? "from 07:00 on, by t" : ""];
  return table(["variant", wordHead("settings"), ...placeHead(), ...head, "pairs", "outside"], rows.map(row => [
    row.variant, words(row.settings.replace(/[^ =]*[.]([^ .=]+=)/g, "$1") || "all together"), ...placeCells(row),
    ...(row.pairs > 0 ? comparisonCells(row, same(row), at) : head.map(() => "")), String(row.pairs), String(row.outside),
  ]));
}

function addComparisons() {
  const title = ({metric, at, reference}) =>
    metricNames[metric] + (at ? " at equal " + lower(metricNames[at]) : "") + ", against " + reference;
  const whole = report.sweep.answers.filter(({metric}) => !metric.endsWith(late));
  if (whole.length > 0) {
    section("Comparisons", element("p", "note", "Relative differences in per cent, pair by pair: the same day, seed and " +
      "faults; plain ones where the reference is 0 somewhere. Coloured where p, of Student's t and adjusted after Holm " +
      "for all rows of the table, is below 0.05; the bootstrap's intervals are too narrow for few days. Outside: pairs " +
      "beyond the reference's front, compared with nothing."),
      ...whole.map(answer => element("div", "card wide narrow", element("h3", "", title(answer)),
        answer.refused ? element("p", "", answer.refused) : comparisonTable(answer))));
  }
}

// What the paper reports of its robust controller against the one without robustness, beside the same of this sweep.
function addPaper() {
  const controllerOf = variant => points().find(point => point.variant === variant).controller;
  const reported = [["unfairness_demand", "−15.78 %"], ["unfairness_charging", "−34.51 %"]];
  const rows = reported.flatMap(([metric, paper]) => report.sweep.answers
    .filter(answer => answer.metric === metric && controllerOf(answer.reference) === "nominal")
    .flatMap(answer => answer.rows.filter(row => controllerOf(row.variant) === "robust" && row.pairs > 0).map(row =>
      [metricNames[metric] + (answer.at ? " at equal " + lower(metricNames[answer.at]) : ""),
        words([row.variant, row.settings, placeWords(row)].filter(Boolean).join(", ")), paper,
        difference(row.by_t, row.relative), range(row.by_t, row.relative)])));
  if (rows.length > 0) {
    section("Beside the paper", element("p", "note", "The paper's method against its rival without robustness, on records " +
      "of Shenzhen that are not public; its total cost fell by 14.49 %."),
      element("div", "card wide", table(["", wordHead("robust"), "paper", "here", "95 % by t"], rows)));
  }
}
