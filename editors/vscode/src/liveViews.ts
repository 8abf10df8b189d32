// The view "Live" of the debug side bar, and the registers behind traced lines in the editor.

import * as vscode from "vscode";
import {
  MODES, addWish, forcedText, selectedLines, toggleLines, traceText, watchContext, watchText, withErrors, type ForcedBit, type ForcedEvent,
  type Mechanism, type Mode, type TraceAnswer, type TraceEvent, type TracedLine, type Watch, type WatchEvent, type Wish,
} from "./live";
import { nameAtCursor } from "./forceMenu";

const WISHES = "technol.live.wishes";
/** Milliseconds between two values. */
const PERIOD = 100;

type Row =
  | { kind: "watch"; wish: Wish; watch?: Watch }
  | { kind: "allForced" }
  | { kind: "forced"; bit: ForcedBit }
  | { kind: "mechanisms" }
  | { kind: "mechanism"; mechanism: Mechanism };

/** Stands before what is only watched, so that names are below each other. */
const WATCHED = new vscode.ThemeIcon("eye");
/** Stands before what is forced. */
const FORCED = new vscode.ThemeIcon("lock", new vscode.ThemeColor("list.warningForeground"));

const MODE_TEXTS: Record<Mode, string> = {
  value: "its value",
  change: "its value, at once when it changes",
  extremes: "its value, and the least and greatest in between",
  edges: "its value, and how often it rises and falls",
};

export function registerLiveViews(context: vscode.ExtensionContext): void {
  const views = new LiveViews(context);
  const tree = vscode.window.createTreeView<Row>("technol.live", { treeDataProvider: views });
  context.subscriptions.push(
    views,
    tree,
    vscode.commands.registerCommand("technol.watchLive", () => views.add()),
    vscode.commands.registerCommand("technol.unwatchLive", (row?: Row) => views.remove(row)),
    vscode.commands.registerCommand("technol.traceLines", () => views.toggleTrace()),
    vscode.commands.registerCommand("technol.stopTrace", () => views.stopTrace()),
    vscode.debug.onDidStartDebugSession((session) => views.start(session)),
    vscode.debug.onDidTerminateDebugSession((session) => views.end(session)),
    vscode.debug.onDidReceiveDebugSessionCustomEvent((event) => views.receive(event)),
    vscode.window.onDidChangeVisibleTextEditors(() => views.decorate()),
  );
}

class LiveViews implements vscode.TreeDataProvider<Row>, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<Row | undefined>();
  readonly onDidChangeTreeData = this.changed.event;
  private readonly decoration = vscode.window.createTextEditorDecorationType({ after: { margin: "0 0 0 3em" } });
  private wishes: Wish[];
  private told: WatchEvent = { watches: [] };
  private forced: ForcedBit[] = [];
  private traced: TracedLine[] = [];
  private session: vscode.DebugSession | undefined;

  constructor(private readonly context: vscode.ExtensionContext) {
    this.wishes = context.workspaceState.get<Wish[]>(WISHES, []);
  }

  dispose(): void {
    this.changed.dispose();
    this.decoration.dispose();
  }

  getChildren(row?: Row): Row[] {
    if (row?.kind === "mechanisms") return (this.told.mechanisms ?? []).map((mechanism) => ({ kind: "mechanism", mechanism }));
    if (row?.kind === "allForced") return this.forced.map((bit) => ({ kind: "forced", bit }));
    if (row !== undefined) return [];
    const watches: Row[] = this.wishes.map((wish, index) => ({ kind: "watch", wish, watch: this.told.watches[index] }));
    if (this.session === undefined) return watches;
    // Whatever else is shown: a machine that does what it is forced to comes first.
    const forced: Row[] = this.forced.length === 0 ? [] : [{ kind: "allForced" }];
    return [...forced, ...watches, { kind: "mechanisms" }];
  }

  getTreeItem(row: Row): vscode.TreeItem {
    if (row.kind === "mechanisms") return new vscode.TreeItem("Mechanisms", vscode.TreeItemCollapsibleState.Expanded);
    if (row.kind === "allForced") {
      const item = new vscode.TreeItem(`Forced: ${this.forced.length}`, vscode.TreeItemCollapsibleState.Expanded);
      item.contextValue = "technolAllForced";
      item.iconPath = FORCED;
      return item;
    }
    if (row.kind === "forced") {
      const item = new vscode.TreeItem(row.bit.name);
      item.description = forcedText(row.bit);
      item.contextValue = "technolForced";
      return item;
    }
    if (row.kind === "watch") {
      const item = new vscode.TreeItem(row.wish.expression);
      item.iconPath = row.watch?.forced === 0 || row.watch?.forced === 1 ? FORCED : WATCHED;
      item.description = row.watch === undefined ? "" : watchText(row.watch);
      item.contextValue = watchContext(row.watch);
      item.tooltip = row.watch?.stale === true ? "The link has lost samples: the value may have changed since." : undefined;
      return item;
    }
    const { name, value, path, line, active } = row.mechanism;
    const item = new vscode.TreeItem(name);
    item.description = value;
    item.iconPath = new vscode.ThemeIcon(active === true ? "play-circle" : "circle-outline");
    if (path !== undefined && line !== undefined) {
      const place = new vscode.Position(line - 1, 0);
      item.command = { command: "vscode.open", title: "Show", arguments: [vscode.Uri.file(path), { selection: new vscode.Range(place, place), preserveFocus: true }] };
    }
    return item;
  }

  /** The word under the cursor, or what the user types. */
  async add(): Promise<void> {
    const expression = await vscode.window.showInputBox({ prompt: "Bit, variable or mechanism to watch while the program runs", value: nameAtCursor() });
    if (expression === undefined || expression.trim() === "") return;
    const mode = await vscode.window.showQuickPick(MODES.map((mode) => ({ label: MODE_TEXTS[mode], mode })), { placeHolder: "What to show" });
    if (mode !== undefined) await this.wish(addWish(this.wishes, { expression, mode: mode.mode }));
  }

  async remove(row?: Row): Promise<void> {
    if (row?.kind === "watch") await this.wish(this.wishes.filter((it) => it.expression !== row.wish.expression));
  }

  private async wish(wishes: Wish[]): Promise<void> {
    this.wishes = wishes;
    // What was told is about the list before.
    this.told = { ...this.told, watches: [] };
    this.changed.fire(undefined);
    await this.context.workspaceState.update(WISHES, wishes);
    await this.subscribe();
  }

  private async subscribe(): Promise<void> {
    await this.ask("technol/subscribe", { watches: this.wishes, mechanisms: true, period: PERIOD });
  }

  async toggleTrace(): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (editor === undefined || editor.document.languageId !== "technol") return;
    // Few enough for the eye; the adapter says which of them can be traced.
    const lines = editor.selections.flatMap(selectedLines);
    await this.trace(toggleLines(this.traced, editor.document.uri.fsPath, [...new Set(lines)]));
  }

  async stopTrace(): Promise<void> {
    await this.trace([]);
  }

  private async trace(lines: TracedLine[]): Promise<void> {
    this.traced = lines;
    this.decorate();
    const answer = await this.ask<TraceAnswer>("technol/trace", { lines: lines.map(({ path, line }) => ({ path, line })) });
    // Answers come in the order of their requests, but the list may be another one by now.
    this.traced = withErrors(this.traced, answer?.lines ?? []);
    this.decorate();
  }

  private async ask<T>(command: string, body: object): Promise<T | undefined> {
    try {
      return (await this.session?.customRequest(command, body)) as T | undefined;
    } catch (error) {
      void vscode.window.showWarningMessage(error instanceof Error ? error.message : String(error));
      return undefined;
    }
  }

  async start(session: vscode.DebugSession): Promise<void> {
    if (session.type !== "technol") return;
    this.session = session;
    this.changed.fire(undefined);
    await this.subscribe();
    if (this.traced.length > 0) await this.trace(this.traced);
  }

  end(session: vscode.DebugSession): void {
    if (session.id !== this.session?.id) return;
    this.session = undefined;
    this.told = { watches: [] };
    this.forced = [];
    this.traced = this.traced.map(({ path, line }) => ({ path, line }));
    this.changed.fire(undefined);
    this.decorate();
  }

  receive(event: vscode.DebugSessionCustomEvent): void {
    if (event.session.id !== this.session?.id) return;
    if (event.event === "technol/watch") {
      const body = event.body as WatchEvent;
      // An event that was on its way while the list changed is about the old one.
      if (body.watches.some((watch, index) => watch.expression !== this.wishes[index]?.expression)) return;
      this.told = body;
      this.changed.fire(undefined);
    } else if (event.event === "technol/forced") {
      this.forced = (event.body as ForcedEvent).forced;
      this.changed.fire(undefined);
    } else if (event.event === "technol/trace") {
      const told = (event.body as TraceEvent).lines;
      this.traced = this.traced.map((it) => told.find((line) => line.path === it.path && line.line === it.line) ?? it);
      this.decorate();
    }
  }

  decorate(): void {
    for (const editor of vscode.window.visibleTextEditors) {
      const lines = this.traced.filter((it) => it.path === editor.document.uri.fsPath && it.line <= editor.document.lineCount);
      editor.setDecorations(this.decoration, this.session === undefined ? [] : lines.map((line) => decoration(editor, line)));
    }
  }
}

function decoration(editor: vscode.TextEditor, line: TracedLine): vscode.DecorationOptions {
  const { text, faint } = traceText(line);
  const colour = new vscode.ThemeColor(faint ? "disabledForeground" : "editorCodeLens.foreground");
  const end = editor.document.lineAt(line.line - 1).range.end;
  return { range: new vscode.Range(end, end), renderOptions: { after: { contentText: text, color: colour } } };
}
