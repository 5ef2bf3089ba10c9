"use strict";
// Tables that sort by a click on their head and filter by text; a cell of a matrix shows how it was computed.

const FILTERED_FROM = 9; // rows from which on a table gets a field to filter

function sortKey(cell) {
  const text = cell ? cell.textContent.trim() : "";
  const number = parseFloat(text.replace(/^[±]/, ""));
  return Number.isNaN(number) ? { text } : { number, text };
}

function compareKeys(one, other) {
  if (one.number !== undefined && other.number !== undefined) return one.number - other.number;
  if (one.number !== undefined) return -1;
  if (other.number !== undefined) return 1;
  return one.text.localeCompare(other.text);
}

function sortable(table) {
  if (!table.tHead || table.tBodies[0].rows.length < 2) return;
  for (const head of table.tHead.rows[0].cells) {
    if (head.querySelector("button") || !head.textContent.trim()) continue;
    const button = element("button", { type: "button", class: "sort", title: "sort by this column" });
    button.append(...head.childNodes);
    button.addEventListener("click", () => sortBy(table, head));
    head.append(button);
  }
}

function sortBy(table, head) {
  const falls = head.getAttribute("aria-sort") === "ascending", body = table.tBodies[0], at = head.cellIndex;
  for (const one of table.tHead.rows[0].cells) one.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", falls ? "descending" : "ascending");
  const rows = [...body.rows].map((row) => ({ row, key: sortKey(row.cells[at]) }));
  rows.sort((one, other) => (falls ? -1 : 1) * compareKeys(one.key, other.key));
  body.append(...rows.map((one) => one.row));
}

function filterable(table) {
  if (!table.tHead || table.tBodies[0].rows.length < FILTERED_FROM) return;
  const caption = table.caption ? table.caption.textContent : "table";
  const field = element("input", { type: "search", class: "filter", placeholder: "filter rows", "aria-label": `filter rows: ${caption.slice(0, 60)}` });
  field.addEventListener("input", () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of table.tBodies[0].rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every((word) => text.includes(word));
    }
  });
  (table.closest(".scroll") || table).before(field);
}

// The row of the calculation that a link of a matrix leads to: same criterion, in the tables under the link's target.
function traceOf(link) {
  const target = document.getElementById(decodeURIComponent(link.hash.slice(1)));
  if (!target) return null;
  const cell = link.closest("td"), table = link.closest("table");
  const heading = table.tHead.rows[0].cells[cell.cellIndex].textContent.trim();
  const rows = [...target.querySelectorAll("tbody tr")];
  const named = rows.filter((row) => heading.startsWith(row.cells[0].textContent.trim()) || heading.includes(row.cells[0].textContent.trim()));
  const row = named.sort((one, other) => other.cells[0].textContent.length - one.cells[0].textContent.length)[0];
  if (row) return { heads: [...row.closest("table").tHead.rows[0].cells].map((one) => one.textContent.trim()), cells: [...row.cells].map((one) => one.textContent.trim()) };
  if (!rows.length) return null;
  return { heads: rows.map((one) => one.cells[0].textContent.trim()), cells: rows.map((one) => (one.cells[1] ? one.cells[1].textContent.trim() : "")) };
}

function startTraces() {
  const shown = element("div", { id: "calculation", role: "tooltip", hidden: "" });
  document.body.append(shown);
  const show = (event) => {
    const link = event.target.closest && event.target.closest('td a[href^="#"]');
    const found = link && traceOf(link);
    if (!found) { shown.hidden = true; return; }
    const list = found.cells.flatMap((text, at) => (text ? [element("dt", { text: found.heads[at] }), element("dd", { text })] : []));
    shown.replaceChildren(element("dl", {}, ...list));
    shown.hidden = false;
    link.setAttribute("aria-describedby", "calculation");
    const box = link.getBoundingClientRect(), room = document.documentElement.clientWidth;
    shown.style.left = `${Math.max(8, Math.min(box.left, room - shown.offsetWidth - 8)) + scrollX}px`;
    shown.style.top = `${box.bottom + 6 + scrollY}px`;
  };
  document.addEventListener("mouseover", show);
  document.addEventListener("focusin", show);
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") shown.hidden = true; });
}

function startTables() {
  for (const table of document.querySelectorAll("table")) { sortable(table); filterable(table); }
  startTraces();
}
