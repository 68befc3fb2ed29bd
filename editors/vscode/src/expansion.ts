// SPDX-License-Identifier: BSD-3-Clause
// The robot that a xacro makes, as a document beside it that follows its edits, with jumps in both directions.
import * as vscode from "vscode";
import type { LanguageClient } from "vscode-languageclient/node";

const kScheme = "smurf-expansion";
const kDelay = 300; // ms without a key stroke

interface Place {
  uri: string;
  range: vscode.Range;
}

/** The xacro whose expansion a document shows. */
const sourceOf = (uri: vscode.Uri): vscode.Uri => vscode.Uri.parse(uri.query);
/** The document that shows the expansion of a xacro. */
const shownFor = (source: vscode.Uri): vscode.Uri =>
  vscode.Uri.from({ scheme: kScheme, path: source.path.replace(/(\.urdf)?\.xacro$/, ".urdf"), query: source.toString() });

const rangeOf = ({ start, end }: vscode.Range): vscode.Range =>
  new vscode.Range(start.line, start.character, end.line, end.character);

export class Expansions implements vscode.TextDocumentContentProvider, vscode.DefinitionProvider {
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  private readonly texts = new Map<string, string>();
  private timer: NodeJS.Timeout | undefined;
  readonly onDidChange = this.changed.event;

  constructor(private readonly client: () => LanguageClient | undefined) {}

  subscriptions(): vscode.Disposable[] {
    return [
      vscode.workspace.registerTextDocumentContentProvider(kScheme, this),
      vscode.languages.registerDefinitionProvider({ scheme: kScheme }, this),
      vscode.workspace.onDidChangeTextDocument(({ document }) => {
        if (document.languageId === "xacro") this.refreshSoon();
      }),
      vscode.workspace.onDidCloseTextDocument(({ uri }) => this.texts.delete(uri.toString())),
    ];
  }

  /** Shows the expansion of the active editor, at what its cursor made. */
  async open(): Promise<void> {
    const editor = vscode.window.activeTextEditor;
    if (editor?.document.uri.scheme !== "file" || editor.document.languageId !== "xacro") {
      void vscode.window.showInformationMessage("Open a xacro first.");
      return;
    }
    const source = editor.document.uri;
    const places = await this.client()?.sendRequest<vscode.Range[]>("smurf/expansionPlaces", {
      textDocument: { uri: source.toString() },
      position: editor.selection.active,
    });
    const document = await vscode.workspace.openTextDocument(shownFor(source));
    await vscode.languages.setTextDocumentLanguage(document, "urdf");
    await vscode.window.showTextDocument(document, {
      viewColumn: vscode.ViewColumn.Beside,
      selection: places?.length ? rangeOf(places[0]) : undefined,
    });
  }

  async provideTextDocumentContent(uri: vscode.Uri): Promise<string> {
    const source = sourceOf(uri).toString();
    const made = await this.client()?.sendRequest<{ text: string | null }>("smurf/expansion", {
      textDocument: { uri: source },
    });
    // While something is wrong in the xacro, the last robot stays.
    const text = made?.text ?? this.texts.get(uri.toString()) ?? "<!-- The xacro has errors, or makes no robot. -->\n";
    this.texts.set(uri.toString(), text);
    return text;
  }

  /** From the expansion to the xacro. */
  async provideDefinition(document: vscode.TextDocument, position: vscode.Position): Promise<vscode.Location | undefined> {
    const place = await this.client()?.sendRequest<Place | null>("smurf/expansionOrigin", {
      textDocument: { uri: sourceOf(document.uri).toString() },
      position,
    });
    return place ? new vscode.Location(vscode.Uri.parse(place.uri), rangeOf(place.range)) : undefined;
  }

  private refreshSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      for (const { uri } of vscode.workspace.textDocuments) {
        if (uri.scheme === kScheme) this.changed.fire(uri);
      }
    }, kDelay);
  }
}
