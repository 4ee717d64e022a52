// Four pages, each served, with its engine in a worker, and as one file that opens from disk (--mode lesson, compare, words,
// program).

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { defineConfig, type HtmlTagDescriptor, type Plugin, type Rollup } from "vite";
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

/** Those that a script imports while it runs, and what they import. */
function laterScripts(chunk: Rollup.OutputChunk | undefined, bundle: Rollup.OutputBundle): Set<string> {
  const found = new Set(chunk?.dynamicImports);
  for (const file of found) {
    const part = bundle[file];
    if (part?.type === "chunk") for (const each of part.imports) if (!chunk?.imports.includes(each)) found.add(each);
  }
  return found;
}

/** What a page's first script would ask for later, its engine and the rest of its scripts, is asked for at once. */
function early(): Plugin {
  return {
    name: "leadscrew-early",
    apply: "build",
    enforce: "post",
    transformIndexHtml: {
      order: "post",
      handler: (_, { path, bundle, chunk }) => {
        const wasm = /(program|words)\.html$/.test(path) ? "program.wasm" : "lesson.wasm";
        const engine = Object.values(bundle ?? {}).find((part) => part.type === "asset" && part.names.includes(wasm));
        if (engine === undefined) throw new Error(`there is no ${wasm}`);
        const link = (file: string, attrs: Readonly<Record<string, string>>): HtmlTagDescriptor => ({
          tag: "link",
          attrs: { ...attrs, crossorigin: "", href: `./${file}` },
          injectTo: "head",
        });
        return [
          link(engine.fileName, { rel: "preload", as: "fetch", type: "application/wasm" }),
          ...[...laterScripts(chunk, bundle ?? {})].map((file) => link(file, { rel: "modulepreload" })),
        ];
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
          // Nothing is left to be loaded before a script that is imported late: it is within the page.
          const code = part.code.replaceAll("__VITE_PRELOAD__", "void 0").replace(/<\/script/g, "<\\/script");
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
    plugins: [shell(), engine(isFile), policy(isFile), isFile ? oneFile(file) : early()],
    worker: { format: isFile ? "iife" : "es" },
    server: { fs: { allow: [here("..")] } },
    build: {
      outDir: `${built}/${isFile ? "file" : "page"}`,
      emptyOutDir: file === undefined || file === "lesson",
      target: "es2022",
      modulePreload: isFile ? false : { polyfill: false },
      chunkSizeWarningLimit: 4000,
      rollupOptions: {
        input: inputs.map((name) => here(pages[name].file)),
        output: isFile ? { inlineDynamicImports: true } : {},
      },
    },
  };
});
