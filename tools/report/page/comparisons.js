"use strict";
// Variants of a sweep against one of them, day by day, with intervals; and against what the paper reports.

const signed = (value, digits) => (value > 0 ? "+" : value < 0 ? "−" : "±") + number(Math.abs(value), digits);

// Per cent, or as many digits as tell plain differences apart.
const digitsOf = ({relative, difference}) => {
  const size = Math.max(...difference.filter(Number.isFinite).map(Math.abs));
  return relative || size >= 10 ? 1 : size >= 1 ? 2 : 3;
};
const differenceOf = row => signed((row.relative ? 100 : 1) * row.difference[0], digitsOf(row)) + (row.relative ? " %" : "");
const rangeOf = row => {
  const [, low, high] = row.difference;
  return low === null || high === null ? "not known"
    : [low, high].map(end => signed((row.relative ? 100 : 1) * end, digitsOf(row))).join(" … ");
};

// Less is better of all that is compared; only primary endpoints are judged.
const verdict = row => row.p_holm === null || row.p_holm >= 0.05 ? "" : row.difference[0] < 0 ? "better" : "worse";

const result = (row, text) => element("td", verdict(row), text);

const shareText = share => number(100 * share) + " %";
const costText = ({from, to}) => from === to ? number(from) : number(from) + " … " + number(to);

// The cells of a row of a comparison, and of the same row with what happens before 07:00 left out.
function comparisonCells(row, after, at, judged) {
  return [
    ...(at ? [costText(row)] : []), brief(row.value), brief(row.reference),
    row.of_totals === null ? "" : signed(100 * row.of_totals, 1) + " %",
    result(row, differenceOf(row)), result(row, rangeOf(row)),
    ...(judged ? [row.p_holm === null ? "" : number(row.p_holm, 4)] : []),
    after?.days > 0 ? differenceOf(after) + ", " + rangeOf(after) : "",
  ];
}

function comparisonTable({metric, at, reference, rows}) {
  const later = report.sweep.answers.find(other => other.metric === metric + late && other.reference === reference);
  const keys = ["scenario", "faults", "variant", "settings"];
  const same = row => later?.rows.find(other => keys.every(key => other[key] === row[key]));
  const judged = rows.some(row => row.p_holm !== null);
  const head = [...(at ? [lower(metricNames[at])] : []), lower(metricNames[metric]), reference, "of totals", "difference",
    "95 % by t", ...(judged ? ["p, Holm"] : []), later ? "from 07:00 on" : ""];
  const counts = row => [String(row.days), ...(at ? [String(row.apart), row.inside + " of " + row.points,
    row.from < row.to ? shareText(row.covered) : ""] : [])];
  return table(["variant", wordHead("settings"), ...placeHead(), ...head, "days", ...(at ? ["apart", "inside", "covered"] : [])],
    rows.map(row => [
      row.variant, words(row.settings.replace(/[^ =]*[.]([^ .=]+=)/g, "$1") || "whole front"), ...placeCells(row),
      ...(row.days > 0 ? comparisonCells(row, same(row), at, judged) : head.map(() => "")), ...counts(row),
    ]));
}

function addComparisons() {
  const title = ({metric, at, reference}) =>
    metricNames[metric] + (at ? " at equal " + lower(metricNames[at]) : "") + ", against " + reference;
  const whole = report.sweep.answers.filter(({metric}) => !metric.endsWith(late));
  if (whole.length > 0) {
    section("Comparisons", element("p", "note", "Day by day, on the same seeds and faults; days are the sample. Sums over a " +
      "day in per cent, others as plain differences. Fronts over what both cover, a single setting at its own place on the " +
      "reference's front; inside: points of the variant, counted on each day, that lie there. p stands beside primary " +
      "endpoints of the sweep's page, adjusted after Holm for all of these, and is coloured below 0.05. All other rows are " +
      "exploratory: of twenty intervals one misses on average."),
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
    .flatMap(answer => answer.rows.filter(row => controllerOf(row.variant) === "robust" && row.days > 0).map(row =>
      [metricNames[metric] + (answer.at ? " at equal " + lower(metricNames[answer.at]) : ""),
        words([row.variant, row.settings || "whole front", placeWords(row)].filter(Boolean).join(", ")), paper,
        differenceOf(row), rangeOf(row)])));
  if (rows.length > 0) {
    section("Beside the paper", element("p", "note", "The paper's method against its rival without robustness, on records " +
      "of Shenzhen that are not public; its total cost fell by 14.49 %."),
      element("div", "card wide", table(["", wordHead("robust"), "paper", "here", "95 % by t"], rows)));
  }
}
