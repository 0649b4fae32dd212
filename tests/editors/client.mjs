// `plsc lsp` as a process, spoken to by vscode-languageserver-protocol: what VS
// Code's own client is made of. Used by the tests here.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { after } from "node:test";
import { join } from "node:path";

const modules = process.env.PLSC_NODE_MODULES;
export const source = process.env.PLSC_SOURCE;
export const required = createRequire(join(modules, "here.js"));
export const lsp = required("vscode-languageserver-protocol/node");

// A test that fails must not leave its server behind.
const servers = [];
after(() => servers.forEach((server) => server.kill()));

// Says initialize; gives the connection, the process and all diagnostics so far.
export async function start(options = {}) {
  const server = spawn(process.env.PLSC, ["lsp", "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
  servers.push(server);
  const connection = lsp.createProtocolConnection(
    new lsp.StreamMessageReader(server.stdout),
    new lsp.StreamMessageWriter(server.stdin),
  );
  const ended = new Promise((resolve) => server.on("exit", resolve));
  const published = [];
  const waiting = [];
  connection.onNotification(lsp.PublishDiagnosticsNotification.type, (params) => {
    published.push(params);
    waiting.splice(0).forEach((look) => look());
  });
  const refreshes = [];
  connection.onRequest(lsp.InlayHintRefreshRequest.type, () => {
    refreshes.push(true);
    return null;
  });
  connection.listen();
  const initialized = await connection.sendRequest(lsp.InitializeRequest.type, {
    processId: process.pid,
    rootUri: null,
    capabilities: {
      workspace: { inlayHint: { refreshSupport: true } },
      textDocument: {
        completion: { completionItem: { snippetSupport: true } },
        documentSymbol: { hierarchicalDocumentSymbolSupport: true },
      },
    },
    initializationOptions: options,
  });
  connection.sendNotification(lsp.InitializedNotification.type, {});
  // The first diagnostics of a version that are as wanted.
  const diagnostics = (uri, version, wanted = () => true) =>
    new Promise((resolve) => {
      const look = () => {
        const found = published.find((one) => one.uri === uri && one.version === version && wanted(one.diagnostics));
        if (found) resolve(found.diagnostics);
        else waiting.push(look);
      };
      look();
    });
  return { connection, server, ended, initialized, diagnostics, refreshes };
}

export async function stop({ connection, ended }) {
  await connection.sendRequest(lsp.ShutdownRequest.type);
  await connection.sendNotification(lsp.ExitNotification.type);
  return ended;
}
