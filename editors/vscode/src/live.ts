// What a running program shows: values and mechanisms, and the registers behind traced lines. Knows no editor.

/** Something watched, as the debug adapter tells it. */
export interface Watch {
  expression: string;
  value?: string;
  stale?: boolean;
  error?: string;
  least?: string;
  greatest?: string;
  rises?: number;
  falls?: number;
  /** The bit of a port that it is or is a copy of: it can be forced. */
  port?: string;
  /** What that bit is forced to. */
  forced?: 0 | 1 | null;
}

export interface Mechanism {
  name: string;
  path?: string;
  line?: number;
  active?: boolean;
  value: string;
  stale: boolean;
}

/** Body of the event `technol/watch`. */
export interface WatchEvent {
  watches: Watch[];
  mechanisms?: Mechanism[];
}

export interface TracedLine {
  path: string;
  line: number;
  ran?: boolean;
  value?: string;
  stale?: boolean;
  /** Why it cannot be traced: there is no instruction on it. */
  error?: string;
}

/** Body of the event `technol/trace`. */
export interface TraceEvent {
  lines: TracedLine[];
}

/** A bit of a port that is held at a value. */
export interface ForcedBit {
  name: string;
  /** What the program calls it. */
  symbol?: string | null;
  value: 0 | 1;
  /** By this session. */
  own: boolean;
  /** Both masks are set. */
  both: boolean;
}

/** Body of the event `technol/forced`. */
export interface ForcedEvent {
  forced: ForcedBit[];
}

/** The text beside a forced bit. */
export function forcedText(bit: ForcedBit): string {
  const symbol = bit.symbol === undefined || bit.symbol === null ? "" : `${bit.symbol} `;
  const both = bit.both ? ", which wins over forced to 1" : "";
  return `${symbol}forced to ${bit.value}${both}${bit.own ? "" : " (not by this session)"}`;
}

/** What the menu of a watch offers. */
export function watchContext(watch: Watch | undefined): string {
  return watch?.port === undefined || watch.port === null ? "technolWatch" : "technolWatchPort";
}

export const MODES = ["value", "change", "extremes", "edges"] as const;
export type Mode = (typeof MODES)[number];

/** What the user asked to see. */
export interface Wish {
  expression: string;
  mode: Mode;
}

/** The text beside an expression. */
export function watchText(watch: Watch): string {
  if (watch.error !== undefined) return watch.error;
  const extremes = watch.least === undefined ? "" : `  ${watch.least} … ${watch.greatest ?? ""}`;
  const edges = watch.rises === undefined ? "" : `  ↑${watch.rises} ↓${watch.falls ?? 0}`;
  return `${watch.value ?? "…"}${extremes}${edges}`;
}

/** The text behind a traced line; a line that did not run in the last cycle shows what it left behind in grey. */
export function traceText(line: TracedLine): { text: string; faint: boolean } {
  // An editor shows several spaces as one.
  const text = (line.value ?? "…").replaceAll("  ", "\u00a0\u00a0");
  return { text: line.error !== undefined ? "" : text, faint: line.ran !== true || line.stale === true };
}

/** What `technol/trace` answers: lines that cannot be traced have an error. */
export interface TraceAnswer {
  lines: { path: string; line: number; error?: string | null }[];
}

/** The traced lines with what was answered about each. */
export function withErrors(traced: readonly TracedLine[], answered: TraceAnswer["lines"]): TracedLine[] {
  return traced.map((it) => {
    const about = answered.find((line) => line.path === it.path && line.line === it.line);
    return about === undefined ? it : { ...it, error: about.error ?? undefined };
  });
}

/** What VS Code tells of a selection; counted from 0. */
export interface Selected {
  start: { line: number };
  end: { line: number; character: number };
}

/** The lines of a selection, counted from 1. One in front of which it ends is not part of it. */
export function selectedLines({ start, end }: Selected): number[] {
  const last = end.character === 0 && end.line > start.line ? end.line - 1 : end.line;
  return Array.from({ length: last - start.line + 1 }, (_, n) => start.line + n + 1);
}

/** The lines traced after `changed` lines (1-based) of a file were chosen: traced if none of them was, else not. */
export function toggleLines(traced: readonly TracedLine[], path: string, changed: readonly number[]): TracedLine[] {
  const isChosen = (it: TracedLine) => it.path === path && changed.includes(it.line);
  if (traced.some(isChosen)) return traced.filter((it) => !isChosen(it));
  return [...traced, ...changed.map((line) => ({ path, line }))];
}

/** The wishes with one more; one that is there already gets the new mode. */
export function addWish(wishes: readonly Wish[], wish: Wish): Wish[] {
  const expression = wish.expression.trim();
  if (expression === "") return [...wishes];
  const others = wishes.filter((it) => it.expression.toLowerCase() !== expression.toLowerCase());
  return others.length < wishes.length
    ? wishes.map((it) => (others.includes(it) ? it : { expression, mode: wish.mode }))
    : [...wishes, { expression, mode: wish.mode }];
}
