/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The case: text is what counts.  A form is made of the table of keys; what is
 * changed there is changed in the text, and the form shows what the text says.
 */
let table = null;           // of `keys`
let entries = [];           // of the case as it is, from the program
let chosen = null;          // section shown: its head, "" for the text

const head = (section, name) => name ? section + " " + name : section;
const textOfCase = () => byId("text").value;

// No expression here may trace back: a hostile line would take minutes.
// Lines of a case: {head, key, value, line}; heads alone have no key.
function parseCase(text) {
  const found = [];
  let at = "";
  text.split("\n").forEach((line, k) => {
    const at_ = line.search(/[#;]/);
    const comment = at_ < 0 ? "" : line.slice(at_);
    const bare = (at_ < 0 ? line : line.slice(0, at_)).trim();
    const equal = bare.indexOf("=");
    if (bare[0] === "[" && bare.endsWith("]")) {
      at = bare.slice(1, -1).trim().split(/\s+/).join(" ");
      found.push({ head: at, line: k });
    } else if (equal > 0) {
      found.push({ head: at, key: bare.slice(0, equal).trim(),
        value: bare.slice(equal + 1).trim(), line: k, comment });
    }
  });
  return found;
}

const valueOf = (where, key) => {
  const all = parseCase(textOfCase()).filter((p) => p.head === where &&
    p.key === key);
  return all.length ? all[all.length - 1].value : null;
};

// Puts a value into the text where it stands, or at the end of its section, or
// takes it out (null); a section that is not there is made.
function setValue(where, key, value) {
  const lines = textOfCase().split("\n"), parsed = parseCase(textOfCase());
  const here = parsed.filter((p) => p.head === where);
  const old = here.filter((p) => p.key === key).pop();
  if (old && value === null) {
    lines.splice(old.line, 1);
  } else if (old) {
    const gap = old.comment ? " ".repeat(Math.max(1, lines[old.line]
      .indexOf(old.comment) - (key + " = " + value).length)) : "";
    lines[old.line] = key + " = " + value + gap + old.comment;
  } else if (value !== null && here.length) {
    lines.splice(here[here.length - 1].line + 1, 0, key + " = " + value);
  } else if (value !== null) {
    while (lines.length && !lines[lines.length - 1].trim()) lines.pop();
    lines.push("", "[" + where + "]", key + " = " + value, "");
  }
  byId("text").value = lines.join("\n");
}

function removeSection(where) {
  const lines = textOfCase().split("\n"), parsed = parseCase(textOfCase());
  const begin = parsed.find((p) => p.head === where && !p.key);
  if (!begin) return;
  const next = parsed.find((p) => !p.key && p.line > begin.line);
  lines.splice(begin.line, (next ? next.line : lines.length) - begin.line);
  byId("text").value = lines.join("\n");
}

// --------------------------------------------------------------- its units

// "300 kN/m" as { number, unit }; null: no single number.
function measured(text) {
  if ((text || "").length > 60) return null;
  const m = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(\S*)$/
    .exec((text || "").trim());
  return m && { number: Number(m[1]), unit: m[2] };
}

const unitsOfKey = (key) => key.units.split(/[;,]\s*/)
  .map((u) => u.split(" with ")[0].trim()).filter(Boolean);

// The unit that the kinds of `init` have for a key, before the first in its
// list.
const usual = {};
function noteUnits(text) {
  for (const p of parseCase(text)) {
    const m = p.key && measured(p.value);
    const name = p.key && p.head.split(" ")[0] + "." + p.key;
    if (m && m.unit && !usual[name]) usual[name] = m.unit;
  }
}

// ---------------------------------------------------------------- the form

function control(key, where, row) {
  const box = element(row, "span", "given");
  const given = valueOf(where, key.key);
  const name = where + "." + key.key;
  const changed = (value) => {
    setValue(where, key.key, value === "" ? null : value);
    changeCase();
  };
  if (key.choices.length && key.type !== "list of words") {
    const list = element(box, "select");
    const none = element(list, "option");
    none.value = "";
    none.textContent = key.initial ? "(" + key.initial + ")" : "";
    for (const word of key.choices) {
      const option = element(list, "option");
      option.value = option.textContent = word;
    }
    if (given && !key.choices.includes(given)) {
      const option = element(list, "option");
      option.value = option.textContent = given;
    }
    list.value = given || "";
    list.onchange = () => changed(list.value);
    list.id = name;
    return list;
  }
  const field = element(box, "input"), units = unitsOfKey(key);
  field.id = name;
  field.placeholder = key.initial || "";
  const value = measured(given);
  if (units.length && (!given || value)) {
    const list = element(box, "select");
    const own = value ? value.unit : "";
    const first = value || !key.initial ? null : measured(key.initial);
    list.setAttribute("aria-label", "unit of " + key.key);
    for (const unit of new Set([...(key.bare || own === "" && value ? [""] : []),
      ...units, ...(own ? [own] : [])])) {
      const option = element(list, "option");
      option.value = unit;
      option.textContent = unit || key.bare || "(none)";
    }
    list.value = value ? own : first && first.unit ? first.unit
      : usual[where.split(" ")[0] + "." + key.key] || list.options[0].value;
    if (list.selectedIndex < 0) list.selectedIndex = 0;
    field.value = value ? String(value.number) : "";
    if (first) field.placeholder = String(first.number);
    field.onchange = () => {
      const typed = field.value.trim();
      changed(!typed ? "" : measured(typed) && !measured(typed).unit
        ? typed + (list.value ? " " + list.value : "") : typed);
    };
    list.onchange = () => { if (field.value.trim()) field.onchange(); };
  } else {
    field.value = given || "";
    field.onchange = () => changed(field.value.trim());
  }
  return field;
}

function explain(key, row, button) {
  const shown = row.querySelector("p");
  button.setAttribute("aria-expanded", String(!shown));
  if (shown) {
    shown.remove();
    return;
  }
  const range = key.minimum === null ? "" : "  From " + key.minimum + " to " +
    key.maximum + (key.units ? " " + unitsOfKey(key)[0] : "") + ".";
  element(row, "p").textContent = key.help + "." +
    (key.initial ? "  Default: " + key.initial + "." : "") + range +
    (key.when ? "  Has an effect with " + key.when + "." : "");
}

const FEW = 9;
let all_ = false; // keys, not only those given
function drawForm() {
  const form = byId("form");
  form.replaceChildren();
  byId("source").hidden = chosen !== "";
  if (chosen === "") return;
  const [section, name] = chosen.split(/ (.*)/);
  const about = table.sections.find((s) => s.name === section);
  if (!about) return;
  element(form, "p", "about").textContent = about.help + ".";
  const used = new Map(entries.filter((e) => e.section === section &&
    (e.name || undefined) === name).map((e) => [e.key, e]));
  const keys = table.keys.filter((k) => k.section === section);
  const given = (key) => valueOf(chosen, key.key) !== null;
  const applies = (key) => !used.has(key.key) || used.get(key.key).applies;
  // A long section shows what the case gives, and the rest when asked.
  const few = keys.length <= FEW || !keys.some(given);
  const shown = keys.filter((k) => given(k) || applies(k) && (few || all_));
  for (const key of shown) {
    const row = element(form, "div", applies(key) ? "key" : "key off");
    const label = element(row, "label");
    label.textContent = key.key;
    control(key, chosen, row);
    label.htmlFor = chosen + "." + key.key;
    const what = element(row, "button", "what");
    what.textContent = "?";
    what.type = "button";
    what.setAttribute("aria-label", "what " + key.key + " is");
    what.setAttribute("aria-expanded", "false");
    what.onclick = () => explain(key, row, what);
    if (!applies(key))
      element(row, "p").textContent = "Has no effect here" +
        (key.when ? ": needs " + key.when : "") + ".";
  }
  const more = keys.filter((k) => !given(k) && applies(k)).length;
  if (!few && more) {
    const button = element(form, "button");
    button.id = "all";
    button.textContent = all_ ? "fewer keys" : more + " more keys";
    button.onclick = () => {
      all_ = !all_;
      drawForm();
      byId("all").focus();
    };
  }
  if (!parseCase(textOfCase()).some((p) => p.head === chosen)) return;
  const remove = element(form, "button");
  remove.textContent = "remove [" + chosen + "]";
  remove.onclick = () => {
    removeSection(chosen);
    chosen = null;
    changeCase();
  };
}

function addSection(list) {
  const about = table.sections.find((s) => s.name === list.value);
  list.value = "";
  if (!about) return;
  let where = about.name;
  const there = parseCase(textOfCase()).map((p) => p.head);
  for (let k = 1; about.named && (k === 1 || there.includes(where)); k++)
    where = about.name + " " + k;
  if (!there.includes(where))
    byId("text").value = textOfCase().replace(/\n*$/, "\n\n[" + where + "]\n");
  chosen = where;
  changeCase();
}

const TABS = 60; // at most: nobody writes more sections
function drawTabs() {
  const tabs = byId("tabs");
  const heads = [...new Set(parseCase(textOfCase()).map((p) => p.head))]
    .filter(Boolean).slice(0, TABS);
  if (!heads.length) heads.push("contact");
  if (chosen !== "" && !heads.includes(chosen)) chosen = heads[0];
  tabs.replaceChildren();
  for (const where of [...heads, ""]) {
    const tab = element(tabs, "button");
    tab.type = "button";
    tab.setAttribute("role", "tab");
    tab.setAttribute("aria-selected", String(where === chosen));
    tab.textContent = where || "as text";
    tab.dataset.section = where;
    tab.onclick = () => {
      chosen = where;
      drawTabs();
      drawForm();
      if (!where) byId("text").focus();
    };
  }
  const more = element(tabs, "select");
  more.id = "more";
  more.setAttribute("aria-label", "add a section");
  const first = element(more, "option");
  first.value = "";
  first.textContent = "+ section";
  for (const s of table.sections) {
    if (!s.named && heads.includes(s.name)) continue;
    const option = element(more, "option");
    option.value = s.name;
    option.textContent = s.name;
    option.title = s.help;
  }
  more.onchange = () => addSection(more);
}

// Numbers beside the text; the line that is wrong stands out.
function drawLines(wrong) {
  const lines = byId("lines");
  const count = textOfCase().split("\n").length;
  const numbers = (from, to) => Array.from({ length: Math.max(0, to - from) },
    (_, k) => from + k + "\n").join("");
  lines.replaceChildren(numbers(1, wrong || count + 1));
  if (wrong) {
    element(lines, "b").textContent = wrong;
    lines.append("\n", numbers(wrong + 1, count + 1));
  }
  byId("text").classList.toggle("wrong", wrong > 0);
  lines.scrollTop = byId("text").scrollTop;
}

// The program's own message, at its line and its field.
let notice = ""; // of the page itself, until the case changes
function showTrouble(message) {
  const text = message || notice;
  const at = /^case\.ini:(\d+): /.exec(text || "");
  const line = at ? Number(at[1]) : 0;
  byId("trouble").hidden = !text;
  byId("trouble").textContent = at ? "line " + line + ": " +
    text.slice(at[0].length) : text || "";
  drawLines(line);
  const pair = parseCase(textOfCase()).find((p) => p.line === line - 1);
  for (const field of document.querySelectorAll("#form .wrong"))
    field.classList.remove("wrong");
  const field = pair && byId(pair.head + "." + pair.key);
  if (field) field.classList.add("wrong");
}
