// SPDX-License-Identifier: BSD-3-Clause
// The robot beside its text: the page of smurfs-flatten in 3D, made by the server from the text as it is in the editor.
import * as vscode from "vscode";
import type { LanguageClient } from "vscode-languageclient/node";

const kDelay = 150; // ms without a key stroke
const kExtensions = /\.(urdf|smurf|smurfs|smurfa|ya?ml|xacro)$/;

interface Problem {
  message: string;
  uri: string;
  range: { start: { line: number; character: number } };
}

/** The answer of the server to `smurf/picture`. */
interface Picture {
  page: string | null;
  problem: Problem | null;
}

/** The data of a page of the viewer. They contain no "<". */
const sceneIn = (page: string): string => /id="scene" [^>]*>([^<]*)/.exec(page)?.[1] ?? "";

/** The symbol with the fewest lines around a position. The tree is that of the robot, and not that of the text. */
function symbolAt(symbols: vscode.DocumentSymbol[], position: vscode.Position): vscode.DocumentSymbol | undefined {
  let found: vscode.DocumentSymbol | undefined;
  for (const symbol of symbols) {
    const below = symbolAt(symbol.children, position);
    for (const one of [below, symbol.range.contains(position) ? symbol : undefined]) {
      if (one && (!found || found.range.contains(one.range))) found = one;
    }
  }
  return found;
}

function findSymbol(symbols: vscode.DocumentSymbol[], name: string): vscode.DocumentSymbol | undefined {
  for (const symbol of symbols) {
    if (symbol.name === name && symbol.kind === vscode.SymbolKind.Class) return symbol;
    const below = findSymbol(symbol.children, name);
    if (below) return below;
  }
  return undefined;
}

async function symbolsOf(uri: vscode.Uri): Promise<vscode.DocumentSymbol[]> {
  const found = await vscode.commands.executeCommand("vscode.executeDocumentSymbolProvider", uri);
  return Array.isArray(found) && "children" in (found[0] ?? {}) ? (found as vscode.DocumentSymbol[]) : [];
}

export class Preview {
  private panel: vscode.WebviewPanel | undefined;
  private uri: vscode.Uri | undefined;
  private problem: Problem | undefined;
  private scene = ""; // the one that is shown, or ""
  private timer: NodeJS.Timeout | undefined;
  private asked = 0; // requests to the server
  private cursorFollows = true;

  constructor(private readonly client: () => LanguageClient | undefined) {}

  /** Shows the model or scene of the active editor. */
  async open(): Promise<void> {
    const document = vscode.window.activeTextEditor?.document;
    if (document?.uri.scheme !== "file" || !kExtensions.test(document.uri.fsPath)) {
      void vscode.window.showInformationMessage("Open a URDF, a model or a scene first.");
      return;
    }
    this.uri = document.uri;
    this.scene = "";
    if (!this.panel) this.makePanel();
    this.panel?.reveal(vscode.ViewColumn.Beside, true);
    await this.refresh();
  }

  /** Connects the panel with edits, and with the cursor. */
  subscriptions(): vscode.Disposable[] {
    return [
      vscode.workspace.onDidChangeTextDocument(() => this.refreshSoon()),
      vscode.workspace.onDidSaveTextDocument(() => this.refreshSoon()),
      vscode.window.onDidChangeTextEditorSelection((event) => void this.follow(event)),
    ];
  }

  private makePanel(): void {
    this.panel = vscode.window.createWebviewPanel(
      "smurf.preview",
      "Robot",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, localResourceRoots: [], retainContextWhenHidden: true },
    );
    this.panel.onDidDispose(() => {
      this.panel = undefined;
      this.scene = "";
      clearTimeout(this.timer);
    });
    this.panel.webview.onDidReceiveMessage((message) => this.receive(message));
  }

  private refreshSoon(): void {
    if (!this.panel) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.refresh(), kDelay);
  }

  private async refresh(): Promise<void> {
    const [client, uri] = [this.client(), this.uri];
    if (!client || !uri) return;
    const number = ++this.asked;
    let picture: Picture;
    try {
      picture = await client.sendRequest<Picture>("smurf/picture", { textDocument: { uri: uri.toString() } });
    } catch (error) {
      picture = { page: null, problem: null };
      void vscode.window.showErrorMessage(`There is no picture of it: ${String(error)}`);
    }
    if (number === this.asked) this.show(picture);
  }

  private show({ page, problem }: Picture): void {
    if (!this.panel || !this.uri) return;
    this.problem = problem ?? undefined;
    if (page && !this.scene) {
      this.panel.title = vscode.workspace.asRelativePath(this.uri, false).split("/").at(-1) ?? "Robot";
      // Its content security policy allows its own script and nothing from outside.
      this.panel.webview.html = page;
      this.scene = sceneIn(page);
      return; // the rest follows when the page is ready
    }
    if (page) {
      const scene = sceneIn(page);
      if (scene !== this.scene) void this.panel.webview.postMessage({ scene });
      this.scene = scene;
    } else if (!this.scene) {
      this.panel.webview.html = `<p>There is no picture yet. ${escape(this.words())}</p>`;
    }
    this.showProblem();
  }

  private words(): string {
    if (!this.problem) return "";
    return `Line ${this.problem.range.start.line + 1}: ${this.problem.message.split("\n")[0]}`;
  }

  private showProblem(): void {
    void this.panel?.webview.postMessage({ problem: this.words() });
  }

  private receive(message: { isReady?: boolean; selected?: string; problem?: boolean }): void {
    if (message.isReady) this.showProblem();
    if (message.problem && this.problem) {
      const { line, character } = this.problem.range.start;
      void this.reveal(vscode.Uri.parse(this.problem.uri), new vscode.Position(line, character));
    }
    if (message.selected !== undefined) void this.goTo(message.selected);
  }

  /** The line of a link that was clicked, in the document or, for a model or scene, in an open URDF. */
  private async goTo(link: string): Promise<void> {
    const open = vscode.window.visibleTextEditors.map((editor) => editor.document.uri);
    for (const uri of [this.uri, ...open]) {
      if (!uri) continue;
      const symbol = findSymbol(await symbolsOf(uri), link);
      if (symbol) return this.reveal(uri, symbol.selectionRange.start);
    }
  }

  private async reveal(uri: vscode.Uri, position: vscode.Position): Promise<void> {
    this.cursorFollows = false; // it would select what was clicked once more
    const shown = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === uri.toString());
    const viewColumn = shown?.viewColumn ?? vscode.ViewColumn.One;
    await vscode.window.showTextDocument(uri, { viewColumn, selection: new vscode.Range(position, position) });
    setTimeout(() => (this.cursorFollows = true), kDelay);
  }

  /** Selects the link around the cursor, or the one that its joint moves. */
  private async follow(event: vscode.TextEditorSelectionChangeEvent): Promise<void> {
    const { document } = event.textEditor;
    if (!this.panel || !this.scene || !this.cursorFollows || !/\.(urdf|xacro)$/.test(document.uri.fsPath)) return;
    const symbol = symbolAt(await symbolsOf(document.uri), event.selections[0].active);
    const isLink = ({ kind }: vscode.DocumentSymbol): boolean => kind === vscode.SymbolKind.Class;
    const link = symbol && (isLink(symbol) ? symbol : symbol.children.find(isLink));
    if (link) void this.panel.webview.postMessage({ select: link.name });
  }
}

function escape(text: string): string {
  return text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);
}
