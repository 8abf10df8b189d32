// Debug configurations: what is left out is filled in, what can't work is refused before anything is started.

/** A debug configuration as launch.json gives it; everything in it can be missing or wrong. */
export interface Configuration {
  type?: unknown;
  request?: unknown;
  name?: unknown;
  [key: string]: unknown;
}

const CHOICES: Record<string, readonly string[]> = {
  clock: ["real", "virtual"],
  build: ["ifStale", "always", "never"],
  download: ["ifStale", "always", "never"],
  onLinkLost: ["runOn", "stayStopped", "stopPlc"],
};

/** The configuration to use, or what is wrong with it. */
export function complete(given: Configuration, workspaceFolder: string | undefined, activeFile: string | undefined): Configuration | Error {
  const configuration: Configuration = { ...given };
  if (configuration.type === undefined && configuration.request === undefined) {
    // F5 without a launch.json.
    Object.assign(configuration, { type: "technol", request: "launch", name: "TECHNOL", target: "embedded" });
  }
  configuration.program ??= workspaceFolder ?? activeFile;
  const problem = findProblem(configuration);
  return problem === undefined ? configuration : new Error(problem);
}

function findProblem(it: Configuration): string | undefined {
  if (it.request !== "launch" && it.request !== "attach") {
    return `The debug configuration's request is “${String(it.request)}”; it can be “launch” or “attach”.`;
  }
  if (typeof it.program !== "string" || it.program === "") {
    return "The debug configuration has no program: give the project folder, its technol.toml, or a .plc file.";
  }
  if (it.request === "attach" && it.target === undefined) {
    return "To attach, the debug configuration needs a target: tcp:HOST:PORT or serial:DEVICE@BAUD.";
  }
  if (it.target !== undefined) {
    const problem = targetProblem(it.target, it.request);
    if (problem !== undefined) return problem;
  }
  for (const [key, values] of Object.entries(CHOICES)) {
    const value = it[key];
    if (value !== undefined && !values.includes(value as string)) {
      return `The debug configuration's ${key} is “${String(value)}”; it can be ${values.join(", ")}.`;
    }
  }
  return undefined;
}

function targetProblem(target: unknown, request: "launch" | "attach"): string | undefined {
  const said = `The debug configuration's target is “${String(target)}”; `;
  if (target === "embedded") {
    return request === "attach" ? "The embedded target lives in the debugger and can't be attached to: launch it." : undefined;
  }
  if (typeof target === "string") {
    const tcp = /^tcp:(.+):(\d+)$/.exec(target);
    if (tcp !== null && Number(tcp[2]) >= 1 && Number(tcp[2]) <= 65535) return undefined;
    if (/^serial:[^@]+(@[1-9]\d*(,rtscts)?)?$/.test(target)) return undefined;
  }
  return `${said}it can be embedded, tcp:HOST:PORT or serial:DEVICE@BAUD.`;
}
