// Bundles the extension into dist/, or with --tests the tests into out/test.
import { cpSync, existsSync, readdirSync, rmSync } from "node:fs";
import { build } from "esbuild";

const tests = process.argv.includes("--tests");
const folder = tests ? "out/test" : "dist";
rmSync(folder, { recursive: true, force: true });

const entries = tests
  ? readdirSync("test").filter((name) => name.endsWith(".test.ts")).map((name) => `test/${name}`)
  : ["src/extension.ts"];

await build({
  entryPoints: entries,
  outdir: folder,
  bundle: true,
  platform: "node",
  target: "node18",
  format: "cjs",
  minify: !tests,
  // The editor provides the first; the tests load the others from node_modules, one of them reads its own .wasm.
  external: ["vscode", ...(tests ? ["vscode-oniguruma", "vscode-textmate"] : [])],
  logLevel: "warning",
});

if (!tests) {
  for (const licence of ["LICENSE-MIT", "LICENSE-APACHE"]) {
    if (existsSync(`../../${licence}`)) cpSync(`../../${licence}`, `dist/${licence}`);
  }
}
