// Draws the panels of a chart that this page holds as JSON, with Vega: a front over points, or stacked bars.
"use strict";
(function () {
  const page = JSON.parse(document.getElementById("data").textContent);
  const tip = document.getElementById("tip");
  const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const groupColors = () => ["--c0", "--c1", "--c2", "--c3"].map(style);
  const narrow = 520; // pixels: a phone

  function config() {
    const text = style("--text"), soft = style("--soft"), line = style("--line");
    return {
      background: null, font: "system-ui, sans-serif",
      axis: { labelColor: soft, titleColor: text, domainColor: line, tickColor: line, gridColor: line, gridOpacity: 0.6,
              labelFontSize: 12, titleFontSize: 12, titleFontWeight: "normal", titlePadding: 8, labelOverlap: true },
      legend: { labelColor: text, titleColor: soft, labelFontSize: 12, titleFontSize: 12, titleFontWeight: "normal",
                labelLimit: 320, symbolSize: 70 }
    };
  }

  // Marks name themselves by their index + 1, because Vega takes a tooltip of 0 for none.

  // Decades where a range spans some, even steps otherwise.
  function scaleOf(name, values, range, extra) {
    const low = Math.min(...values), high = Math.max(...values), log = high / low > 6;
    const domain = log ? [low / 1.5, high * 1.5] : [low - 0.12 * (high - low || low), high + 0.12 * (high - low || high)];
    return Object.assign({ name, type: log ? "log" : "linear", domain, range, zero: false, nice: false, clamp: true }, extra);
  }

  function frontSpec(panel, width) {
    const groups = [...new Set(panel.points.map(p => p.group))];
    const points = panel.points.map(p => Object.assign({}, p, { color: p.front ? p.group : "" }));
    const height = width < narrow ? 300 : 340;
    const left = width < narrow ? 58 : 70;
    const inner = Math.max(160, width - left - 24);
    const y = { signal: "scale('y', datum.y)" };
    return {
      $schema: "https://vega.github.io/schema/vega/v5.json", config: config(), width: inner, height,
      padding: { left, right: 24, top: 8, bottom: 46 }, autosize: "none",
      data: [{ name: "points", values: points }, { name: "rules", values: panel.rules },
             { name: "front", source: "points", transform: [{ type: "filter", expr: "datum.front" },
                                                            { type: "collect", sort: { field: "x" } }] }],
      scales: [scaleOf("x", panel.points.flatMap(p => [p.x, p.low || p.x, p.high || p.x]), "width"),
               scaleOf("y", [...panel.points, ...panel.rules].map(p => p.y), "height"),
               { name: "color", type: "ordinal", domain: groups, range: groupColors() }],
      axes: [{ orient: "bottom", scale: "x", title: panel.x, grid: true, tickCount: Math.floor(inner / 90), format: ",~r" },
             { orient: "left", scale: "y", title: panel.y, grid: true, format: ".0e", tickCount: 6 }],
      marks: [
        { type: "rule", name: "limits", interactive: false, from: { data: "rules" },
          encode: { update: { x: { value: 0 }, x2: { value: inner }, y, stroke: { value: style("--mark") },
                              strokeDash: { value: [5, 4] } } } },
        { type: "text", interactive: false, from: { data: "rules" },
          encode: { update: { x: { value: inner }, y, dy: { value: -4 }, align: { value: "right" }, text: { field: "label" },
                              fontSize: { value: width < narrow ? 11 : 12 }, fill: { value: style("--mark") } } } },
        { type: "group", from: { facet: { name: "group", data: "front", groupby: "group" } },
          marks: [{ type: "line", interactive: false, from: { data: "group" },
                    encode: { update: { x: { scale: "x", field: "x" }, y, interpolate: { value: "step-after" },
                      stroke: { scale: "color", field: "group" }, strokeWidth: { value: 1.5 }, strokeOpacity: { value: 0.7 } } } }] },
        { type: "rule", interactive: false, from: { data: "points" },
          encode: { update: { x: { signal: "scale('x', datum.low || datum.x)" }, x2: { signal: "scale('x', datum.high || datum.x)" }, y,
            stroke: { value: style("--grey") }, strokeWidth: { value: 1 } } } },
        { type: "symbol", name: "dots", from: { data: "points" },
          encode: { update: { x: { scale: "x", field: "x" }, y,
            size: { signal: "datum.chosen ? 260 : 110" }, shape: { signal: "datum.chosen ? 'diamond' : 'circle'" },
            fill: [{ test: "datum.front", scale: "color", field: "group" }, { value: style("--grey") }],
            stroke: [{ test: "datum.chosen", value: style("--mark") }, { value: style("--page") }],
            strokeWidth: { signal: "datum.chosen ? 2.5 : 1" }, cursor: { value: "pointer" }, tooltip: { signal: "datum.index + 1" } } } },
        { type: "text", interactive: false, from: { data: "dots" },
          encode: { enter: { text: { signal: "datum.datum.label" }, fontSize: { value: width < narrow ? 11 : 12 },
            fill: { signal: "datum.datum.front ? '" + style("--text") + "' : '" + style("--soft") + "'" } } },
          transform: [{ type: "label", size: [inner, height], avoidMarks: [], offset: [4],
                        anchor: ["right", "top", "bottom", "left", "top-right", "bottom-right", "top-left", "bottom-left"] }] }
      ]
    };
  }

  function barSpec(panel, width) {
    const parts = [...new Set(panel.points.map(p => p.group))];
    const names = [...new Set(panel.points.map(p => p.label))];
    const left = width < narrow ? 130 : 250, height = 18 * names.length;
    const inner = Math.max(120, width - left - 24);
    return {
      $schema: "https://vega.github.io/schema/vega/v5.json", config: config(), width: inner, height,
      padding: { left, right: 24, top: 30, bottom: 46 }, autosize: "none",
      data: [{ name: "parts", values: panel.points,
               transform: [{ type: "stack", groupby: ["label"], sort: { field: "order" }, field: "y" }] }],
      scales: [{ name: "x", type: "linear", domain: { data: "parts", field: "y1" }, range: "width", nice: true, zero: true },
               { name: "y", type: "band", domain: names, range: "height", padding: 0.2 },
               { name: "color", type: "ordinal", domain: parts, range: groupColors() }],
      axes: [{ orient: "bottom", scale: "x", title: panel.x, grid: true, format: "~%", tickCount: Math.floor(inner / 90) },
             { orient: "left", scale: "y", labelLimit: left - 12, domain: false, ticks: false }],
      legends: [{ fill: "color", orient: "none", direction: "horizontal", legendX: 0, legendY: -26, symbolType: "square" }],
      marks: [{ type: "rect", name: "dots", from: { data: "parts" },
                encode: { update: { x: { scale: "x", field: "y0" }, x2: { scale: "x", field: "y1" }, y: { scale: "y", field: "label" },
                  height: { scale: "y", band: 1 }, fill: { scale: "color", field: "group" }, tooltip: { signal: "datum.index + 1" } } } }]
    };
  }

  function hide() { tip.style.display = "none"; }

  function fill(point) {
    tip.textContent = "";
    const add = (parent, name, text) => { const e = document.createElement(name); e.textContent = text; parent.append(e); return e; };
    add(tip, "b", point.name);
    const list = add(tip, "dl", "");
    for (const [term, value] of point.details) { add(list, "dt", term); add(list, "dd", value); }
    for (const [name, data] of [["picture", point.picture], ["error map", point.error]])
      if (data) {
        const image = add(tip, "img", "");
        image.alt = point.name + ": " + name;
        image.src = "data:image/png;base64," + data;
      }
    if (point.cite) add(tip, "small", point.cite);
  }

  function show(point, event) {
    fill(point);
    tip.style.display = "block";
    const at = event.touches && event.touches.length ? event.touches[0] : event;
    const box = tip.getBoundingClientRect(), gap = 16;
    const right = at.clientX + gap + box.width < innerWidth;
    const x = right ? at.clientX + gap : Math.max(8, Math.min(at.clientX - gap - box.width, innerWidth - box.width - 8));
    const y = Math.max(8, Math.min(at.clientY + gap, innerHeight - box.height - 8));
    tip.style.left = Math.max(8, x) + "px";
    tip.style.top = y + "px";
  }

  let views = [];
  function draw() {
    views.forEach(view => view.finalize());
    views = page.panels.filter(panel => panel.points.length).map(panel => {
      const place = document.getElementById("chart-" + panel.id);
      const spec = (panel.kind === "bars" ? barSpec : frontSpec)(panel, place.clientWidth);
      const view = new vega.View(vega.parse(spec), { renderer: "svg", container: place, hover: true });
      view.tooltip((handler, event, item, value) =>
        value ? show(panel.points[value - 1], event) : hide());
      view.run();
      return view;
    });
    document.body.dataset.drawn = String(views.length);
  }

  let width = 0;
  function redrawn() {
    if (document.documentElement.clientWidth === width) return;
    width = document.documentElement.clientWidth;
    draw();
  }
  addEventListener("resize", redrawn);
  addEventListener("scroll", hide, { passive: true });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  redrawn();
})();
