// Reads the data of the page and builds it.

function navigation(sections) {
  return element(
      "nav", {"aria-label": "Sections"}, sections.map((one) => element("a", {href: `#${one.id}`}, one.dataset.title)));
}

/** Left to the browser's console, where figures can be asked for their numbers. */
let thePage = null;

function build() {
  const data = JSON.parse(document.getElementById("report-data").textContent);
  thePage = data.kind === "sweep" ? new SweepPage(data) : new RunPage(data);
  const elements = thePage.elements();
  const sections = elements.filter((one) => one.tagName === "SECTION");
  const first = elements.indexOf(sections[0]);
  elements.splice(first, 0, navigation(sections));
  const report = document.getElementById("report");
  report.replaceChildren(
      ...elements,
      element(
          "footer", {class: "quiet"},
          "A self-contained page: nothing is loaded from elsewhere. Keys in a figure: + − 0 zoom, arrows go from point to point."));
  document.body.dataset.ready = "true";
}

function setColours() {
  const {style} = document.documentElement;
  style.setProperty("--ink", INK);
  style.setProperty("--paper", PAPER);
  style.colorScheme = DARK_SCREEN.matches ? "dark" : "light";
  PALETTE.forEach((colour, i) => style.setProperty(`--palette-${i}`, colour));
}

DARK_SCREEN.addEventListener("change", () => window.location.reload());

setColours();
build();
