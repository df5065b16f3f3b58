"""A headless Chromium, spoken to through a pipe (its DevTools protocol, messages that end with a zero byte)."""

import base64
import fcntl
import io
import itertools
import json
import os
import select
import subprocess
import time

import matplotlib.image

PATIENCE = 90  # [s]; a loaded machine draws WebGL without a graphics card
FLAGS = ["--headless", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--no-first-run", "--disable-extensions", "--disable-background-networking", "--remote-debugging-pipe"]


class Browser:
    def __init__(self, profile):
        there, ours = os.pipe()
        back, theirs = os.pipe()
        high = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (there, theirs)]

        def wire():
            for number, fd in zip((3, 4), high):
                os.dup2(fd, number)

        self.process = subprocess.Popen(["chromium", *FLAGS, f"--user-data-dir={profile}", "about:blank"], stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=wire, pass_fds=(3, 4))
        for fd in (there, theirs, *high):
            os.close(fd)
        self.write, self.read, self.buffer = ours, back, b""
        self.numbers, self.events, self.session = itertools.count(1), [], None
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.ask(f"{domain}.enable")

    def close(self):
        self.process.terminate()
        self.process.wait()
        os.close(self.write)
        os.close(self.read)

    def next_message(self, deadline):
        while b"\0" not in self.buffer:
            if not select.select([self.read], [], [], max(0, deadline - time.monotonic()))[0]:
                raise TimeoutError("chromium does not answer")
            more = os.read(self.read, 1 << 20)
            if not more:
                raise RuntimeError("chromium has ended")
            self.buffer += more
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def ask(self, method, **parameters):
        number, deadline = next(self.numbers), time.monotonic() + PATIENCE
        message = {"id": number, "method": method, "params": parameters} | ({"sessionId": self.session} if self.session else {})
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.write, data):]
        while True:
            answer = self.next_message(deadline)
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def open(self, file, width, height=900):
        self.events.clear()
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.ask("Page.navigate", url=file.resolve().as_uri())
        self.wait_for("document.readyState === 'complete'")

    def value(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait_for(self, expression):
        deadline = time.monotonic() + PATIENCE
        while not self.value(expression):
            if time.monotonic() > deadline:
                raise TimeoutError(f"still not: {expression}")
            time.sleep(0.05)

    def complaints(self):
        """What the console shows in red."""
        def bad(event):
            kind, what = event.get("method"), event.get("params", {})
            return (kind == "Runtime.exceptionThrown" or kind == "Runtime.consoleAPICalled" and what["type"] in ("error", "assert")
                    or kind == "Log.entryAdded" and what["entry"]["level"] == "error")
        return [event["params"] for event in self.events if bad(event)]

    def picture(self, selector=None):
        """Pixels [row][column][red, green, blue], 0 to 1; and the PNG."""
        clip = {}
        if selector:
            box = self.value(f"(() => {{ const r = document.querySelector('{selector}').getBoundingClientRect();"
                             "return {x: r.x + scrollX, y: r.y + scrollY, width: r.width, height: r.height, scale: 1}; })()")
            clip = {"clip": box}
        png = base64.b64decode(self.ask("Page.captureScreenshot", format="png", **clip)["data"])
        return matplotlib.image.imread(io.BytesIO(png))[:, :, :3], png

    def wheel(self, selector, amount):
        x, y = self.value(f"(() => {{ const r = document.querySelector('{selector}').getBoundingClientRect();"
                          "return [r.x + r.width / 2, r.y + r.height / 2]; })()")
        self.ask("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=amount)

    def key(self, key):
        text = {"text": key} if len(key) == 1 else {}
        self.ask("Input.dispatchKeyEvent", type="keyDown", key=key, **text)
        self.ask("Input.dispatchKeyEvent", type="keyUp", key=key)
