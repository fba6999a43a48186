// SPDX-License-Identifier: MIT
// Collects what holds and what does not: one line each, all checks run even when an early one fails.

export class Checklist {
  failures = [];
  passed = 0;

  /** Records a check; `detail` is the observed value. */
  expect(holds, what, detail = "") {
    if (holds) ++this.passed;
    else this.failures.push(what);
    console.log(`${holds ? "  ok  " : " FAIL "} ${what}${detail === "" || holds ? "" : `: ${detail}`}`);
    return Boolean(holds);
  }

  /** Runs a group of checks; what it throws (a control that is not there) is a failure of the group. */
  async group(title, run) {
    console.log(title);
    const start = performance.now();
    try {
      await run();
    } catch (error) {
      this.expect(false, title, String(error.message ?? error).split("\n").slice(0, 6).join(" | "));
    }
    this.note(`${((performance.now() - start) / 1000).toFixed(1)} s`);
  }

  /** A number that the log should show, without a limit. */
  note(what) {
    console.log(`       ${what}`);
  }

  /** Prints the verdict and returns the exit status. */
  finish() {
    console.log(`${this.passed} checks hold, ${this.failures.length} fail`);
    for (const failure of this.failures) console.log(`  failed: ${failure}`);
    return this.failures.length === 0 ? 0 : 1;
  }
}
