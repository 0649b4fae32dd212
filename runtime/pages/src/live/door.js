// Whom the page asks (docs of the requests: runtime/service). A door has
//   ask(request)  a promise of the answer, which never fails: what went wrong
//                 is an answer {ok: false, error} as well;
//   restart()     ends what is being computed; what was asked is answered so;
//   onRestart     called when whoever answers has forgotten all texts.
import { ModuleDoor } from "./module_door.js";
import { ServerDoor } from "./server_door.js";

const nobody = {
  ask: async (request) => ({ ask: request.ask, ok: false, error: "this page has neither a compiler nor a server to ask" }),
  restart() {},
};

export function openDoor(data) {
  if (data.server) return new ServerDoor();
  if (data.module) return new ModuleDoor(data.module);
  return nobody;
}
