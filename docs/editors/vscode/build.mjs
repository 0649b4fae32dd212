// Puts into out/ what the extension consists of: extension.js with its
// libraries in one file, and the grammar that all editors share.
import { copyFileSync, mkdirSync } from "node:fs";
import { build } from "esbuild";

mkdirSync("out", { recursive: true });
copyFileSync("../plsc.tmLanguage.json", "out/plsc.tmLanguage.json");
copyFileSync("../../../LICENSE", "LICENSE.txt");
await build({
  entryPoints: ["extension.js"],
  outfile: "out/extension.js",
  bundle: true,
  minify: true,
  platform: "node",
  // The oldest VS Code that package.json admits runs on Node 18.
  target: "node18",
  external: ["vscode"],
});
