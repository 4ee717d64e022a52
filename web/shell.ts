// What every page of the workbench has around its content: head, heading, the ways to the others, and the keys. A page's own file
// holds its scripts alone.

interface PageShell {
  readonly file: string;
  /** Behind "Leadscrew workbench: ", and what the page is called where it is led to. */
  readonly title: string;
  readonly name: string;
  readonly heading: string;
  /** What Tab skips to: "To the …". */
  readonly content: string;
  readonly keys: string;
  /** The page of the workbench that it belongs to, where it is not one of its own. */
  readonly of?: string;
}

const laneKeys =
  "<kbd>←</kbd> <kbd>→</kbd> a clock back or on · <kbd>Home</kbd> <kbd>End</kbd> first or last clock · " +
  "<kbd>Space</kbd> run or pause, where no control has the focus. On the paths: arrows move, <kbd>+</kbd> " +
  "<kbd>−</kbd> nearer and farther, <kbd>0</kbd> the whole curve";

const lanes = { heading: "Methods beside one another, on one clock", content: "comparison", keys: laneKeys } as const;

export const pages = {
  lesson: {
    file: "index.html",
    title: "lesson",
    name: "Lesson",
    heading: "Reference pulses, cycle by cycle",
    content: "lesson",
    keys:
      "<kbd>←</kbd> <kbd>→</kbd> a cycle back or on · <kbd>Home</kbd> <kbd>End</kbd> first or last cycle · " +
      "<kbd>Space</kbd> run or pause, where no control has the focus",
  },
  compare: { ...lanes, file: "compare.html", title: "compare", name: "Compare" },
  words: { ...lanes, file: "words.html", title: "words beside one another", name: "Words and pulses", of: "compare" },
  program: {
    file: "program.html",
    title: "program",
    name: "Program",
    heading: "What a part program does, and where its time goes",
    content: "program",
    keys:
      "<kbd>Space</kbd> play or pause · <kbd>←</kbd> <kbd>→</kbd> a period back or on, with <kbd>Shift</kbd> a " +
      "hundred · <kbd>Home</kbd> <kbd>End</kbd> begin and end, where no control has the focus. On the path: arrows " +
      "turn, with <kbd>Shift</kbd> move, <kbd>+</kbd> <kbd>−</kbd> nearer and farther, <kbd>0</kbd> all of it. In the " +
      "program, <kbd>Esc</kbd> then <kbd>Tab</kbd> leaves it",
  },
} as const satisfies Readonly<Record<string, PageShell>>;
export type PageName = keyof typeof pages;

const all: Readonly<Record<PageName, PageShell>> = pages;

function link(to: PageShell, text: string, current?: "page" | "true"): string {
  return `<a href="./${to.file}"${current === undefined ? "" : ` aria-current="${current}"`}>${text}</a>`;
}

function ways(name: PageName): string {
  const { compare, words } = all;
  const isOf = (page: PageName): boolean => all[name].of === page;
  const main = (["lesson", "compare", "program"] as const).map((each) =>
    link(all[each], all[each].name, each === name ? "page" : isOf(each) ? "true" : undefined),
  );
  const current = (page: PageName): "page" | undefined => (page === name ? "page" : undefined);
  const compared = [link(compare, "Pulses", current("compare")), link(words, words.name, current("words"))];
  const isCompared = name === "compare" || isOf("compare");
  return `${isCompared ? `<nav class="modes" aria-label="What is compared">${compared.join(" ")}</nav>` : ""}
        <nav class="modes" aria-label="Workbench">${main.join(" ")}</nav>`;
}

/** A whole page, with these scripts. */
export function framed(name: PageName, scripts: string): string {
  const { title, heading, content, keys } = all[name];
  return `<!doctype html>
<html lang="en" data-theme="auto">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>Leadscrew workbench: ${title}</title>
    <link rel="icon" href="data:," />
  </head>
  <body>
    <a class="skip" href="#content">To the ${content}</a>
    <header class="page-head">
      <div>
        <p class="brand">Leadscrew</p>
        <h1>${heading}</h1>
      </div>
      <div class="page-tools">
        ${ways(name)}
      </div>
    </header>
    <main id="content" tabindex="-1"><p class="loading" role="status">Loading the engine</p></main>
    <footer class="page-foot">
      <details>
        <summary>Keys</summary>
        <p>${keys}</p>
      </details>
    </footer>
    ${scripts}
  </body>
</html>
`;
}
