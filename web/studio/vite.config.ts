// SPDX-License-Identifier: MIT
import preact from "@preact/preset-vite";
import { defineConfig } from "vite";

// A folder of files with relative addresses: it is served by `talus studio`, or lies on any web server. Nothing is inline, so that
// the page works under a Content-Security-Policy that allows its own files alone.
export default defineConfig({
  root: import.meta.dirname,
  base: "./",
  plugins: [preact()],
  worker: { format: "es" },
  build: {
    target: "es2022",
    outDir: process.env.TALUS_STUDIO_DIR ?? "../dist/studio",
    emptyOutDir: process.env.TALUS_STUDIO_DIR === undefined,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    rolldownOptions: { external: [/talus\.js$/] },
  },
});
