import assert from "node:assert/strict";
import { test } from "node:test";
import { type Configuration, complete } from "../src/debugConfiguration";

function problem(changes: Configuration): string | undefined {
  const completed = complete({ type: "technol", request: "launch", program: "/plc", ...changes }, "/plc", undefined);
  return completed instanceof Error ? completed.message : undefined;
}

test("F5 without a launch.json runs the folder, or the open file, on the embedded target", () => {
  const expected = { type: "technol", request: "launch", name: "TECHNOL", target: "embedded" };
  assert.deepEqual(complete({}, "/plc", "/plc/main.plc"), { ...expected, program: "/plc" });
  assert.deepEqual(complete({}, undefined, "/one.plc"), { ...expected, program: "/one.plc" });
  assert.match((complete({}, undefined, undefined) as Error).message, /has no program/);
});

test("what is given stays as it is", () => {
  const given = { type: "technol", request: "launch", name: "x", program: "/p", clock: "virtual", build: "never", download: "always", stopOnEntry: true };
  assert.deepEqual(complete(given, "/plc", undefined), given);
});

test("every form of target is accepted", () => {
  for (const target of ["embedded", "tcp:127.0.0.1:4711", "tcp:[::1]:1", "serial:/dev/ttyS0@9600", "serial:COM3", "serial:usb:0403:6001:A5@115200,rtscts"]) {
    assert.equal(problem({ target }), undefined, target);
  }
});

test("what can't work is refused with what would", () => {
  for (const [changes, message] of [
    [{ request: "run" }, /request is “run”; it can be “launch” or “attach”/],
    [{ program: 5 }, /has no program/],
    [{ target: "usb" }, /target is “usb”; it can be embedded, tcp:HOST:PORT or serial:DEVICE@BAUD/],
    [{ target: "tcp:host" }, /target is “tcp:host”/],
    [{ target: "tcp:host:70000" }, /target is “tcp:host:70000”/],
    [{ target: "serial:" }, /target is “serial:”/],
    [{ request: "attach" }, /needs a target/],
    [{ request: "attach", target: "embedded" }, /can't be attached to: launch it/],
    [{ clock: "fast" }, /clock is “fast”; it can be real, virtual/],
    [{ build: true }, /build is “true”; it can be ifStale, always, never/],
    [{ download: "maybe" }, /download is “maybe”/],
    [{ target: "serial:COM3@9600,xonxoff" }, /target is “serial:COM3@9600,xonxoff”/],
    [{ onLinkLost: "stop" }, /onLinkLost is “stop”; it can be runOn, stayStopped, stopPlc/],
  ] as const) {
    assert.match(problem(changes) ?? "accepted", message);
  }
});
