// A robot as a link: its text and scenario, compressed, behind '#r='. A link is
// somebody else's data: whatever it holds becomes text or a word on the page.
import { fromAddress, through, toAddress } from "./packed.js";

const most = 1 << 20; // bytes of text and scenario; a robot has a few thousand

export async function linkOf({ name, text, scenario }) {
  const bytes = new TextEncoder().encode(JSON.stringify({ name, text, scenario }));
  return `#r=${toAddress(await through(new CompressionStream("deflate-raw"), bytes))}`;
}

// {name, text, scenario}; null where the address has no robot; throws an Error
// with a message for people.
export async function robotOfLink(hash) {
  const match = /^#r=(.*)$/s.exec(hash);
  if (!match) return null;
  if (match[1].length > most) throw new Error("The link is too long to be a robot.");
  let robot;
  try {
    const bytes = await through(new DecompressionStream("deflate-raw"), fromAddress(match[1]), most);
    robot = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch (error) {
    if (/^more than/.test(error.message)) throw new Error(`The link holds ${error.message}: too much for a robot.`);
    throw new Error("The link is damaged: it may have been cut off where it was copied from.");
  }
  const isText = (value) => typeof value === "string";
  if (robot === null || typeof robot !== "object" || !isText(robot.text) || !isText(robot.scenario ?? ""))
    throw new Error("The link holds no robot.");
  return {
    name: isText(robot.name) && robot.name ? robot.name.slice(0, 80) : "linked.pls",
    text: robot.text,
    scenario: robot.scenario ?? "",
  };
}
