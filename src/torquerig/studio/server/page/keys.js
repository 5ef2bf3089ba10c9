// Ctrl-S saves, Ctrl-Z undoes, Ctrl-Y redoes; inside a field Ctrl-Z and Ctrl-Y are those of the browser.
addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const typing = ["INPUT", "TEXTAREA"].includes(event.target.tagName);
  const known = { s: "save", z: typing ? "" : event.shiftKey ? "redo" : "undo", y: typing ? "" : "redo" };
  const what = known[event.key.toLowerCase()];
  if (!what) return;
  event.preventDefault();
  document.activeElement.blur(); // what is being written counts
  emitEvent("studio_key", what);
});
