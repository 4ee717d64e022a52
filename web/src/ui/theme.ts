// Light or dark: as the system has it, or as the reader says.

export type Theme = "auto" | "light" | "dark";
const key = "leadscrew.theme";

function kept(): Theme {
  try {
    const theme = localStorage.getItem(key);
    return theme === "light" || theme === "dark" ? theme : "auto";
  } catch {
    return "auto"; // a page from disk may have no store
  }
}

export function themeSwitch(onChange: () => void): HTMLElement {
  const select = document.createElement("select");
  select.setAttribute("aria-label", "Colours");
  for (const [value, text] of [
    ["auto", "System"],
    ["light", "Light"],
    ["dark", "Dark"],
  ] as const)
    select.append(new Option(text, value));
  const apply = (theme: Theme): void => {
    document.documentElement.dataset["theme"] = theme;
    known.clear();
    onChange();
  };
  select.value = kept();
  apply(kept());
  select.addEventListener("change", () => {
    try {
      localStorage.setItem(key, select.value);
    } catch {
      // for this visit only, then
    }
    apply(select.value as Theme);
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    known.clear();
    onChange();
  });
  return select;
}

const known = new Map<string, string>();

/** Of the page's style, for pictures. */
export function colour(name: string): string {
  let value = known.get(name);
  if (value === undefined) {
    value = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    known.set(name, value);
  }
  return value;
}
