// The contrast of every text of a page with what it stands on, by the formula of WCAG 2: [[ratio, text, colours], ...] of those
// that are below `least`.
(least) => {
  const canvas = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
  const kept = new Map();

  /** Red, green and blue, 0 to 255, and alpha, 0 to 1, of any colour that CSS knows. */
  function parsed(colour) {
    if (!kept.has(colour)) {
      canvas.clearRect(0, 0, 1, 1);
      canvas.fillStyle = colour;
      canvas.fillRect(0, 0, 1, 1);
      const [red, green, blue, alpha] = canvas.getImageData(0, 0, 1, 1).data;
      kept.set(colour, [red, green, blue, alpha / 255]);
    }
    return kept.get(colour);
  }

  const over = ([r, g, b, a], below) => [r, g, b].map((value, i) => a * value + (1 - a) * below[i]);

  /** What is behind an element's text: its own ground and those below it. */
  function ground(one) {
    if (!one) return [255, 255, 255];
    const colour = parsed(getComputedStyle(one).backgroundColor);
    return colour[3] === 1 ? colour.slice(0, 3) : over(colour, ground(one.parentElement));
  }

  function luminance(colour) {
    const [r, g, b] = colour.map((value) => value / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  }

  function ratio(one, other) {
    const [dark, light] = [luminance(one), luminance(other)].sort((a, b) => a - b);
    return (light + 0.05) / (dark + 0.05);
  }

  function opacity(one) {
    return one ? Number(getComputedStyle(one).opacity) * opacity(one.parentElement) : 1;
  }

  const out = [];
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const {parentElement: parent, textContent} = texts.currentNode;
    if (!textContent.trim() || !parent.checkVisibility({opacityProperty: true, visibilityProperty: true})) continue;
    const {width, height} = parent.getBoundingClientRect();
    if (width < 2 || height < 2 || opacity(parent) < 0.05) continue;
    const [r, g, b, a] = parsed(getComputedStyle(parent).color);
    const below = ground(parent);
    const found = ratio(over([r, g, b, a * opacity(parent)], below), below);
    if (found < least) out.push([found, textContent.trim().slice(0, 40), getComputedStyle(parent).color, below]);
  }
  return out;
}
