// SPDX-License-Identifier: MIT
import preact from "@preact/preset-vite";
import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

// One HTML file with everything in it: it is opened from a disk or a mail, without a network.
export default defineConfig({
  plugins: [preact(), viteSingleFile({ removeViteModuleLoader: true })],
  build: { target: "es2022", outDir: process.env.TALUS_PAGE_DIR ?? "dist", emptyOutDir: true, reportCompressedSize: false },
});
