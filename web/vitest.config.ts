// SPDX-License-Identifier: MIT
// Tests of the page: plain Node, no browser (browser/check.mjs has the browser).
import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    environment: "node",
    include: ["tests/**/*.test.{ts,tsx}", "src/**/*.test.{ts,tsx}", "studio/**/*.test.{ts,tsx}"],
    // A large report takes seconds to decode.
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
