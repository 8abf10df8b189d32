import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import * as path from "node:path";
import { before, test } from "node:test";
import { OnigScanner, OnigString, loadWASM } from "vscode-oniguruma";
import { INITIAL, type IGrammar, Registry, parseRawGrammar } from "vscode-textmate";

const GRAMMAR = "syntaxes/technol.tmLanguage.json";
let grammar: IGrammar;

before(async () => {
  const wasm = readFileSync(path.join(path.dirname(require.resolve("vscode-oniguruma")), "onig.wasm"));
  await loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength) as ArrayBuffer);
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new OnigScanner(patterns),
      createOnigString: (text) => new OnigString(text),
    }),
    loadGrammar: async () => parseRawGrammar(readFileSync(GRAMMAR, "utf8"), GRAMMAR),
  });
  const loaded = await registry.loadGrammar("source.technol");
  assert.ok(loaded !== null);
  grammar = loaded;
});

/** Each coloured word of a line with its scope, without the language's name: `LDR keyword.other.mnemonic`. */
function colours(line: string): string[] {
  return grammar
    .tokenizeLine(line, INITIAL)
    .tokens.map((token) => [line.slice(token.startIndex, token.endIndex).trim(), token.scopes.at(-1) ?? ""] as const)
    .filter(([text, scope]) => text !== "" && scope !== "source.technol" && !scope.startsWith("punctuation."))
    .map(([text, scope]) => `${text} ${scope.replace(/\.technol$/, "")}`);
}

test("a statement's word, its operands and its comment are told apart", () => {
  assert.deepEqual(colours("        LDR  -START ; go 'on'"), [
    "LDR keyword.other.mnemonic",
    "- keyword.operator",
    "START variable.other",
    "; go 'on' comment.line.semicolon",
  ]);
  assert.deepEqual(colours(" jl1 done"), ["jl1 keyword.control.flow", "done variable.other"]);
  assert.deepEqual(colours("\tTEX0 -,T_LONG,FAILED"), [
    "TEX0 keyword.control.flow",
    "- keyword.operator",
    "T_LONG variable.other",
    "FAILED variable.other",
  ]);
});

test("labels and declared names are told apart", () => {
  assert.deepEqual(colours("READY:  LDR A"), ["READY entity.name.label", "LDR keyword.other.mnemonic", "A variable.other"]);
  assert.deepEqual(colours("READY:"), ["READY entity.name.label"]);
  assert.deepEqual(colours("SPEED:  DS 2"), ["SPEED variable.other.declaration", "DS storage.type", "2 constant.numeric"]);
  assert.deepEqual(colours("EQUI LIMIT,0FFh"), ["EQUI storage.type", "LIMIT variable.other.constant", "0FFh constant.numeric"]);
  assert.deepEqual(colours("POINT STRUC"), ["POINT variable.other.declaration", "STRUC storage.type"]);
});

test("what opens a block names it", () => {
  assert.deepEqual(colours("MODULE_MAIN"), ["MODULE_MAIN keyword.control.structure"]);
  assert.deepEqual(colours("data_local_end"), ["data_local_end keyword.control.structure"]);
  assert.deepEqual(colours("MECH_BEGIN SPINDLE"), ["MECH_BEGIN keyword.control.structure", "SPINDLE entity.name.class.mechanism"]);
  assert.deepEqual(colours("  PROC_BEGIN COUNT"), ["PROC_BEGIN keyword.control.structure", "COUNT entity.name.function.procedure"]);
});

test("prefixes, system symbols, numbers and texts are coloured as operands", () => {
  assert.deepEqual(colours("  LOD WORD.CELL"), ["LOD keyword.other.mnemonic", "WORD storage.modifier.prefix", "CELL variable.other"]);
  assert.deepEqual(colours("  LOD CNST.-4.8"), [
    "LOD keyword.other.mnemonic",
    "CNST storage.modifier.prefix",
    "- keyword.operator",
    "4.8 constant.numeric",
  ]);
  assert.deepEqual(colours("  LOD P12IN"), ["LOD keyword.other.mnemonic", "P12IN support.variable.system"]);
  assert.deepEqual(colours("NOTE:  STR 8,'it''s; so'"), [
    "NOTE variable.other.declaration",
    "STR storage.type",
    "8 constant.numeric",
    "'it''s; so' string.quoted.single",
  ]);
});

test("a name that is spelled like an instruction, or begins like one, keeps the colour of a name", () => {
  assert.deepEqual(colours("  LDR STOP_LAMP"), ["LDR keyword.other.mnemonic", "STOP_LAMP variable.other"]);
  assert.deepEqual(colours("  LDR EX"), ["LDR keyword.other.mnemonic", "EX variable.other"]);
  assert.deepEqual(colours("LDR_DONE: EX"), ["LDR_DONE entity.name.label", "EX keyword.control.flow"]);
});
