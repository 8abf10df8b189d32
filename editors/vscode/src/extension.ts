// The extension: starts the language server and the debug adapter, both in the one program `technol`.

import { accessSync, constants, statSync } from "node:fs";
import { homedir } from "node:os";
import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions, type ServerOptions } from "vscode-languageclient/node";
import { type Binary, findBinary } from "./binary";
import { ADAPTER_ARGUMENTS, SERVER_ARGUMENTS, TASK_COMMANDS, type TaskDefinition, initializationOptions, taskArguments } from "./commandLine";
import { complete } from "./debugConfiguration";
import { registerForceMenu } from "./forceMenu";
import { registerLiveViews } from "./liveViews";

/** The running language server and the program it came from. */
let server: { client: LanguageClient; file: string } | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("technol.restartServer", restartServer),
    vscode.commands.registerCommand("technol.showServerVersion", showServerVersion),
    vscode.debug.registerDebugConfigurationProvider("technol", { resolveDebugConfigurationWithSubstitutedVariables: checkConfiguration, resolveDebugConfiguration: fillConfiguration }),
    vscode.debug.registerDebugConfigurationProvider("technol", { provideDebugConfigurations: dynamicConfigurations }, vscode.DebugConfigurationProviderTriggerKind.Dynamic),
    vscode.debug.registerDebugAdapterDescriptorFactory("technol", { createDebugAdapterDescriptor: startAdapter }),
    vscode.tasks.registerTaskProvider("technol", { provideTasks, resolveTask }),
    vscode.workspace.onDidChangeConfiguration(async (event) => {
      if (event.affectsConfiguration("technol.path")) await restartServer();
    }),
  );
  registerLiveViews(context);
  registerForceMenu(context);
  await startServer();
}

export async function deactivate(): Promise<void> {
  await stopServer();
}

function isProgram(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return statSync(file).isFile();
  } catch {
    return false;
  }
}

function binary(): Binary {
  return findBinary({
    setting: vscode.workspace.getConfiguration("technol").get("path", ""),
    workspaceFolder: vscode.workspace.workspaceFolders?.[0]?.uri.fsPath,
    home: homedir(),
    searchPath: process.env.PATH ?? "",
    platform: process.platform,
    isProgram,
  });
}

/** The program's path; without one the user is told, and can go to the setting from there. */
function requireBinary(): string | undefined {
  const found = binary();
  if (found.kind === "found") return found.file;
  const settings = "Open Settings";
  void vscode.window.showErrorMessage(found.message, settings).then((choice) => {
    if (choice === settings) void vscode.commands.executeCommand("workbench.action.openSettings", "technol.path");
  });
  return undefined;
}

async function startServer(): Promise<void> {
  const file = requireBinary();
  if (file === undefined) return;
  // Without a `transport` the client talks over standard input and output and adds no argument of its own.
  const serverOptions: ServerOptions = { command: file, args: SERVER_ARGUMENTS };
  const language = vscode.workspace.getConfiguration("technol").get("language", "en");
  const clientOptions: LanguageClientOptions = {
    documentSelector: [
      { scheme: "file", language: "technol" },
      { scheme: "untitled", language: "technol" },
      // The manifest gets its diagnostics while it is typed.
      { scheme: "file", pattern: "**/technol.toml" },
      // So do the configuration files of the machine, whatever language the editor takes them for.
      { scheme: "file", pattern: "**/*.{ChannelConfig,PlcErrors,PlcConstants,PlcConstans,PlcTDef,PlcT,KbdConfig}" },
    ],
    initializationOptions: initializationOptions({ language }),
  };
  const client = new LanguageClient("technol", "TECHNOL", serverOptions, clientOptions);
  try {
    await client.start();
    server = { client, file };
  } catch (error) {
    await client.dispose().catch(() => undefined);
    void vscode.window.showErrorMessage(`The language server ${file} could not be started: ${String(error)}. Check the setting technol.path.`);
  }
}

async function stopServer(): Promise<void> {
  const running = server;
  server = undefined;
  // A server that has crashed can't be asked to stop; it is gone anyway.
  await running?.client.dispose().catch(() => undefined);
}

async function restartServer(): Promise<void> {
  await stopServer();
  await startServer();
}

async function showServerVersion(): Promise<void> {
  const info = server?.client.initializeResult?.serverInfo;
  if (server === undefined || info === undefined) {
    void vscode.window.showWarningMessage("The TECHNOL language server is not running. Start it with the command “TECHNOL: Restart Language Server”.");
    return;
  }
  void vscode.window.showInformationMessage(`${info.name} ${info.version ?? "(no version)"}: ${server.file}`);
}

function fillConfiguration(folder: vscode.WorkspaceFolder | undefined, given: vscode.DebugConfiguration): vscode.DebugConfiguration | undefined {
  const active = vscode.window.activeTextEditor?.document;
  const activeFile = active?.languageId === "technol" && active.uri.scheme === "file" ? active.uri.fsPath : undefined;
  const workspaceFolder = (folder ?? vscode.workspace.workspaceFolders?.[0])?.uri.fsPath;
  const completed = complete(given, workspaceFolder, activeFile);
  if (!(completed instanceof Error)) return completed as vscode.DebugConfiguration;
  void vscode.window.showErrorMessage(completed.message);
  return undefined;
}

/** Variables are replaced by now; nothing is left to fill in, but there must be a program to debug with. */
function checkConfiguration(_: vscode.WorkspaceFolder | undefined, configuration: vscode.DebugConfiguration): vscode.DebugConfiguration | undefined {
  return requireBinary() === undefined ? undefined : configuration;
}

function dynamicConfigurations(folder: vscode.WorkspaceFolder | undefined): vscode.DebugConfiguration[] {
  const program = folder === undefined ? "${file}" : "${workspaceFolder}";
  return [{ type: "technol", request: "launch", name: "Run on the embedded target", program, target: "embedded" }];
}

function startAdapter(): vscode.DebugAdapterDescriptor | undefined {
  const file = requireBinary();
  return file === undefined ? undefined : new vscode.DebugAdapterExecutable(file, ADAPTER_ARGUMENTS);
}

function provideTasks(): vscode.Task[] {
  const found = binary();
  if (found.kind !== "found") return [];
  return (vscode.workspace.workspaceFolders ?? []).flatMap((folder) =>
    TASK_COMMANDS.flatMap((command) => task({ type: "technol", command }, folder, found.file) ?? []),
  );
}

function resolveTask(given: vscode.Task): vscode.Task | undefined {
  const file = requireBinary();
  const folder = typeof given.scope === "object" ? given.scope : vscode.workspace.workspaceFolders?.[0];
  return file === undefined || folder === undefined ? undefined : task(given.definition as vscode.TaskDefinition & TaskDefinition, folder, file);
}

function task(definition: TaskDefinition, folder: vscode.WorkspaceFolder, file: string): vscode.Task | undefined {
  const given = taskArguments(definition, folder.uri.fsPath);
  if (given instanceof Error) {
    void vscode.window.showErrorMessage(given.message);
    return undefined;
  }
  const execution = new vscode.ProcessExecution(file, given, { cwd: folder.uri.fsPath });
  const made = new vscode.Task(definition, folder, definition.command, "technol", execution, "$technol");
  if (definition.command === "build") made.group = vscode.TaskGroup.Build;
  return made;
}
