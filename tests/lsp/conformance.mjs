// SPDX-License-Identifier: BSD-3-Clause
// Drives every capability of smurf-lsp with the client library of VS Code over files, and writes each
// answer as TypeScript that compiles when the answer is of the type that the protocol gives it.
//
//   node conformance.mjs NODE_MODULES SMURF-LSP ANSWERS.ts FILE...
//
// Answers of one shape are written once: types know nothing of texts and numbers, but for those of
// enumerations.
import { spawn } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [modules, tool, output, ...files] = process.argv.slice(2);
const require = createRequire(path.join(path.resolve(modules), "x.js"));
const lsp = require("vscode-languageserver-protocol/node");

const kEnumerations = new Set(["kind", "severity", "tags", "insertTextFormat", "type", "jsonrpc"]);

/// Everything of a value that its type depends on.
function shape(value, key) {
  if (Array.isArray(value)) {
    return "[" + [...new Set(value.map((one) => shape(one, key)))].sort().join() + "]";
  }
  if (value && typeof value === "object") {
    const members = Object.keys(value).sort();
    if (members.every((name) => name.startsWith("file:"))) {
      return "{*:" + [...new Set(members.map((name) => shape(value[name])))].sort().join() + "}";
    }
    return "{" + members.map((name) => name + ":" + shape(value[name], name)).join() + "}";
  }
  return kEnumerations.has(key) ? JSON.stringify(value) : value === null ? "null" : typeof value;
}

const shapes = new Set();
const lines = ['import type * as lsp from "vscode-languageserver-protocol";'];
let answers = 0;
function note(type, value) {
  answers += 1;
  const seen = type + shape(value);
  if (shapes.has(seen)) return;
  shapes.add(seen);
  lines.push(`export const a${lines.length}: ${type} = ${JSON.stringify(value)};`);
}

const kCapabilities = {
  general: { positionEncodings: ["utf-16"] },
  window: { workDoneProgress: true },
  workspace: {
    workspaceEdit: { documentChanges: true },
    didChangeWatchedFiles: { dynamicRegistration: true },
    workspaceFolders: true,
  },
  textDocument: {
    completion: { completionItem: { snippetSupport: true } },
    documentSymbol: { hierarchicalDocumentSymbolSupport: true },
  },
};

async function connect(folders, capabilities) {
  const server = spawn(tool, [], { stdio: ["pipe", "pipe", "inherit"] });
  const connection = lsp.createProtocolConnection(
    new lsp.StreamMessageReader(server.stdout), new lsp.StreamMessageWriter(server.stdin));
  const published = new Map();
  connection.onNotification("textDocument/publishDiagnostics", (params) => {
    note("lsp.PublishDiagnosticsParams", params);
    published.set(params.uri, params);
  });
  connection.onNotification("window/showMessage", (params) => note("lsp.ShowMessageParams", params));
  connection.onNotification("$/progress", (params) => {
    note("{token: lsp.ProgressToken, value: lsp.WorkDoneProgressBegin | lsp.WorkDoneProgressReport |" +
         " lsp.WorkDoneProgressEnd}", params);
  });
  connection.onRequest("client/registerCapability", (params) => {
    note("lsp.RegistrationParams", params);
    return null;
  });
  connection.onRequest("window/workDoneProgress/create", (params) => {
    note("lsp.WorkDoneProgressCreateParams", params);
    return null;
  });
  connection.listen();
  const initialized = await connection.sendRequest("initialize", {
    processId: process.pid, rootUri: null, capabilities,
    workspaceFolders: folders.map((one) => ({ uri: pathToFileURL(one).href, name: one })),
  });
  note("lsp.InitializeResult", initialized);
  await connection.sendNotification("initialized", {});
  const hasTrees = Boolean(capabilities.textDocument.documentSymbol);
  return { connection, server, published, hasTrees };
}

function place(text, offset) {
  const before = text.slice(0, offset).split("\n");
  return { line: before.length - 1, character: before.at(-1).length };
}

/// Some places in names, values and white space, the same in every run.
function places(text) {
  const found = [0, text.length];
  const names = [...text.matchAll(/(?:name|link|joint|file|filename|rgba|xyz|position)\s*[:=]\s*"?/g)];
  for (let i = 0; i < names.length && found.length < 10; i += Math.max(1, Math.floor(names.length / 4))) {
    found.push(names[i].index + 1, names[i].index + names[i][0].length + 1);
  }
  return found.map((offset) => place(text, Math.min(offset, text.length)));
}

const kOptional = (type) => `${type} | null`;

async function drive(client, file) {
  const text = fs.readFileSync(file, "utf8");
  const uri = pathToFileURL(file).href;
  const textDocument = { uri };
  const whole = { start: { line: 0, character: 0 }, end: place(text, text.length) };
  const ask = async (method, type, params) => {
    try {
      const value = await client.connection.sendRequest(method, { textDocument, ...params });
      note(type, value);
      return value;
    } catch (error) {
      // That a name cannot be changed is an answer as well; that a request fails is none.
      if (!(error instanceof lsp.ResponseError) || error.code !== -32803) throw error;
      return null;
    }
  };
  await client.connection.sendNotification("textDocument/didOpen", {
    textDocument: { uri, languageId: file.endsWith(".urdf") ? "xml" : "yaml", version: 1, text },
  });
  const report = await ask("textDocument/diagnostic", "lsp.DocumentDiagnosticReport", {});
  const context = { diagnostics: report.items ?? [] };
  const actions = await ask("textDocument/codeAction", kOptional("(lsp.Command | lsp.CodeAction)[]"),
    { range: whole, context });
  const command = actions.find((one) => one.command)?.command;
  if (command) {
    note("any", await client.connection.sendRequest("workspace/executeCommand", {
      command: command.command, arguments: command.arguments }));
  }
  for (const position of places(text)) {
    await ask("textDocument/hover", kOptional("lsp.Hover"), { position });
    await ask("textDocument/definition", kOptional("lsp.Definition"), { position });
    await ask("textDocument/references", kOptional("lsp.Location[]"),
      { position, context: { includeDeclaration: true } });
    await ask("textDocument/documentHighlight", kOptional("lsp.DocumentHighlight[]"), { position });
    await ask("textDocument/completion", kOptional("lsp.CompletionList | lsp.CompletionItem[]"), { position });
    const prepared = await ask("textDocument/prepareRename",
      kOptional("lsp.Range | {range: lsp.Range, placeholder: string}"), { position });
    if (prepared) await ask("textDocument/rename", kOptional("lsp.WorkspaceEdit"), { position, newName: "zz_new" });
    await ask("textDocument/selectionRange", kOptional("lsp.SelectionRange[]"), { positions: [position] });
  }
  await ask("textDocument/documentSymbol",
    kOptional(client.hasTrees ? "lsp.DocumentSymbol[]" : "lsp.SymbolInformation[]"), {});
  await ask("textDocument/foldingRange", kOptional("lsp.FoldingRange[]"), {});
  await ask("textDocument/documentLink", kOptional("lsp.DocumentLink[]"), {});
  const boxes = await ask("textDocument/documentColor", "lsp.ColorInformation[]", {});
  for (const box of boxes.slice(0, 2)) {
    await ask("textDocument/colorPresentation", "lsp.ColorPresentation[]", { color: box.color, range: box.range });
  }
  await ask("textDocument/semanticTokens/full", kOptional("lsp.SemanticTokens"), {});
  await ask("textDocument/semanticTokens/range", kOptional("lsp.SemanticTokens"), { range: whole });
  await ask("textDocument/inlayHint", kOptional("lsp.InlayHint[]"), { range: whole });
  note(kOptional("lsp.WorkspaceEdit"), await client.connection.sendRequest("workspace/willRenameFiles", {
    files: [{ oldUri: uri, newUri: uri + ".new" }] }));
  note(kOptional("lsp.SymbolInformation[]"), await client.connection.sendRequest("workspace/symbol", { query: "a" }));
  // A change in the middle, and back.
  const middle = place(text, Math.floor(text.length / 2));
  await client.connection.sendNotification("textDocument/didChange", {
    textDocument: { uri, version: 2 }, contentChanges: [{ range: { start: middle, end: middle }, text: "<x: [" }],
  });
  await ask("textDocument/diagnostic", "lsp.DocumentDiagnosticReport", {});
  await ask("textDocument/completion", kOptional("lsp.CompletionList | lsp.CompletionItem[]"), { position: middle });
  await client.connection.sendNotification("textDocument/didClose", { textDocument });
}

async function run(capabilities) {
  const folders = [...new Set(files.map((file) => path.dirname(file)))];
  const client = await connect(folders.slice(0, 3), capabilities);
  for (const file of files) await drive(client, file);
  note("lsp.WorkspaceDiagnosticReport",
    await client.connection.sendRequest("workspace/diagnostic", { previousResultIds: [] }));
  note("null", await client.connection.sendRequest("shutdown", undefined));
  await client.connection.sendNotification("exit");
  const code = await new Promise((resolve) => client.server.on("exit", resolve));
  if (code !== 0) throw new Error(`the server ended with ${code}`);
}

await run(kCapabilities);
await run({ ...kCapabilities, workspace: {}, textDocument: { diagnostic: { relatedDocumentSupport: true } } });
fs.writeFileSync(output, lines.join("\n") + "\n");
console.log(`${files.length} files, ${answers} answers, ${lines.length - 1} shapes`);
