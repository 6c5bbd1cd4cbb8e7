"""Chromium without a window, spoken to through its DevTools protocol over two pipes: no port, no other package.

    with Browser() as browser:
        page = browser.open(path, width=1280, height=900)
        page.run("document.title")
"""

import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time


class BrowserError(Exception):
    """The browser does not answer, or a script on the page failed."""


def pipe_above_nine():
    """A pipe whose ends leave the descriptors 3 and 4 free."""
    ends = os.pipe()
    moved = tuple(fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in ends)
    for end in ends:
        os.close(end)
    return moved


class Browser:
    """Commands go to the browser's file descriptor 3, answers come from 4; each ends with a zero byte."""

    def __init__(self, patience=60):
        self.patience = patience
        self.home = tempfile.mkdtemp(prefix="dda-browser-")
        self.buffer = b""
        self.number = 0
        self.events = []
        self.process = self.start()

    def start(self):
        program = shutil.which("chromium")
        if program is None:
            raise BrowserError("there is no chromium; Debian's package of that name has it")
        to_read, self.to_browser = pipe_above_nine()
        self.from_browser, to_write = pipe_above_nine()
        command = [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                   "--disable-background-networking", "--disable-extensions", "--hide-scrollbars",
                   "--remote-debugging-pipe", f"--user-data-dir={self.home}/profile"]
        # A home that cannot be written to is none for a browser.
        environment = {**os.environ, "HOME": self.home, "XDG_CONFIG_HOME": self.home, "XDG_CACHE_HOME": self.home}
        process = subprocess.Popen(
            ["/bin/bash", "-c", f'exec 3<&{to_read} 4>&{to_write} {to_read}<&- {to_write}>&-; exec "$@"', "chromium", *command],
            pass_fds=(to_read, to_write), env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        return process

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("Browser.close")
            self.process.wait(timeout=10)
        except (BrowserError, OSError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)
        shutil.rmtree(self.home, ignore_errors=True)

    def receive(self, end):
        """The next message; BrowserError when there is none before `end`."""
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.from_browser], [], [], max(0, end - time.monotonic()))
            piece = os.read(self.from_browser, 1 << 20) if ready else b""
            if not piece:
                raise BrowserError("the browser does not answer")
            self.buffer += piece
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, session=None, **parameters):
        """One command and its result; events that come meanwhile are kept in `events`."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to_browser, data):]
        end = time.monotonic() + self.patience
        while True:
            answer = self.receive(end)
            if answer.get("id") == self.number:
                break
            self.events.append(answer)
        if "error" in answer:
            raise BrowserError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def open(self, path, width=1280, height=900, dark=False, before=""):
        """A page; `before` is a script that runs before those of its own."""
        return Page(self, path, (width, height), dark, before)


class Page:
    """An open page of a fixed size [px]; `errors` holds all that it complained of."""

    def __init__(self, browser, path, size, dark, before=""):
        self.browser = browser
        self.context = browser.call("Target.createBrowserContext")["browserContextId"]  # what pages store is not another's
        self.target = browser.call("Target.createTarget", url="about:blank", browserContextId=self.context)["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        width, height = size
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        if before:
            self.call("Page.addScriptToEvaluateOnNewDocument", source=before)
        self.call("Page.navigate", url=path.resolve().as_uri())
        self.wait("document.readyState === 'complete'")

    def call(self, method, **parameters):
        return self.browser.call(method, session=self.session, **parameters)

    def run(self, script):
        """The value of a JavaScript expression, promises awaited."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"{script}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait(self, condition):
        end = time.monotonic() + self.browser.patience
        while not self.run(condition):
            if time.monotonic() > end:
                raise BrowserError(f"never came true: {condition}")
            time.sleep(0.02)

    def drawn(self):
        """After the next two pictures of the screen everything asked for has been drawn."""
        self.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)
        self.drawn()

    def click(self, selector, until=None):
        """A press at the middle of an element, wherever the pointer finds it; waits until a script is true, if one is given."""
        self.press(selector)
        self.drawn()
        if until:
            self.wait(until)

    def press(self, selector):
        left, top, width, height = self.scroll_to(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=left + width / 2, y=top + height / 2, button="left", clickCount=1)

    def follow(self, selector, address):
        """A press on a link, and the page whose path ends so."""
        self.press(selector)
        end = time.monotonic() + self.browser.patience
        while not self.has_arrived(address):
            if time.monotonic() > end:
                raise BrowserError(f"never came to {address}")
            time.sleep(0.02)
        self.drawn()

    def has_arrived(self, address):
        try:
            return self.run(f"location.pathname.endsWith({address!r}) && document.readyState === 'complete'")
        except BrowserError:  # between two documents there is none to ask
            return False

    def type(self, text):
        """Into what has the focus."""
        self.call("Input.insertText", text=text)
        self.drawn()

    def close(self):
        self.browser.call("Target.disposeBrowserContext", browserContextId=self.context)

    def key(self, name):
        self.call("Input.dispatchKeyEvent", type="keyDown", key=name, code=name)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=name, code=name)
        self.drawn()

    def scroll_to(self, selector):
        """Middle of an element, in the window [px]."""
        place = self.run(f"(() => {{ const one = document.querySelector({json.dumps(selector)});"
                         "one.scrollIntoView({block: 'center'}); const box = one.getBoundingClientRect();"
                         "return [box.left, box.top, box.width, box.height]; })()")
        self.drawn()
        return place

    def picture(self, path):
        """The whole page as PNG."""
        size = self.call("Page.getLayoutMetrics")["cssContentSize"]
        image = self.call("Page.captureScreenshot", captureBeyondViewport=True,
                          clip={"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1})
        path.write_bytes(base64.b64decode(image["data"]))

    def events(self, method):
        return [event["params"] for event in self.browser.events
                if event.get("sessionId") == self.session and event.get("method") == method]

    def errors(self):
        """Exceptions, and warnings and errors of console and browser."""
        self.drawn()
        out = [str(one["exceptionDetails"]) for one in self.events("Runtime.exceptionThrown")]
        out += [str(one) for one in self.events("Runtime.consoleAPICalled") if one["type"] in ("error", "warning", "assert")]
        out += [str(one["entry"]) for one in self.events("Log.entryAdded") if one["entry"]["level"] in ("error", "warning")]
        return out

    def requests(self):
        """Addresses that the page asked for."""
        return [one["request"]["url"] for one in self.events("Network.requestWillBeSent")]
