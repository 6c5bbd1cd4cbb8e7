// Tables of the page.

/** columns: [{title, isNumeric, text(row), element(row)?, value(row)?}]; rows: anything; rowClass(row)? */
function tableOf(columns, rows, rowClass = () => "") {
  const head = element(
      "tr", {},
      columns.map((column) => element("th", {class: column.isNumeric ? "number" : "", scope: "col"}, column.title)));
  return element(
      "div", {class: "scroll"},
      element(
          "table", {}, element("thead", {}, head),
          element("tbody", {}, rows.map((row) => rowOf(columns, row, rowClass(row))))));
}

function rowOf(columns, row, className) {
  return element(
      "tr", {class: className},
      columns.map(
          (column) => element(
              "td", {class: column.isNumeric ? "number" : column.className ?? ""},
              column.element?.(row) ?? column.text(row))));
}

/** A table that a click on a column's head sorts by it, up and down in turn. */
class SortableTable {
  constructor(columns, rows, rowClass) {
    Object.assign(this, {columns, rows, rowClass, sortedBy: null, isUp: true});
    this.head = columns.map(
        (column) => element(
            "th", {class: column.isNumeric ? "number" : "", scope: "col"},
            element("button", {type: "button", title: "Sort", click: () => this.sortBy(column)}, column.title)));
    this.body = element("tbody");
    this.element = element(
        "div", {class: "scroll"}, element("table", {}, element("thead", {}, element("tr", {}, this.head)), this.body));
    this.fill();
  }

  sortBy(column) {
    this.isUp = this.sortedBy === column ? !this.isUp : true;
    this.sortedBy = column;
    this.columns.forEach((one, i) => {
      if (one === column)
        this.head[i].setAttribute("aria-sort", this.isUp ? "ascending" : "descending");
      else
        this.head[i].removeAttribute("aria-sort");
      this.head[i].firstChild.textContent = one === column ? `${one.title} ${this.isUp ? "▲" : "▼"}` : one.title;
    });
    this.fill();
  }

  fill() {
    const rows = [...this.rows];
    if (this.sortedBy) rows.sort((one, other) => (this.isUp ? 1 : -1) * this.compare(one, other));
    this.body.replaceChildren(...rows.map((row) => rowOf(this.columns, row, this.rowClass(row))));
  }

  /** Numbers by size, what is no number last, words by the alphabet. */
  compare(one, other) {
    const [a, b] = [one, other].map((row) => this.sortedBy.value?.(row) ?? this.sortedBy.text(row));
    if (typeof a !== "number" || typeof b !== "number")
      return String(a).localeCompare(String(b), "en", {numeric: true});
    if (Number.isNaN(a) || Number.isNaN(b)) return (Number.isNaN(a) - Number.isNaN(b)) * (this.isUp ? 1 : -1);
    return a - b;
  }
}
