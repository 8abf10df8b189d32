import assert from "node:assert/strict";
import { test } from "node:test";
import { type Surroundings, findBinary } from "../src/binary";

function find(programs: string[], changes: Partial<Surroundings> = {}): string {
  const found = findBinary({
    setting: "",
    workspaceFolder: "/projects/plc",
    home: "/home/eva",
    searchPath: "/usr/bin:/opt/bin",
    platform: "linux",
    isProgram: (file) => programs.includes(file),
    ...changes,
  });
  return found.kind === "found" ? found.file : found.message;
}

test("the first technol on the PATH is taken", () => {
  assert.equal(find(["/opt/bin/technol"]), "/opt/bin/technol");
  assert.equal(find(["/opt/bin/technol", "/usr/bin/technol"]), "/usr/bin/technol");
});

test("relative and empty entries of the PATH are passed over", () => {
  const programs = ["technol", "bin/technol", "/opt/bin/technol"];
  assert.equal(find(programs, { searchPath: ":bin:.:/opt/bin" }), "/opt/bin/technol");
});

test("without a technol the message says how to get one", () => {
  assert.match(find([]), /not found on the PATH\. Install it .* or name it in the setting technol\.path/);
});

test("the setting wins over the PATH, and its variables are replaced", () => {
  for (const [setting, file] of [
    ["/own/technol", "/own/technol"],
    ["~/bin/technol", "/home/eva/bin/technol"],
    ["${workspaceFolder}/target/debug/technol", "/projects/plc/target/debug/technol"],
    ["target/debug/technol", "/projects/plc/target/debug/technol"],
    ["technol-next", "/opt/bin/technol-next"],
    ["  /own/technol ", "/own/technol"],
  ] as const) {
    assert.equal(find([file, "/usr/bin/technol"], { setting }), file, setting);
  }
});

test("a setting that leads nowhere is not silently replaced by the PATH", () => {
  const message = find(["/usr/bin/technol"], { setting: "~/technol" });
  assert.match(message, /technol\.path says “~\/technol”, but there is no program \/home\/eva\/technol\./);
});

test("on Windows the ending .exe is added", () => {
  const windows: Partial<Surroundings> = { platform: "win32", searchPath: "C:\\bin;D:\\plc tools", workspaceFolder: "D:\\plc" };
  assert.equal(find(["D:\\plc tools\\technol.exe"], windows), "D:\\plc tools\\technol.exe");
  assert.equal(find(["D:\\plc\\out\\technol.exe"], { ...windows, setting: "out\\technol" }), "D:\\plc\\out\\technol.exe");
});
