// What `plsc live` serves, for tests of its page alone: the page, answers of a
// door program (a line of JSON in, a line out), a file that is saved and
// changed. It is told what to do by the test, in the same process.
import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { createInterface } from "node:readline";

const root = "/the-token/";

// A child that answers line by line, in order.
function startDoor([program, ...args]) {
  const child = spawn(program, args, { stdio: ["pipe", "pipe", "inherit"] });
  const waiting = [];
  createInterface({ input: child.stdout }).on("line", (line) => waiting.shift()(line));
  return {
    ask: (line) =>
      new Promise((resolve) => {
        waiting.push(resolve);
        child.stdin.write(`${line}\n`);
      }),
    end: () => child.stdin.end(),
  };
}

function bodyOf(request) {
  return new Promise((resolve) => {
    let text = "";
    request.setEncoding("utf8");
    request.on("data", (piece) => (text += piece));
    request.on("end", () => resolve(text));
  });
}

// `pageOf(data)` gives the page's HTML. What comes back: {url, asked, file,
// change(text), end()}: `asked` has every request, `file` what is saved.
export async function startServer(door, data, pageOf) {
  const answers = startDoor(door);
  const asked = [];
  const listeners = new Set();
  const file = { text: data.robot, version: 1 };
  const served = { ...data, server: data.isJoined ? { file: file.version } : {} };

  async function answer(request, response) {
    const body = await bodyOf(request);
    response.setHeader("Content-Type", "application/json");
    const wanted = JSON.parse(body);
    if (request.url === `${root}ask`) {
      asked.push(wanted);
      return response.end(await answers.ask(body));
    }
    if (wanted.version !== file.version) return response.end(JSON.stringify({ ok: false, conflict: file }));
    file.text = wanted.text;
    ++file.version;
    response.end(JSON.stringify({ ok: true, version: file.version }));
  }

  const server = createServer((request, response) => {
    if (!request.url.startsWith(root)) return response.writeHead(403).end("no token");
    if (request.method === "POST") return void answer(request, response);
    if (request.url.startsWith(`${root}events`)) {
      response.writeHead(200, { "Content-Type": "text/event-stream" }).write(":\n\n");
      listeners.add(response);
      request.on("close", () => listeners.delete(response));
      return;
    }
    response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" }).end(pageOf(served));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}${root}`,
    asked,
    file,
    // As when another program writes the file.
    change(text) {
      file.text = text;
      ++file.version;
      for (const listener of listeners) listener.write(`event: file\ndata: ${JSON.stringify(file)}\n\n`);
    },
    end() {
      answers.end();
      server.closeAllConnections();
      server.close();
    },
  };
}
