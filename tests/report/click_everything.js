// Clicks and chooses, one after another, all that a page has to be clicked and chosen. Of the options of a chooser every
// `turns`-th is taken, from `turn` on. Gives {done, unreached, idle}: how many controls, which of them a pointer cannot reach,
// and which change nothing that is drawn, told or saved.
async (turn, turns) => {
  const found = {done: 0, unreached: [], idle: []};
  let saved = 0;
  window.download = () => { saved += 1; };
  const all = (selector) => [...document.querySelectorAll(selector)];
  const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const look = () => [
    saved, location.hash, document.body.innerText, ...all("details").map(({open}) => open),
    ...all("canvas").map((one) => one.toDataURL())
  ].join("\n");

  function nameOf(one) {
    const text = one.title || one.ariaLabel || (one.closest("label")?.firstChild ?? one).textContent;
    return `${one.closest("[id]")?.id}: ${one.localName} '${text.slice(0, 60)}'`;
  }

  function isReached(one) {
    one.scrollIntoView({block: "center", inline: "center", behavior: "instant"});
    const {left, top, width, height} = one.getBoundingClientRect();
    return one.contains(document.elementFromPoint(left + width / 2, top + height / 2));
  }

  /** Whether something changes by an act, at once or a little later, as what is decoded first. */
  async function changes(act) {
    const before = look();
    act();
    for (let k = 0; k < 200; k += 1) {
      await frames();
      if (look() !== before) return true;
    }
    return false;
  }

  async function lookAt(one, act, what = "") {
    found.done += 1;
    if (!isReached(one)) found.unreached.push(nameOf(one));
    if (!await changes(act)) found.idle.push(nameOf(one) + what);
  }

  function set(one, value, kind) {
    one.value = value;
    one.dispatchEvent(new Event(kind, {bubbles: true}));
  }

  async function choose(select) {
    const first = select.value;
    const others = [...select.options].filter(({value}) => value !== first);
    for (const {value} of others.filter((_, k) => k % turns === turn % others.length))
      await lookAt(select, () => set(select, value, "change"), ` = '${value}'`);
    set(select, first, "change");
    await frames();
  }

  async function press(button) {
    if (button.textContent === "Reset") {
      button.parentElement.firstChild.click();
      await frames();
    }
    await lookAt(button, () => button.click());
    if (button.textContent === "❚❚") button.click();
  }

  for (const one of all("summary")) {
    await lookAt(one, () => one.click());
    one.parentElement.open = true;
  }
  // From a step in the middle on all that can be chosen makes a difference.
  for (const one of all("input[type=range]")) await lookAt(one, () => set(one, Math.floor(one.max / 2), "input"));
  for (const one of all("select")) await choose(one);
  for (const one of all("input[type=checkbox]")) {
    await lookAt(one, () => one.click());
    one.click();
  }
  for (const one of all("button")) await press(one);
  for (const one of all("nav a")) await lookAt(one, () => one.click());
  return found;
}
