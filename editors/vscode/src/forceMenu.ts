// The commands "Force to 0", "Force to 1" and "Remove Force" in the menu of a variable.

import * as vscode from "vscode";
import { FORCE_COMMANDS, type ForceRequest, type VariableMenu, forceRequest } from "./force";

/** Milliseconds for which the answer stays in the status bar; the debug console keeps it. */
const SHOWN = 5000;

export function registerForceMenu(context: vscode.ExtensionContext): void {
  for (const [command, value] of Object.entries(FORCE_COMMANDS)) {
    context.subscriptions.push(vscode.commands.registerCommand(command, (menu?: VariableMenu) => force(menu, value)));
  }
}

async function force(menu: VariableMenu | undefined, value: ForceRequest["value"]): Promise<void> {
  const session = vscode.debug.activeDebugSession;
  const request = forceRequest(menu, value);
  if (session?.type !== "technol" || request === undefined) {
    void vscode.window.showWarningMessage("Only bits of ports in a TECHNOL debug session can be forced.");
    return;
  }
  try {
    const answer = (await session.customRequest("technol/force", request)) as { message: string };
    vscode.window.setStatusBarMessage(answer.message, SHOWN);
  } catch (error) {
    void vscode.window.showWarningMessage(error instanceof Error ? error.message : String(error));
  }
}
