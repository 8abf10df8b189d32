// The command lines of the `technol` program, and what goes with them.

/** Arguments that start the language server on standard input and output. */
export const SERVER_ARGUMENTS = ["lsp"];

/** Arguments that start the debug adapter on standard input and output. */
export const ADAPTER_ARGUMENTS = ["dap"];

/** A task of type `technol`, as tasks.json gives it. */
export interface TaskDefinition {
  type: string;
  command: string;
  project?: string;
}

/** Tasks the extension knows by itself. */
export const TASK_COMMANDS = ["check", "build"] as const;

/** Arguments of a task, or why it can't be run. */
export function taskArguments(definition: TaskDefinition, workspaceFolder: string): string[] | Error {
  if (!(TASK_COMMANDS as readonly string[]).includes(definition.command)) {
    return new Error(`A TECHNOL task can ${TASK_COMMANDS.join(" or ")}, not “${definition.command}”.`);
  }
  return [definition.command, definition.project ?? workspaceFolder];
}

/** Options the language server gets at its start. */
export function initializationOptions(settings: { language: string }): { language: string } {
  return { language: settings.language === "cs" ? "cs" : "en" };
}
