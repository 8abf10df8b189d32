import assert from "node:assert/strict";
import { test } from "node:test";
import { addWish, forcedText, selectedLines, toggleLines, traceText, watchText, withErrors } from "../src/live";

test("a watch shows its value, what it was in between, and what is wrong with it", () => {
  assert.equal(watchText({ expression: "A", value: "300 (012Ch)" }), "300 (012Ch)");
  assert.equal(watchText({ expression: "A", value: "5 (05h) ?", stale: true }), "5 (05h) ?");
  assert.equal(watchText({ expression: "A", value: "5", least: "1", greatest: "9" }), "5  1 … 9");
  assert.equal(watchText({ expression: "A", value: "true", rises: 3, falls: 2 }), "true  ↑3 ↓2");
  assert.equal(watchText({ expression: "A", error: "there is no `A`" }), "there is no `A`");
  assert.equal(watchText({ expression: "A" }), "…");
});

test("a traced line that did not run, or may be old, is faint", () => {
  const line = { path: "/a.plc", line: 3 };
  assert.deepEqual(traceText({ ...line, ran: true, value: "RLO 1  DR 5", stale: false }), { text: "RLO 1\u00a0\u00a0DR 5", faint: false });
  assert.deepEqual(traceText({ ...line, ran: true, value: "RLO 1  DR 5 ?", stale: true }), { text: "RLO 1\u00a0\u00a0DR 5 ?", faint: true });
  assert.deepEqual(traceText({ ...line, ran: false, value: "RLO 0  DR 5", stale: false }), { text: "RLO 0\u00a0\u00a0DR 5", faint: true });
  assert.deepEqual(traceText({ ...line, ran: false, value: "has not run" }), { text: "has not run", faint: true });
  assert.deepEqual(traceText(line), { text: "…", faint: true });
  assert.deepEqual(traceText({ ...line, error: "there is no instruction on this line" }), { text: "", faint: true });
});

test("lines without an instruction show nothing", () => {
  const traced = toggleLines([], "/a.plc", [3, 4]);
  const error = "there is no instruction on this line";
  const told = withErrors(traced, [{ path: "/a.plc", line: 3, error: null }, { path: "/a.plc", line: 4, error }]);
  assert.deepEqual(told.map((it) => traceText(it).text), ["…", ""]);
  assert.deepEqual(withErrors(told, [{ path: "/a.plc", line: 4, error: null }]).map((it) => traceText(it).text), ["…", "…"]);
});

test("lines are traced and, chosen again, not any more", () => {
  const some = toggleLines([], "/a.plc", [3, 4]);
  assert.deepEqual(some.map((it) => it.line), [3, 4]);
  const more = toggleLines(some, "/b.plc", [3]);
  assert.equal(more.length, 3);
  assert.deepEqual(toggleLines(more, "/a.plc", [4, 5]).map((it) => `${it.path}:${it.line}`), ["/a.plc:3", "/b.plc:3"]);
});

test("an expression is watched once, in the mode chosen last", () => {
  const one = addWish([], { expression: " COUNT ", mode: "value" });
  const two = addWish(one, { expression: "KEY", mode: "edges" });
  assert.deepEqual(addWish(two, { expression: "count", mode: "extremes" }), [
    { expression: "count", mode: "extremes" },
    { expression: "KEY", mode: "edges" },
  ]);
  assert.deepEqual(addWish(two, { expression: "  ", mode: "value" }), two);
});

test("a forced bit says by whom it is forced, and which value wins", () => {
  const bit = { name: "P1IN.2", symbol: "SP_STAND", value: 0, own: true, both: false } as const;
  assert.equal(forcedText(bit), "SP_STAND forced to 0");
  assert.equal(forcedText({ ...bit, symbol: null, own: false }), "forced to 0 (not by this session)");
  assert.equal(forcedText({ ...bit, both: true }), "SP_STAND forced to 0, which wins over forced to 1");
});

test("a selection that ends in front of a line leaves that line out", () => {
  const lines = (from: number, to: number, character: number) => selectedLines({ start: { line: from }, end: { line: to, character } });
  assert.deepEqual(lines(4, 6, 0), [5, 6]);
  assert.deepEqual(lines(4, 6, 1), [5, 6, 7]);
  assert.deepEqual(lines(4, 4, 0), [5]);
});
