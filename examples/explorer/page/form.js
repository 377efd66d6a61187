// The form of a device: a field for each setting that the engine names, with its unit and what the engine expects.

import { element } from './format.js';

// changed(name, text): a field has a new value.
export function make_form(form, changed) {
  let shown = "";
  return {
    // entries: the list of explorer_form(); groups: those to show, in this order.
    show(entries, groups) {
      const key = entries.map(entry => entry.name + (entry.choices || "")).join();
      if (key !== shown) build(entries, groups);
      shown = key;
      for (const entry of entries) {
        const field = form.elements.namedItem(entry.name);
        if (!field || field === document.activeElement) continue;
        if (entry.kind === "bool") field.checked = entry.value === "1" || entry.value === "true";
        else field.value = entry.value;
        field.classList.toggle("changed", entry.value !== entry.default);
      }
    },
  };

  function build(entries, groups) {
    form.replaceChildren(...groups.map(group => {
      const fields = entries.filter(entry => entry.group === group).map(field_of);
      return fields.length ? element("fieldset", {}, element("legend", {text: group}), ...fields) : "";
    }));
  }

  function field_of(entry) {
    const common = {name: entry.name, title: entry.expected, autocomplete: "off"};
    const input = entry.kind === "choice"
      ? element("select", common, ...(entry.choices || []).map(choice => element("option", {value: choice, text: choice.replaceAll("_", " ")})))
      : entry.kind === "bool" ? element("input", {...common, type: "checkbox"})
      : element("input", {...common, type: "text", inputmode: "decimal", spellcheck: "false"});
    input.addEventListener("change", () => changed(entry.name, entry.kind === "bool" ? (input.checked ? "1" : "0") : input.value.trim()));
    return element("label", {class: "field"}, element("span", {text: entry.label.replaceAll("_", " ")}), input, element("span", {class: "unit", text: entry.unit || ""}));
  }

}
