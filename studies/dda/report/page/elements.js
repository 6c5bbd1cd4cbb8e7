// Elements of the page. What the user wrote is set as text, never as HTML.

/** An element with attributes (functions are event listeners) and children (elements or texts). */
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function")
      made.addEventListener(key, value);
    else if (value === true)
      made.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined)
      made.setAttribute(key, value);
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return made;
}

/** A section with a heading that the page's navigation finds. */
function section(id, title, ...children) {
  return element("section", {id, "data-title": title}, element("h2", {}, title), ...children);
}

/** Term and value, one below the other; pairs without a value are left out. */
function facts(pairs) {
  const list = element("dl", {class: "facts"});
  for (const [term, value] of pairs)
    if (value !== null && value !== undefined && value !== "")
      list.append(element("dt", {}, term), element("dd", {}, value));
  return list;
}

/** A choice among [value, text] pairs. */
function chooser(label, options, chosen, onChange) {
  const select = element(
      "select", {change: () => onChange(select.value)},
      options.map(([value, text]) => element("option", {value, selected: value === chosen}, text)));
  return element("label", {}, label, select);
}

function checkbox(label, checked, onChange) {
  const box = element("input", {type: "checkbox", checked, change: () => onChange(box.checked)});
  return element("label", {}, box, label);
}

function button(text, title, onClick) {
  return element("button", {type: "button", title, "aria-label": title, click: onClick}, text);
}

/** Gives the user a file. */
function download(name, blob) {
  const address = URL.createObjectURL(blob);
  const link = element("a", {href: address, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

function saveVectors({name, text}) {
  download(`${name}.svg`, new Blob([text], {type: "image/svg+xml"}));
}

/** The same in pixels, twice as many each way as on the page: enough for a slide. */
async function savePixels({name, text}) {
  const density = 2;
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = element("canvas", {width: density * image.width, height: density * image.height});
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((blob) => download(`${name}.png`, blob), "image/png");
}

/** A name that a file may have. */
function fileName(...parts) {
  return parts.filter(Boolean).join("-").replace(/[^A-Za-z0-9._-]+/g, "_");
}

/** Draws with the next picture of the screen, once, however often it is asked before. */
function onceAFrame(draw) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw();
    });
  };
}
