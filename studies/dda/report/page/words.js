// What the page says in words.

/** How a run ended, as a sentence, and how serious that is. */
function statusInWords(data) {
  const status = data.summary?.status;
  const reason = data.summary?.reason ? `: ${data.summary.reason}.` : ".";
  if (!data.summary || data.log?.is_open)
    return {
      kind: "bad",
      head: "Unfinished.",
      text: " This run is still going on, or was killed: it has no conclusion yet. What it had written is shown. " +
          "Continue it with: dda resume, and make the report again."
    };
  if (status === "goal_reached") return {kind: "good", head: "Goal reached", text: reason};
  if (status === "interrupted")
    return {
      kind: "warn",
      head: "Interrupted",
      text: `${reason} The path up to here is valid; dda resume goes on with it.`
    };
  if (status === "stopped_early")
    return {kind: "warn", head: "Stopped before its goal", text: `${reason} The path up to here is valid.`};
  return {kind: "warn", head: words(status ?? "Unknown"), text: reason};
}

function statusLine(data) {
  const {kind, head, text} = statusInWords(data);
  return element("p", {class: `status ${kind}`, id: "status"}, element("b", {}, head), text);
}

function noticeLines(notices) {
  return (notices ?? []).map((notice) => element("p", {class: "notice"}, notice));
}

/** A YAML text with its comments told apart. */
function deckText(text) {
  const lines = text.split("\n").flatMap((line) => {
    const begin = commentStart(line);
    return begin < 0 ? [line, "\n"] :
                       [line.slice(0, begin), element("span", {class: "comment"}, line.slice(begin)), "\n"];
  });
  return element("pre", {tabindex: 0}, element("code", {}, lines));
}

/** Where the comment of a YAML line begins, -1 when it has none. */
function commentStart(line) {
  let quote = "";
  for (let i = 0; i < line.length; i += 1) {
    const character = line[i];
    if (quote !== "")
      quote = character === quote ? "" : quote;
    else if ((character === "\"" || character === "'") && /^$|[\s[{,:]$/.test(line.slice(0, i)))
      quote = character;
    else if (character === "#" && (i === 0 || /\s/.test(line[i - 1])))
      return i;
  }
  return -1;
}

/**
 * Comments of a deck with the key they stand at: its author's assumptions. Lines of comments that follow each other
 * are one.
 */
function commentsOf(text) {
  const found = [];
  let isOpen = false;
  for (const line of text.split("\n")) {
    const begin = commentStart(line);
    const code = (begin < 0 ? line : line.slice(0, begin)).trim();
    const said = begin < 0 ? "" : line.slice(begin).replace(/^#+\s?/, "").trim();
    if (said && code === "" && isOpen)
      found[found.length - 1].text += ` ${said}`;
    else if (said)
      found.push({at: code === "" ? "" : code, text: said});
    isOpen = said !== "" && code === "";
  }
  return found;
}

function commentList(text) {
  const comments = commentsOf(text);
  if (comments.length === 0) return element("p", {class: "quiet"}, "The deck has no comments.");
  return element(
      "ul", {},
      comments.map(
          ({at, text: said}) =>
              element("li", {}, said, at ? element("span", {class: "quiet"}, " — at ", element("code", {}, at)) : "")));
}

function folded(title, content, isOpen = false) {
  return element("details", {open: isOpen}, element("summary", {}, title), content);
}

/** A dotted key without what stands before, as far as it stays the only one of the list that is called so. */
function shortKey(key, keys) {
  const parts = key.split(".");
  for (let count = 1; count < parts.length; count += 1) {
    const short = parts.slice(-count).join(".");
    if (!keys.some((other) => other !== key && (other === short || other.endsWith(`.${short}`)))) return short;
  }
  return key;
}
