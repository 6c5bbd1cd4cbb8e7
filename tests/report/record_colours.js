// Run before a page's own scripts: keeps in `drawnColours` in which colours lines, surfaces and words are drawn, by figure.
window.drawnColours = {};
for (const [verb, style] of [["stroke", "strokeStyle"], ["fill", "fillStyle"], ["fillText", "fillStyle"]]) {
  const plain = CanvasRenderingContext2D.prototype[verb];
  CanvasRenderingContext2D.prototype[verb] = function(...values) {
    const figure = this.canvas.closest("figure")?.id ?? "";
    ((window.drawnColours[figure] ??= {})[verb] ??= {})[this[style]] = true;
    return plain.apply(this, values);
  };
}
