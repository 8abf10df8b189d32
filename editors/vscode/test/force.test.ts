import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { FORCE_COMMANDS, NAME, nameInMenu, question } from "../src/force";
import { watchContext } from "../src/live";

const contributes = JSON.parse(readFileSync("package.json", "utf8")).contributes;

interface Item {
  command: string;
  when: string;
}

function offered(menu: string): Item[] {
  return contributes.menus[menu].filter((it: Item) => it.command in FORCE_COMMANDS);
}

test("a menu asks by the name that the debugger knows", () => {
  assert.equal(nameInMenu({ sessionId: "1", variable: { name: "0 K_CW", evaluateName: "P1IN.0" } }), "P1IN.0");
  assert.equal(nameInMenu({ watch: { port: "P1IN.2" } }), "P1IN.2");
  assert.equal(nameInMenu({ bit: { name: "P0OUT.1" } }), "P0OUT.1");
  assert.equal(nameInMenu({ variable: { name: "[3]" } }), undefined);
  // What the menu of an editor hands over is a place.
  assert.equal(nameInMenu({ path: "/plc/main.plc" } as object), undefined);
  assert.equal(nameInMenu(undefined), undefined);
});

test("who is asked knows what will be done", () => {
  assert.match(question(1), /hold at 1/);
  assert.match(question(0), /hold at 0/);
  assert.match(question(null), /let go/);
});

test("a name is taken from the source with its bit, and without a sign", () => {
  for (const [line, name] of [
    ["-SP_STAND", "SP_STAND"],
    ["P1IN.2", "P1IN.2"],
    ["IP1.B3 ; x", "IP1.B3"],
    ["0", undefined],
  ] as const) {
    assert.equal(NAME.exec(line)?.[0], name, line);
  }
});

test("forcing is offered where there is a bit of a port, while the program runs, too", () => {
  const all = Object.keys(FORCE_COMMANDS).sort();
  for (const menu of ["debug/variables/context", "view/item/context", "editor/context", "commandPalette"]) {
    assert.deepEqual(offered(menu).map((it) => it.command).sort(), all, menu);
  }
  for (const { when } of offered("debug/variables/context")) {
    assert.equal(when, "debugType == 'technol' && debugProtocolVariableMenuContext == 'technolPortBit'");
  }
  for (const { when } of [...offered("editor/context"), ...offered("commandPalette")]) {
    assert.match(when, /debugType == 'technol'/, "without a session there is nothing to force");
  }
  for (const { when } of offered("view/item/context")) {
    const row = new RegExp(/=~ \/(.*)\//.exec(when)?.[1] ?? "nothing");
    assert.ok(row.test(watchContext({ expression: "DOOR", port: "P1IN.2" })) && row.test("technolForced"));
    assert.ok(!row.test(watchContext({ expression: "COUNT" })) && !row.test("technolAllForced"));
  }
});
