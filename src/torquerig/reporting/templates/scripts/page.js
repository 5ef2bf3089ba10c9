"use strict";
// Sections that open when a link leads into them and for print, and downloads of pictures.

function save(name, blob) {
  const link = element("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000); // a busy browser starts to read late
}

async function savePicture(figure, kind) {
  const image = figure.querySelector("img"), name = figure.id || "picture";
  if (kind === "csv") { save(`${name}.csv`, new Blob([await csvOf(figure)], { type: "text/csv" })); return; }
  if (kind === "svg") {
    const bytes = Uint8Array.from(atob(image.src.split(",")[1]), (one) => one.charCodeAt(0));
    save(`${name}.svg`, new Blob([bytes], { type: "image/svg+xml" }));
    return;
  }
  const drawn = new Image();
  drawn.src = image.src;
  await drawn.decode();
  const canvas = element("canvas", { width: 2 * drawn.naturalWidth, height: 2 * drawn.naturalHeight });
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(drawn, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((blob) => save(`${name}.png`, blob), "image/png");
}

async function csvOf(figure) {
  const table = figure.querySelector("script.csv");
  if (table) return JSON.parse(table.textContent);
  const host = figure.querySelector("[data-plot]");
  const { data, curves } = plotsOnPage.has(host.id) ? await plotsOnPage.get(host.id) : await plotData(host.id);
  const names = Object.keys(curves).filter((name) => !(name in data.differences)), first = curves[names[0]];
  const lines = [[data.x, ...names.map((name) => (data.unit ? `${name} [${data.unit}]` : name))].join(",")];
  for (let at = 0; at < first.values.length; at += 1) {
    lines.push([Number((first.start + at * first.step).toPrecision(10)), ...names.map((name) => Number(curves[name].values[at].toPrecision(7)))].join(","));
  }
  return `${lines.join("\n")}\n`;
}

function openTarget() {
  const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  if (target.tagName === "DETAILS") target.open = true;
  for (let at = target.closest("details"); at; at = at.parentElement.closest("details")) at.open = true;
  target.scrollIntoView();
}

function startPage() {
  startTables();
  if (typeof startMatrices === "function") startMatrices();
  if (typeof startSweep === "function") startSweep();
  if (typeof startPlots === "function") startPlots();
  for (const figure of document.querySelectorAll("figure")) {
    for (const button of figure.querySelectorAll("[data-save]")) button.addEventListener("click", () => savePicture(figure, button.dataset.save));
  }
  for (const button of document.querySelectorAll("[data-whole]")) button.addEventListener("click", () => wholeRange(button.dataset.whole));
  addEventListener("hashchange", openTarget);
  openTarget();
  // what is folded inside a section stays so: the calculation of every cell would fill a hundred sheets
  const folded = () => [...document.querySelectorAll("section > details:not([open])")];
  let opened = [];
  addEventListener("beforeprint", () => { opened = folded(); opened.forEach((one) => { one.open = true; }); });
  addEventListener("afterprint", () => { opened.forEach((one) => { one.open = false; }); opened = []; });
  document.documentElement.dataset.ready = "yes";
  performance.mark("torquerig-ready");
}

startPage();
