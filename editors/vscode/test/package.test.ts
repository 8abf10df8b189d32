import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { complete } from "../src/debugConfiguration";
import { FORCE_COMMANDS } from "../src/force";

const contributes = JSON.parse(readFileSync("package.json", "utf8")).contributes;
const technolDebugger = contributes.debuggers[0];

test("every command of the palette is one the extension has", () => {
  const source = ["extension", "liveViews", "forceMenu"].map((name) => readFileSync(`src/${name}.ts`, "utf8")).join("");
  for (const { command } of contributes.commands) {
    assert.ok(source.includes(`registerCommand("${command}"`) || command in FORCE_COMMANDS, command);
  }
});

test("the snippets and the first configuration are ones the extension accepts", () => {
  const snippets = technolDebugger.configurationSnippets.map((it: { body: object }) => it.body);
  for (const body of [...snippets, ...technolDebugger.initialConfigurations]) {
    // ${1:text} stands for its text, ^"…" for what is in it.
    const text = JSON.stringify(body).replace(/\$\{\d+:([^}]*)\}/g, "$1").replace(/"\^\\"(.*?)\\""/g, '"$1"').replaceAll("\\\\$", "$");
    const completed = complete(JSON.parse(text), "/plc", undefined);
    assert.ok(!(completed instanceof Error), `${text}: ${String(completed)}`);
    const { properties } = technolDebugger.configurationAttributes[completed.request as string];
    for (const key of Object.keys(completed)) {
      assert.ok(["type", "request", "name"].includes(key) || key in properties, `${key} is not in the schema`);
    }
    assert.equal(completed.program, "${workspaceFolder}");
    assert.match(completed.target as string, new RegExp(properties.target.pattern));
  }
});

test("the problem matcher reads what `technol check` prints", () => {
  const pattern = contributes.problemPatterns[0];
  const found = new RegExp(pattern.regexp).exec("C:\\plc\\main.plc:12:9: warning T0301: RLO is lost: LDR before EQ");
  assert.ok(found !== null);
  const fields = ["file", "line", "column", "severity", "code", "message"].map((field) => found[pattern[field]]);
  assert.deepEqual(fields, ["C:\\plc\\main.plc", "12", "9", "warning", "T0301", "RLO is lost: LDR before EQ"]);
  assert.equal(new RegExp(pattern.regexp).exec("    main.plc:3:1: first declared here"), null);
});

test("blocks fold in any case, and labels that begin like one don't", () => {
  const { start, end } = JSON.parse(readFileSync("language-configuration.json", "utf8")).folding.markers;
  for (const [line, starts, ends] of [
    ["MODULE_MAIN", true, false],
    ["  module_main_end", false, true],
    ["Mech_Begin X", true, false],
    ["MECH_END X", false, true],
    ["DATA", true, false],
    ["DATA_END", false, true],
    ["DATA:", false, false],
    ["DATABASE", false, false],
    ["; DATA", false, false],
  ] as const) {
    assert.equal(new RegExp(start).test(line), starts, `${line} starts`);
    assert.equal(new RegExp(end).test(line), ends, `${line} ends`);
  }
});
