import assert from "node:assert/strict";
import { test } from "node:test";
import { initializationOptions, taskArguments } from "../src/commandLine";

test("a task works on its project, or else on the workspace folder", () => {
  assert.deepEqual(taskArguments({ type: "technol", command: "check" }, "/plc"), ["check", "/plc"]);
  assert.deepEqual(taskArguments({ type: "technol", command: "build", project: "lathe" }, "/plc"), ["build", "lathe"]);
});

test("a task with another command is refused", () => {
  const refused = taskArguments({ type: "technol", command: "--help" }, "/plc");
  assert.ok(refused instanceof Error);
  assert.equal(refused.message, "A TECHNOL task can check or build, not “--help”.");
});

test("the server is told the language of help, English when the setting is none it knows", () => {
  assert.deepEqual(initializationOptions({ language: "cs" }), { language: "cs" });
  assert.deepEqual(initializationOptions({ language: "de" }), { language: "en" });
});
