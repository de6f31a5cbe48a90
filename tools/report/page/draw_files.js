"use strict";
// Run by Node.js with jsdom: prints the study's figures as a list of the texts of SVG files. Its words are a file with D3
// and the page's drawing scripts, and a file with the figures as JSON.

const {readFileSync} = require("fs");
const {JSDOM} = require("jsdom");
const [scripts, figures] = process.argv.slice(2).map(file => readFileSync(file, "utf8"));
const {window} = new JSDOM("<!DOCTYPE html>", {runScripts: "outside-only"});
window.drawn = JSON.parse(figures);
process.stdout.write(window.eval(scripts + "\nJSON.stringify(drawn.map(studyFile))"));
