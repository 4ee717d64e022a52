// Two pages of one source: served, with its engine in a worker, and one file that opens from disk (--mode file).

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const built = here("../build/web");
const wasm = `${built}/web/engine/lesson.wasm`;

/** leadscrew:lesson.wasm as an address or as text, leadscrew:engine as the one or the other way to open it. */
function engine(isFile: boolean): Plugin {
  let isServing = false;
  return {
    name: "leadscrew-engine",
    configResolved: (config) => void (isServing = config.command === "serve"),
    resolveId(id) {
      if (id === "leadscrew:engine") return here(isFile ? "src/engine/inlined.ts" : "src/engine/served.ts");
      return id.startsWith("leadscrew:") ? `\0${id}` : undefined;
    },
    load(id) {
      if (!id.startsWith("\0leadscrew:lesson.wasm")) return undefined;
      if (id.endsWith("?base64")) return `export default ${JSON.stringify(readFileSync(wasm).toString("base64"))}`;
      if (isServing) return `export default ${JSON.stringify(`/@fs${wasm}`)}`;
      const file = this.emitFile({ type: "asset", name: "lesson.wasm", source: readFileSync(wasm) });
      return `export default import.meta.ROLLUP_FILE_URL_${file}`;
    },
  };
}

/** What the page may load: nothing but itself. */
function policy(isFile: boolean): Plugin {
  const own = isFile ? "'unsafe-inline'" : "'self'";
  const rules = [
    "default-src 'none'",
    `script-src ${own} 'wasm-unsafe-eval'`,
    `style-src ${own}`,
    "img-src 'self' data: blob:",
    isFile ? "connect-src 'none'" : "connect-src 'self'",
    isFile ? "worker-src 'none'" : "worker-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ];
  return {
    name: "leadscrew-policy",
    apply: "build",
    transformIndexHtml: () => [
      {
        tag: "meta",
        attrs: { "http-equiv": "Content-Security-Policy", content: rules.join("; ") },
        injectTo: "head-prepend",
      },
    ],
  };
}

/** Script and style into the page itself. */
function oneFile(): Plugin {
  return {
    name: "leadscrew-one-file",
    enforce: "post",
    generateBundle(_, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") throw new Error("there is no page");
      let html = String(page.source);
      for (const [name, part] of Object.entries(bundle)) {
        if (name === "index.html") continue;
        if (part.type === "chunk") {
          const code = part.code.replace(/<\/script/g, "<\\/script");
          html = html
            .replace(new RegExp(`<script[^>]*${part.fileName}[^>]*></script>`), "")
            .replace("</body>", () => `<script type="module">${code}</script></body>`);
        } else if (name.endsWith(".css")) {
          html = html.replace(new RegExp(`<link[^>]*${part.fileName}[^>]*>`), () => `<style>${part.source}</style>`);
        }
        delete bundle[name];
      }
      page.source = html;
      page.fileName = "lesson.html";
    },
  };
}

export default defineConfig(({ mode }) => {
  const isFile = mode === "file";
  return {
    base: "./",
    plugins: [engine(isFile), policy(isFile), ...(isFile ? [oneFile()] : [])],
    worker: { format: "es" },
    build: {
      outDir: `${built}/${isFile ? "file" : "page"}`,
      emptyOutDir: true,
      target: "es2022",
      modulePreload: false,
      ...(isFile ? { rollupOptions: { output: { inlineDynamicImports: true } } } : {}),
    },
  };
});
