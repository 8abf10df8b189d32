// Where the `technol` program is. Nothing here knows the editor, so that it can be tested without one.

import * as path from "node:path";

/** What the search looks at. */
export interface Surroundings {
  /** Setting `technol.path`; empty when it is not set. */
  setting: string;
  /** First workspace folder. */
  workspaceFolder: string | undefined;
  /** The user's folder. */
  home: string;
  /** Value of the environment variable PATH. */
  searchPath: string;
  platform: NodeJS.Platform;
  /** Whether there is a file that can be run. */
  isProgram(file: string): boolean;
}

/** The program, or why there is none and what to do about it. */
export type Binary = { kind: "found"; file: string } | { kind: "missing"; message: string };

/** Finds the program: the one the setting names, or else the first `technol` on the PATH. */
export function findBinary(at: Surroundings): Binary {
  const paths = at.platform === "win32" ? path.win32 : path.posix;
  if (at.setting.trim() !== "") {
    const file = expand(at.setting.trim(), at, paths);
    const candidates = withEnding(file, at.platform);
    const found = paths.isAbsolute(file) ? candidates.find((it) => at.isProgram(it)) : onPath(candidates, at, paths);
    return found !== undefined
      ? { kind: "found", file: found }
      : {
          kind: "missing",
          message: `The setting technol.path says “${at.setting}”, but there is no program ${file}. Correct the setting, or leave it empty to use the technol on the PATH.`,
        };
  }
  const found = onPath(withEnding("technol", at.platform), at, paths);
  return found !== undefined
    ? { kind: "found", file: found }
    : {
        kind: "missing",
        message:
          "The program technol was not found on the PATH. Install it (cargo install --path cli in the TECHNOL sources), or name it in the setting technol.path.",
      };
}

function expand(setting: string, at: Surroundings, paths: path.PlatformPath): string {
  let file = setting;
  if (file === "~" || file.startsWith("~/") || file.startsWith("~\\")) file = paths.join(at.home, file.slice(1));
  if (at.workspaceFolder !== undefined) file = file.replaceAll("${workspaceFolder}", at.workspaceFolder);
  // A path with folders in it is meant from the workspace folder, a bare name from the PATH.
  const hasFolders = file.includes("/") || (at.platform === "win32" && file.includes("\\"));
  if (hasFolders && !paths.isAbsolute(file) && at.workspaceFolder !== undefined) file = paths.join(at.workspaceFolder, file);
  return file;
}

function withEnding(file: string, platform: NodeJS.Platform): string[] {
  return platform === "win32" && !file.toLowerCase().endsWith(".exe") ? [`${file}.exe`, file] : [file];
}

function onPath(names: string[], at: Surroundings, paths: path.PlatformPath): string | undefined {
  for (const folder of at.searchPath.split(paths.delimiter)) {
    // An empty entry or a relative one would mean whatever folder the editor was started in.
    if (!paths.isAbsolute(folder)) continue;
    for (const name of names) {
      const file = paths.join(folder, name);
      if (at.isProgram(file)) return file;
    }
  }
  return undefined;
}
