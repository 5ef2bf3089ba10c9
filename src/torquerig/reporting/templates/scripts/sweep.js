"use strict";
// Sliders of a sweep: each position is a point that the study computed.

function startSweep() {
  const sliders = [...document.querySelectorAll("#sweep-controls input")];
  if (!sliders.length) return;
  const points = [...document.querySelectorAll("#sweep [data-point]")];
  const show = () => {
    for (const slider of sliders) {
      const text = slider.dataset.values.split("|")[Number(slider.value)];
      slider.nextElementSibling.textContent = text;
      slider.setAttribute("aria-valuetext", text);
    }
    const key = sliders.map((one) => one.value).join(",");
    for (const point of points) point.hidden = point.dataset.point !== key;
    return points.find((one) => !one.hidden);
  };
  for (const slider of sliders) {
    slider.addEventListener("input", () => {
      const point = show();
      window.torquerigMatrices.use(point.dataset.matrices, point.dataset.text);
    });
  }
  show();
}
