// SPDX-License-Identifier: MIT
/** One request in flight; of those that arrive meanwhile the latest alone is sent next. */
export interface Latest<Input> {
  ask(input: Input): void;
  /** The answer in flight, and any that waits, are dropped. */
  cancel(): void;
  readonly busy: boolean;
}

export function makeLatest<Input, Output>(
  run: (input: Input) => Promise<Output>,
  deliver: (output: Output, input: Input) => void,
  fail: (error: unknown, input: Input) => void,
): Latest<Input> {
  let flying = false;
  let waiting: { input: Input } | null = null;
  let turn = 0;

  const send = async (input: Input) => {
    flying = true;
    const mine = turn;
    try {
      const output = await run(input);
      if (mine === turn) deliver(output, input);
    } catch (error) {
      if (mine === turn) fail(error, input);
    } finally {
      flying = false;
      const next = waiting;
      waiting = null;
      if (next) void send(next.input);
    }
  };

  return {
    ask(input) {
      if (flying) waiting = { input };
      else void send(input);
    },
    cancel() {
      ++turn;
      waiting = null;
    },
    get busy() {
      return flying;
    },
  };
}
