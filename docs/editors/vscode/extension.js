// Starts `plsc lsp` for genotypes, and lets one choose the environment that
// hints are about. All else is the language server's.
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

// What the server takes as initializationOptions, and later by
// didChangeConfiguration.
function settings() {
  const { environment, lint } = vscode.workspace.getConfiguration("plsc");
  return { environment, lint };
}

async function pickEnvironment() {
  const editor = vscode.window.activeTextEditor;
  if (!editor || editor.document.languageId !== "pls") {
    vscode.window.showInformationMessage("Open a genotype (.pls) first.");
    return;
  }
  const names = await client.sendRequest("workspace/executeCommand", {
    command: "plsc.listEnvironments",
    arguments: [editor.document.uri.toString()],
  });
  const first = "(each genotype's first)";
  const name = await vscode.window.showQuickPick([first, ...names], {
    placeHolder: "Hints show which rules are active in ...",
  });
  if (name === undefined) return;
  await client.sendRequest("workspace/executeCommand", {
    command: "plsc.chooseEnvironment",
    arguments: [name === first ? "" : name],
  });
}

async function activate(context) {
  const command = vscode.workspace.getConfiguration("plsc").get("path");
  client = new LanguageClient(
    "plsc",
    "plsc",
    { command, args: ["lsp"] },
    {
      documentSelector: [{ language: "pls" }],
      initializationOptions: settings(),
      synchronize: { configurationSection: "plsc" },
    },
  );
  context.subscriptions.push(
    vscode.commands.registerCommand("plsc.pickEnvironment", pickEnvironment),
  );
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(
      `plsc does not start as '${command} lsp' (setting plsc.path): ${error.message}`,
    );
  }
}

function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
