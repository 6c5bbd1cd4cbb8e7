// Looking closer with the wheel, a drag, two fingers or keys.

/**
 * Turns what is done on `stage` into calls of
 *   zoom(factor, x, y)   closer (factor > 1) about a place of the stage [px]
 *   pan(dx, dy)          moved by so much [px]
 *   reset()              everything again
 *   point(x, y)          the pointer is here, nothing pressed
 *   pick(x, y)           a click or tap
 *   leave()              the pointer has gone
 */
class Gestures {
  constructor(stage, actions) {
    this.stage = stage;
    this.actions = actions;
    this.pointers = new Map();
    this.moved = 0;
    stage.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
    stage.addEventListener("pointerdown", (event) => this.down(event));
    stage.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, (event) => this.up(event));
    stage.addEventListener("pointerleave", () => actions.leave?.());
    stage.addEventListener("dblclick", () => actions.reset());
  }

  place(event) {
    const box = this.stage.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    const factor = Math.exp(-0.0015 * Math.max(-300, Math.min(300, event.deltaY * lines)));
    this.actions.zoom(factor, ...this.place(event));
  }

  down(event) {
    if (event.button !== 0) return;
    if (this.pointers.size === 0) this.moved = 0;
    this.pointers.set(event.pointerId, this.place(event));
  }

  move(event) {
    const here = this.place(event);
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      this.actions.point?.(...here);
      return;
    }
    const [dx, dy] = [here[0] - before[0], here[1] - before[1]];
    this.moved += Math.hypot(dx, dy);
    // A hand is never quite still; a press that moves less is a click.
    const still = 4;
    if (this.moved < still) return;
    if (!this.stage.hasPointerCapture(event.pointerId)) this.stage.setPointerCapture(event.pointerId);
    if (this.pointers.size === 1)
      this.actions.pan(dx, dy);
    else
      this.pinch(event.pointerId, before, here);
    this.pointers.set(event.pointerId, here);
  }

  pinch(id, before, here) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const distance = (place) => Math.max(10, Math.hypot(place[0] - other[0], place[1] - other[1]));
    this.actions.zoom(distance(here) / distance(before), (here[0] + other[0]) / 2, (here[1] + other[1]) / 2);
  }

  up(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && this.moved < 4 && this.pointers.size === 0)
      this.actions.pick?.(...this.place(event));
  }
}

/** Buttons for those without a wheel, and two that save the figure, {name, text} of its vectors; they stay together. */
function figureButtons(actions, middle, vectors) {
  return element(
      "span", {class: "group"}, button("+", "Closer", () => actions.zoom(1.5, ...middle())),
      button("−", "Farther", () => actions.zoom(1 / 1.5, ...middle())),
      button("Reset", "Show everything again", () => actions.reset()), ...savingButtons(vectors));
}

function savingButtons(vectors) {
  return [
    button("Save SVG", "Save this figure as vector graphics", () => saveVectors(vectors())),
    button("Save PNG", "Save this figure as an image", () => savePixels(vectors()))
  ];
}
