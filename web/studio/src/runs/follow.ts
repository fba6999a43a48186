// SPDX-License-Identifier: MIT
/** Asks for the report of a run again and again until the run has ended. */
import type { RunReport } from "../engine/http";

/** Between two questions [ms], and over the time of an answer: the run needs the processor more than the report does. */
const [shortest, share] = [2000, 2];

interface Listener {
  send: (data: unknown) => void;
  /** `text`: why nothing is shown; empty where something is. */
  tell: (text: string, active: boolean) => void;
}

export function makeFollower(ask: (known: string) => Promise<RunReport>, { send, tell }: Listener) {
  let known = "";
  let turn = 0;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const look = async (own: number) => {
    const begin = performance.now();
    let again = true;
    try {
      const { active, stamp, data, why } = await ask(known);
      if (own !== turn) return;
      if (data !== undefined) {
        known = stamp ?? "";
        send(data);
      }
      tell(known === "" ? (why ?? "") : "", active);
      again = active;
    } catch (error) {
      if (own !== turn) return;
      tell(error instanceof Error ? error.message : String(error), false);
    }
    if (again) timer = setTimeout(() => void look(own), Math.max(shortest, share * (performance.now() - begin)));
  };
  const stop = () => {
    ++turn;
    clearTimeout(timer);
  };
  return {
    /** Also after the page in the frame was loaded anew. */
    start() {
      stop();
      known = "";
      void look(turn);
    },
    stop,
  };
}
