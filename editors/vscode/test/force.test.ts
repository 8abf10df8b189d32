import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { FORCE_COMMANDS, forceRequest } from "../src/force";

const contributes = JSON.parse(readFileSync("package.json", "utf8")).contributes;

test("the menu of a variable asks by the name that evaluates to it", () => {
  const menu = { sessionId: "1", variable: { name: "0 K_CW", evaluateName: "P1IN.0" } };
  assert.deepEqual(forceRequest(menu, 1), { name: "P1IN.0", value: 1 });
  assert.deepEqual(forceRequest(menu, null), { name: "P1IN.0", value: null });
  assert.equal(forceRequest({ variable: { name: "[3]" } }, 0), undefined);
  assert.equal(forceRequest(undefined, 0), undefined);
});

test("forcing is offered in the menu of bits of ports only", () => {
  const offered = contributes.menus["debug/variables/context"];
  assert.deepEqual(offered.map((it: { command: string }) => it.command).sort(), Object.keys(FORCE_COMMANDS).sort());
  for (const { command, when } of offered) {
    assert.equal(when, "debugType == 'technol' && debugProtocolVariableMenuContext == 'technolPortBit'", command);
    // Without a variable it can do nothing.
    const hidden = contributes.menus.commandPalette.find((it: { command: string }) => it.command === command);
    assert.equal(hidden?.when, "false", command);
  }
});
