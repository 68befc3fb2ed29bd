// SPDX-License-Identifier: BSD-3-Clause
// Starts smurf-lsp, shows its pictures, and runs the other tools as commands and tasks.
import * as path from "node:path";
import * as fs from "node:fs";
import { execFile } from "node:child_process";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import { Expansions } from "./expansion";
import { Preview } from "./preview";

let client: LanguageClient | undefined;

/** A program on the path; never in the current folder, where Windows looks first: the opened files lie there. */
function onPath(name: string): string | undefined {
  const file = process.platform === "win32" ? `${name}.exe` : name;
  return (process.env.PATH ?? "").split(path.delimiter)
    .filter((folder) => path.isAbsolute(folder))
    .map((folder) => path.join(folder, file))
    .find((program) => fs.existsSync(program));
}

/** A tool: of the folder in the settings, else that of the extension, else that on the path. */
function toolPath(context: vscode.ExtensionContext, name: string): string {
  const chosen = vscode.workspace.getConfiguration("smurf").get<string>("server.path");
  if (chosen) return path.join(chosen, name);
  const bundled = path.join(context.extensionPath, "bin", name);
  return fs.existsSync(bundled) ? bundled : (onPath(name) ?? bundled);
}

interface Output {
  code: number;
  text: string;
  problems: string;
}

function run(tool: string, words: string[], folder: string | undefined): Promise<Output> {
  return new Promise((resolve) => {
    execFile(tool, words, { cwd: folder, maxBuffer: 1 << 28 }, (error, text, problems) => {
      const code = error === null ? 0 : typeof error.code === "number" ? error.code : 2;
      resolve({ code, text, problems: problems || (code === 2 && error ? error.message : "") });
    });
  });
}

/** The file of the editor, saved; undefined, and said, when there is none. */
async function currentFile(): Promise<string | undefined> {
  const document = vscode.window.activeTextEditor?.document;
  if (document?.uri.scheme !== "file") {
    void vscode.window.showInformationMessage("Open a model or a scene first.");
    return undefined;
  }
  await document.save();
  return document.uri.fsPath;
}

async function showText(content: string, language: string): Promise<void> {
  const document = await vscode.workspace.openTextDocument({ content, language });
  await vscode.window.showTextDocument(document, { preview: true });
}

async function convertToUrdf(context: vscode.ExtensionContext): Promise<void> {
  const file = await currentFile();
  if (file === undefined) return;
  const target = await vscode.window.showSaveDialog({
    defaultUri: vscode.Uri.file(file.replace(/\.\w+$/, ".urdf")),
    filters: { URDF: ["urdf"] },
  });
  if (target === undefined) return;
  const words = ["--apply", "all", "-o", target.fsPath, "--", file];
  const output = await run(toolPath(context, "smurf2urdf"), words, path.dirname(file));
  if (output.code === 0) {
    await vscode.window.showTextDocument(target);
  } else {
    await showText(output.text + output.problems, "plaintext");
  }
}

async function showLosses(context: vscode.ExtensionContext): Promise<void> {
  const file = await currentFile();
  if (file === undefined) return;
  const words = ["--apply", "all", "--loss-report", "-", "-o", "/dev/null", "--", file];
  const output = await run(toolPath(context, "smurf2urdf"), words, path.dirname(file));
  await showText(output.text || output.problems, output.text ? "json" : "plaintext");
}

async function explain(context: vscode.ExtensionContext, given?: string): Promise<void> {
  const word = given ?? await vscode.window.showInputBox({
    prompt: "A rule (SML3101, unknown-joint), a key (motors.maxEffort) or an attribute (limit.effort)",
  });
  if (!word) return;
  const output = await run(toolPath(context, "smurf-lint"), [`--explain=${word}`], undefined);
  await showText(output.text || output.problems, "plaintext");
}

function lintTask(context: vscode.ExtensionContext, words: string[], definition?: vscode.TaskDefinition): vscode.Task {
  return new vscode.Task(
    definition ?? { type: "smurf", arguments: words }, vscode.TaskScope.Workspace, "lint", "smurf",
    new vscode.ProcessExecution(toolPath(context, "smurf-lint"), ["--format", "concise", ...words]), "$smurf-lint");
}

async function startClient(context: vscode.ExtensionContext): Promise<void> {
  const settings = vscode.workspace.getConfiguration("smurf");
  const log = settings.get<string>("server.log");
  client = new LanguageClient("smurf", "SMURF",
    { command: toolPath(context, "smurf-lsp"), args: log ? ["--log", log] : [] },
    {
      documentSelector: [
        ...["smurf", "urdf", "xacro", "yaml"].map((language) => ({ scheme: "file", language })),
        // Launch files and configurations of RViz, which have the languages of other extensions.
        { scheme: "file", pattern: "**/*{.launch,_launch}.{py,xml}" },
        { scheme: "file", pattern: "**/*.{launch,rviz}" },
      ],
      initializationOptions: settings,
      synchronize: { configurationSection: "smurf" },
      middleware: {
        // A page of text is read in an editor; the server only has messages.
        executeCommand: (name, words, next) =>
          name === "smurf.explainRule" ? explain(context, String(words[0])) : next(name, words),
      },
    });
  await client.start();
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const command = (name: string, action: (...words: string[]) => Promise<void>): void => {
    context.subscriptions.push(vscode.commands.registerCommand(`smurf.${name}`, action));
  };
  command("lintWorkspace", async () => {
    await vscode.tasks.executeTask(lintTask(context, ["."]));
  });
  const preview = new Preview(() => client);
  context.subscriptions.push(...preview.subscriptions());
  command("preview", () => preview.open());
  const expansions = new Expansions(() => client);
  context.subscriptions.push(...expansions.subscriptions());
  command("showExpansion", () => expansions.open());
  command("convertToUrdf", () => convertToUrdf(context));
  command("showLosses", () => showLosses(context));
  command("explain", (word) => explain(context, word));
  context.subscriptions.push(vscode.tasks.registerTaskProvider("smurf", {
    provideTasks: () => [lintTask(context, ["."])],
    resolveTask: (task) => lintTask(context, task.definition.arguments as string[], task.definition),
  }));
  await startClient(context);
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}
