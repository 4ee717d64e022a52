// Four pages, each served, with its engine in a worker, and as one file that opens from disk (--mode lesson, compare, words,
// program).

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { defineConfig, type Plugin } from "vite";
import { framed, pages, type PageName } from "./shell";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const built = here("../build/web");
const names = Object.keys(pages) as PageName[];

/** leadscrew:NAME.wasm as an address or as packed text; leadscrew:engine, planner and scene as the one or the other way to open them. */
function engine(isFile: boolean): Plugin {
  let isServing = false;
  const openers: Readonly<Record<string, string>> = {
    "leadscrew:engine": isFile ? "src/engine/inlined.ts" : "src/engine/served.ts",
    "leadscrew:scene": isFile ? "src/program/scene_inlined.ts" : "src/program/scene_served.ts",
    "leadscrew:planner": isFile ? "src/engine/planner_inlined.ts" : "src/engine/planner_served.ts",
  };
  return {
    name: "leadscrew-engine",
    configResolved: (config) => void (isServing = config.command === "serve"),
    resolveId(id) {
      const opener = openers[id];
      if (opener !== undefined) return here(opener);
      return id.startsWith("leadscrew:") ? `\0${id}` : undefined;
    },
    load(id) {
      const [, name, form] = /^\0leadscrew:(\w+\.wasm)\?(\w+)$/.exec(id) ?? [];
      if (name === undefined) return undefined;
      const wasm = `${built}/web/engine/${name}`;
      if (form === "packed")
        return `export default ${JSON.stringify(deflateRawSync(readFileSync(wasm), { level: 9 }).toString("base64"))}`;
      if (isServing) return `export default ${JSON.stringify(`/@fs${wasm}`)}`;
      const file = this.emitFile({ type: "asset", name, source: readFileSync(wasm) });
      return `export default import.meta.ROLLUP_FILE_URL_${file}`;
    },
  };
}

/** Around the scripts that a page's file holds. */
function shell(): Plugin {
  return {
    name: "leadscrew-shell",
    transformIndexHtml: {
      order: "pre",
      handler: (scripts, { path }) => {
        const name = names.find((each) => path.endsWith(pages[each].file));
        return name === undefined ? scripts : framed(name, scripts);
      },
    },
  };
}

/** What a page may load: nothing but itself. The editor of programs writes its style into the page. */
function policy(isFile: boolean): Plugin {
  const rules = (isProgram: boolean, plans: boolean): string[] => [
    "default-src 'none'",
    `script-src ${isFile ? "'unsafe-inline'" : "'self'"} 'wasm-unsafe-eval'`,
    `style-src ${isFile || isProgram ? "'unsafe-inline'" : ""} ${isFile ? "" : "'self'"}`,
    "img-src 'self' data: blob:",
    isFile ? "connect-src 'none'" : "connect-src 'self'",
    isFile ? (plans ? "worker-src blob: data:" : "worker-src 'none'") : "worker-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ];
  return {
    name: "leadscrew-policy",
    apply: "build",
    transformIndexHtml: (_, { path }) => [
      {
        tag: "meta",
        attrs: {
          "http-equiv": "Content-Security-Policy",
          content: rules(path.endsWith(pages.program.file), !/(index|compare)\.html$/.test(path)).join("; "),
        },
        injectTo: "head-prepend",
      },
    ],
  };
}

/** Script and style into the page itself. */
function oneFile(name: PageName): Plugin {
  return {
    name: "leadscrew-one-file",
    enforce: "post",
    generateBundle(_, bundle) {
      const own = pages[name].file;
      const page = bundle[own];
      if (page?.type !== "asset") throw new Error("there is no page");
      let html = String(page.source);
      for (const [file, part] of Object.entries(bundle)) {
        if (file === own) continue;
        if (part.type === "chunk") {
          const code = part.code.replace(/<\/script/g, "<\\/script");
          html = html
            .replace(new RegExp(`<script[^>]*${part.fileName}[^>]*></script>`), "")
            .replace("</body>", () => `<script type="module">${code}</script></body>`);
        } else if (file.endsWith(".css")) {
          html = html.replace(new RegExp(`<link[^>]*${part.fileName}[^>]*>`), () => `<style>${part.source}</style>`);
        }
        delete bundle[file];
      }
      page.source = html.replaceAll('href="./index.html"', 'href="./lesson.html"');
      page.fileName = `${name}.html`;
    },
  };
}

export default defineConfig(({ mode }) => {
  const file = mode in pages ? (mode as PageName) : undefined;
  const isFile = file !== undefined;
  const inputs = file === undefined ? names : [file];
  return {
    base: "./",
    plugins: [shell(), engine(isFile), policy(isFile), ...(isFile ? [oneFile(file)] : [])],
    worker: { format: isFile ? "iife" : "es" },
    server: { fs: { allow: [here("..")] } },
    build: {
      outDir: `${built}/${isFile ? "file" : "page"}`,
      emptyOutDir: file === undefined || file === "lesson",
      target: "es2022",
      modulePreload: false,
      chunkSizeWarningLimit: 4000,
      rollupOptions: {
        input: inputs.map((name) => here(pages[name].file)),
        output: isFile ? { inlineDynamicImports: true } : {},
      },
    },
  };
});
