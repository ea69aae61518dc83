"use strict";
// Tables: a click on a header sorts (numbers by data-v, cells without a value last), the box filters by words.
for (const table of document.querySelectorAll(".table")) {
  const body = table.querySelector("tbody"), headers = [...table.querySelectorAll("th")], count = table.querySelector(".count");
  const valueOf = (row, column) => {
    const cell = row.cells[column];
    return cell.dataset.v === undefined ? cell.textContent : Number(cell.dataset.v);
  };
  const compare = (a, b) => {
    if (typeof a !== typeof b) return 0;
    return typeof a === "number" ? a - b : a.localeCompare(b, "en", { numeric: true });
  };
  headers.forEach((header, column) => header.querySelector("button").addEventListener("click", () => {
    const direction = header.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    for (const other of headers) other.setAttribute("aria-sort", "none");
    header.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
    const rows = [...body.rows], hasNumbers = rows.some((row) => row.cells[column].dataset.v !== undefined);
    const isLast = (row) => hasNumbers ? row.cells[column].dataset.v === undefined : row.cells[column].textContent === "";
    rows.sort((a, b) => isLast(a) - isLast(b) || direction * compare(valueOf(a, column), valueOf(b, column)));
    body.append(...rows);
  }));
  const filter = () => {
    const words = table.querySelector("input").value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of body.rows) {
      const text = [...row.cells].map((cell) => cell.textContent).join(" ").toLowerCase();
      row.hidden = !words.every((word) => text.includes(word));
      shown += !row.hidden;
    }
    count.textContent = `${shown} of ${body.rows.length} rows`;
  };
  table.querySelector("input").addEventListener("input", filter);
  filter();
}

// Two pictures on top of each other: the slider moves the edge between them; wheel, buttons and + - 0 zoom, dragging moves the zoomed picture.
for (const compare of document.querySelectorAll(".compare")) {
  const view = compare.querySelector(".view"), layers = compare.querySelector(".layers"), edge = compare.querySelector(".edge");
  const left = compare.querySelector("img.left"), slider = compare.querySelector("input[type=range]"), choice = compare.querySelector("select");
  let zoom = 1, x = 0, y = 0, drag = null;
  const place = () => {
    x = Math.min(0, Math.max(x, view.clientWidth * (1 - zoom)));
    y = Math.min(0, Math.max(y, view.clientHeight * (1 - zoom)));
    layers.style.transform = `translate(${x}px, ${y}px) scale(${zoom})`;
    const share = Math.min(1, Math.max(0, (slider.value / 100 * view.clientWidth - x) / (zoom * view.clientWidth)));
    left.style.clipPath = `inset(0 ${100 * (1 - share)}% 0 0)`;
    edge.style.left = `${slider.value}%`;
    view.classList.toggle("zoomed", zoom > 1);
    compare.querySelector(".zoom").textContent = `${zoom.toFixed(zoom < 10 ? 1 : 0)}x`;
  };
  const zoomTo = (next, atX, atY) => {
    next = Math.min(32, Math.max(1, next));
    x = atX - (atX - x) * next / zoom;
    y = atY - (atY - y) * next / zoom;
    zoom = next;
    place();
  };
  const middle = () => [view.clientWidth / 2, view.clientHeight / 2];
  const actions = { in: () => zoomTo(zoom * 1.5, ...middle()), out: () => zoomTo(zoom / 1.5, ...middle()), reset: () => zoomTo(1, 0, 0) };
  for (const button of compare.querySelectorAll("button")) button.addEventListener("click", actions[button.dataset.zoom]);
  slider.addEventListener("input", place);
  choice.addEventListener("change", () => { left.src = compare.querySelector(`template[data-layer="${choice.value}"]`).dataset.src; });
  view.addEventListener("wheel", (event) => {
    if (document.activeElement !== view && !event.ctrlKey) return;  // a page that only scrolls by is left alone
    event.preventDefault();
    const box = view.getBoundingClientRect();
    zoomTo(zoom * Math.exp(-event.deltaY / 400), event.clientX - box.left, event.clientY - box.top);
  }, { passive: false });
  view.addEventListener("pointerdown", (event) => {
    view.focus();
    drag = [event.clientX - x, event.clientY - y];
    view.setPointerCapture(event.pointerId);
  });
  view.addEventListener("pointermove", (event) => {
    if (drag === null) return;
    [x, y] = [event.clientX - drag[0], event.clientY - drag[1]];
    place();
  });
  for (const end of ["pointerup", "pointercancel"]) view.addEventListener(end, () => { drag = null; });
  view.addEventListener("keydown", (event) => {
    const step = view.clientWidth / 10;
    const keys = {
      "+": actions.in, "=": actions.in, "-": actions.out, "0": actions.reset,
      ArrowLeft: () => { x += step; }, ArrowRight: () => { x -= step; }, ArrowUp: () => { y += step; }, ArrowDown: () => { y -= step; },
    };
    if (keys[event.key] === undefined || event.ctrlKey) return;
    event.preventDefault();
    keys[event.key]();
    place();
  });
  addEventListener("resize", place);
  place();
}
