// Light and dark, tables that sort and are saved, texts that are copied.
"use strict";
(function () {
const root = document.documentElement;

// Light or dark: the system's choice until the reader makes one
const theme = document.querySelector(".theme"), system = window.matchMedia("(prefers-color-scheme: dark)");
const kept = { get() { try { return localStorage.getItem("clogflow-theme"); } catch (none) { return null; } },
  set(value) { try { localStorage.setItem("clogflow-theme", value); } catch (none) { /* a page from a disk may not keep anything */ } } };
function dark() { return (root.dataset.theme || (system.matches ? "dark" : "light")) === "dark"; }
function dress() {
  theme.textContent = dark() ? "Light" : "Dark";
  document.dispatchEvent(new Event("dress"));
}
if (kept.get()) root.dataset.theme = kept.get();
theme.hidden = false;
theme.onclick = () => { root.dataset.theme = dark() ? "light" : "dark"; kept.set(root.dataset.theme); dress(); };
system.addEventListener("change", dress);
dress();

// Files of what the page holds
function save(text, name, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
for (const button of document.querySelectorAll(".save"))
  button.onclick = () => save(document.getElementById(button.dataset.of).textContent, button.dataset.name, "text/plain");
for (const button of document.querySelectorAll(".copy"))
  button.onclick = () => {
    const text = document.getElementById(button.dataset.of);
    const say = (word) => { button.textContent = word; setTimeout(() => { button.textContent = "Copy"; }, 1500); };
    const select = () => { const all = document.createRange(); all.selectNodeContents(text); getSelection().removeAllRanges(); getSelection().addRange(all);
      say(document.execCommand("copy") ? "Copied" : "Selected"); };
    if (navigator.clipboard) navigator.clipboard.writeText(text.textContent).then(() => say("Copied"), select); else select();
  };

// Tables
function number(cell) {
  if (cell.dataset.value !== undefined) return +cell.dataset.value;
  const bound = cell.dataset.low !== undefined ? cell.dataset.low : cell.dataset.high;
  const found = bound !== undefined ? bound : (cell.textContent.trim().match(/^[-+−]?\d[\d.]*(e[-+]?\d+)?/) || [""])[0].replace("−", "-");
  return found === "" ? NaN : +found;
}
function sort(table, column, head) {
  const falling = head.getAttribute("aria-sort") === "ascending", body = table.tBodies[0], rows = [...body.rows];
  const text = (row) => row.cells[column].textContent.trim();
  const numeric = rows.filter((row) => !isNaN(number(row.cells[column]))).length > rows.length / 2;
  rows.sort((a, b) => {
    if (!numeric) return text(a).localeCompare(text(b), "en", { numeric: true }) * (falling ? -1 : 1);
    const [x, y] = [number(a.cells[column]), number(b.cells[column])];
    return isNaN(x) || isNaN(y) ? isNaN(x) - isNaN(y) : (x - y) * (falling ? -1 : 1);  // what is no number stays below
  });
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", falling ? "descending" : "ascending");
  body.append(...rows);
}
function csv(table) {
  const rows = [...table.tBodies[0].rows], heads = [...table.tHead.rows[0].cells].map((cell) => cell.textContent.trim());
  const bounds = heads.map((_, k) => rows.some((row) => row.cells[k].dataset.low !== undefined || row.cells[k].dataset.high !== undefined));
  const word = (text) => /[",\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
  const names = heads.flatMap((name, k) => bounds[k] ? [name, name + " low", name + " high", name + " as shown"] : [name]);
  const line = (row) => [...row.cells].flatMap((cell, k) => {
    const shown = cell.textContent.trim(), data = cell.dataset;
    if (!bounds[k]) return [shown];
    const known = data.value !== undefined || data.low !== undefined || data.high !== undefined;
    return [known ? data.value || "" : shown, data.low || "", data.high || "", shown];
  });
  return [names, ...rows.map(line)].map((cells) => cells.map(word).join(",")).join("\n") + "\n";
}
for (const table of document.querySelectorAll("table[data-name]")) {
  [...table.tHead.rows[0].cells].forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = head.textContent || "name";
    if (!head.textContent) button.setAttribute("aria-label", "sort by name");
    head.textContent = "";
    head.appendChild(button);
    button.onclick = () => sort(table, column, head);
  });
  const button = document.createElement("button");
  button.type = "button";
  button.className = "csv";
  button.textContent = "Save as CSV";
  button.onclick = () => save(csv(table), table.dataset.name + ".csv", "text/csv");
  table.parentNode.after(button);
}
window.clogflowCsv = (name) => csv(document.querySelector('table[data-name="' + name + '"]'));
})();
