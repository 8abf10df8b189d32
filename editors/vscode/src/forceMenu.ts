// The commands "Force to 0", "Force to 1", "Remove Force" and "Remove All Forces".
//
// VS Code shows no variables of a program that runs, so the menus of the live view and of the editor matter most.

import * as vscode from "vscode";
import { FORCE_COMMANDS, type ForceRequest, type LiveRow, NAME, type VariableMenu, nameInMenu, question } from "./force";

/** Milliseconds for which the answer stays in the status bar; the debug console keeps it. */
const SHOWN = 5000;

export function registerForceMenu(context: vscode.ExtensionContext): void {
  for (const [command, value] of Object.entries(FORCE_COMMANDS)) {
    context.subscriptions.push(
      vscode.commands.registerCommand(command, (menu?: VariableMenu | LiveRow) => force(nameInMenu(menu), value)),
    );
  }
  context.subscriptions.push(
    // The debug console's own command.
    vscode.commands.registerCommand("technol.removeAllForces", () =>
      ask("evaluate", { expression: "unforce all", context: "repl" }, (answer) => String(answer.result)),
    ),
  );
}

async function force(given: string | undefined, value: ForceRequest["value"]): Promise<void> {
  // A machine is forced: a name from the source is asked about before it happens.
  const name = given ?? (await vscode.window.showInputBox({ prompt: question(value), value: nameAtCursor() }))?.trim();
  if (name === undefined || name === "") return;
  const request: ForceRequest = { name, value };
  await ask("technol/force", request, (answer) => String(answer.message));
}

/** The name under the cursor of the editor. */
export function nameAtCursor(): string | undefined {
  const editor = vscode.window.activeTextEditor;
  const range = editor?.document.getWordRangeAtPosition(editor.selection.active, NAME);
  return range === undefined ? undefined : editor?.document.getText(range);
}

async function ask(command: string, request: object, told: (answer: Record<string, unknown>) => string): Promise<void> {
  const session = vscode.debug.activeDebugSession;
  if (session?.type !== "technol") {
    void vscode.window.showWarningMessage("Only bits of ports in a TECHNOL debug session can be forced.");
    return;
  }
  try {
    const answer = (await session.customRequest(command, request)) as Record<string, unknown>;
    vscode.window.setStatusBarMessage(told(answer), SHOWN);
  } catch (error) {
    void vscode.window.showWarningMessage(error instanceof Error ? error.message : String(error));
  }
}
