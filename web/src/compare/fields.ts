// Labelled fields of a form, each with a line for what is wrong with it.

import { html } from "../ui/dom";

interface Field {
  readonly input: HTMLInputElement | HTMLSelectElement;
  readonly error: HTMLElement;
  readonly row: HTMLElement;
}

export class Fields {
  private readonly fields = new Map<string, Field>();

  /** `id`: of the element; `key`: what `change` is told. */
  text(id: string, label: string, change: (value: string) => void, name = label): HTMLElement {
    const input = html("input", {
      id,
      type: "text",
      autocomplete: "off",
      spellcheck: "false",
      maxlength: 20,
      "aria-describedby": `${id}-error`,
      "aria-label": name,
      input: () => change(input.value),
    });
    return this.field(id, label, input);
  }

  select(
    id: string,
    label: string,
    options: readonly (readonly [string, string])[],
    change: (value: string) => void,
    name = label,
  ): HTMLElement {
    const input = html("select", {
      id,
      "aria-describedby": `${id}-error`,
      "aria-label": name,
      change: () => change(input.value),
    });
    for (const [value, text] of options) input.append(new Option(text, value));
    return this.field(id, label, input);
  }

  private field(id: string, label: string, input: HTMLInputElement | HTMLSelectElement): HTMLElement {
    const error = html("p", { class: "error", id: `${id}-error`, role: "alert" });
    const row = html("div", { class: "field" }, html("label", { for: id }, label), input, error);
    this.fields.set(id, { input, error, row });
    return row;
  }

  /** What stands in it, whether it is there at all, and what is wrong. */
  show(id: string, value: string, isShown: boolean, error = ""): void {
    const field = this.fields.get(id);
    if (field === undefined) return;
    if (field.input.value !== value && document.activeElement !== field.input) field.input.value = value;
    field.row.hidden = !isShown;
    field.error.textContent = error;
    if (error === "") field.input.removeAttribute("aria-invalid");
    else field.input.setAttribute("aria-invalid", "true");
  }
}
