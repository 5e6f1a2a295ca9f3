#!/usr/bin/env python3
"""Looks at a report of `meniscus compare` in headless Chromium: moves the slider, flips, zooms, selects pixels, by keyboard too, and
asserts on what the page then shows. Speaks WebDriver (W3C) to ChromeDriver, with nothing but Python's own library.

    report_in_a_browser.py MENISCUS CHROMEDRIVER FOLDER_FOR_SCREENSHOTS
    report_in_a_browser.py --shoot REPORT.html CHROMEDRIVER OUT.png     # the viewer with its slider, as a picture
"""

import base64
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 0.4, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
light_source { <3, 5, -6> color rgb 1 }
plane { y, -1.2 pigment { checker color rgb 0.9 color rgb 0.2 } }
sphere { 0, 1 material { ior Ior } }
"""
WIDTH, HEIGHT = 64, 48
KEYS = {"right": "\ue014", "down": "\ue015", "space": " "}


class Browser:
    def __init__(self, chromedriver, profile, *extra):
        self.driver = subprocess.Popen([chromedriver, "--port=0"], stdout=subprocess.PIPE, text=True)
        self.url = ""
        for line in self.driver.stdout:
            if "was started successfully on port" in line:
                port = line.strip().rstrip(".").split()[-1]
                self.url = f"http://127.0.0.1:{port}/session"
                break
        arguments = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-dev-shm-usage",
                     "--disable-background-networking", "--disable-component-update", "--disable-sync", "--force-device-scale-factor=1",
                     "--window-size=1200,1400", f"--user-data-dir={profile}", *extra]
        options = {"goog:chromeOptions": {"args": arguments}, "goog:loggingPrefs": {"browser": "ALL"}}
        session = self.send("POST", "", {"capabilities": {"alwaysMatch": options}})
        self.url += "/" + session["sessionId"]

    def send(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(error.read().decode()) from error

    def run(self, script, *arguments):
        return self.send("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def element(self, selector):
        return next(iter(self.send("POST", "/element", {"using": "css selector", "value": selector}).values()))

    def click(self, selector):
        self.send("POST", f"/element/{self.element(selector)}/click", {})

    def type(self, selector, text):
        self.send("POST", f"/element/{self.element(selector)}/value", {"text": text})

    def text(self, selector):
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def set_range(self, selector, value):
        self.run("const e = document.querySelector(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('input'))",
                 selector, value)

    def color_at_pixel(self, x, y):
        """What the canvas shows at the middle of a picture's pixel."""
        return self.run("""const [x, y] = arguments;
            const at = (p, corner) => Math.floor(corner + (p + 0.5) * state.zoom);
            return [...context.getImageData(at(x, state.left), at(y, state.top), 1, 1).data].slice(0, 3)""", x, y)

    def screenshot(self, path):
        path.write_bytes(base64.b64decode(self.send("GET", "/screenshot")))

    def screenshot_of(self, selector, path):
        path.write_bytes(base64.b64decode(self.send("GET", f"/element/{self.element(selector)}/screenshot")))

    def console(self):
        return [entry["message"] for entry in self.send("POST", "/se/log", {"type": "browser"}) if entry["level"] == "SEVERE"]

    def close(self):
        try:
            self.send("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()


def check(what, condition):
    if not condition:
        raise SystemExit(f"FAILED: {what}")
    print(f"ok: {what}")


def near(a, b, tolerance=1.01):
    return all(abs(p - q) <= tolerance for p, q in zip(a, b))


def make_report(meniscus, folder):
    """A report on two pictures of a ball, of ior 1.5 and 1.3, and what the two pictures hold."""
    (folder / "ball.scene").write_text(SCENE)
    size = ["-W", str(WIDTH), "-H", str(HEIGHT)]
    for name, ior in (("a", 1.5), ("b", 1.3)):
        subprocess.run([meniscus, "render", "ball.scene", *size, "--spp", "1", "--declare", f"Ior={ior}", "-o", f"{name}.exr",
                        "--quiet"], cwd=folder, check=True)
    answer = subprocess.run([meniscus, "compare", "a.exr", "b.exr", "--report", "r.html", "--json", "-"], cwd=folder, check=True,
                            capture_output=True, text=True)
    return json.loads(answer.stdout)["comparisons"][0]


def inspect_color(meniscus, folder, ior, x, y):
    answer = subprocess.run([meniscus, "inspect", "ball.scene", str(x), str(y), "-W", str(WIDTH), "-H", str(HEIGHT), "--declare",
                             f"Ior={ior}", "--json"], cwd=folder, check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)["color"]


def on_screen(linear):
    def srgb(v):
        v = min(max(v, 0.0), 1.0)
        return 12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055
    return [round(255 * srgb(v)) for v in linear]


def open_report(browser, path):
    browser.send("POST", "/url", {"url": path.as_uri()})
    for _ in range(100):
        if browser.run("return document.getElementById('canvas').dataset.ready") == "yes":
            break
        time.sleep(0.1)


def look(browser, meniscus, folder, comparison, shots):
    open_report(browser, folder / "r.html")
    check("the viewer is ready", browser.run("return !document.querySelector('.viewer').hidden"))
    check("nothing is loaded from elsewhere", browser.run("return performance.getEntriesByType('resource')"
                                                          ".every((r) => r.name.startsWith('data:'))"))
    check("the page is no wider than the window",
          browser.run("return document.documentElement.scrollWidth <= document.documentElement.clientWidth"))

    worst = comparison["worst"][0]
    x, y = worst["x"], worst["y"]
    a, b = (inspect_color(meniscus, folder, ior, x, y) for ior in (1.5, 1.3))

    check("the reference is shown first", near(browser.color_at_pixel(x, y), on_screen(a)))
    browser.click("#flip")
    check("flip shows the other picture", near(browser.color_at_pixel(x, y), on_screen(b)))
    check("flip chooses its button", browser.run("return document.querySelector('input[name=view]:checked').value") == "picture")
    browser.screenshot(shots / "picture.png")

    browser.type("#canvas", "3")
    check("key 3 shows the slider", browser.run("return canvas.dataset.view") == "slider")
    browser.set_range("#slider", 100)
    check("the slider at the right end shows the reference", near(browser.color_at_pixel(x, y), on_screen(a)))
    browser.set_range("#slider", 0)
    check("the slider at the left end shows the picture", near(browser.color_at_pixel(x, y), on_screen(b)))
    browser.set_range("#slider", 50)
    browser.screenshot_of(".viewer", shots / "slider.png")

    browser.type("#canvas", "4")
    shown = {browser.run("return canvas.dataset.shown")}
    for _ in range(30):
        time.sleep(0.1)
        shown.add(browser.run("return canvas.dataset.shown"))
    check("blinking shows both in turn", shown == {"reference", "picture"})

    browser.type("#canvas", "5")
    wanted = max((q - p for p, q in zip(a, b)), key=abs)
    browser.set_range("#scale", 0)
    color = browser.color_at_pixel(x, y)
    check("a difference has its sign's colour", (color[0] > color[2]) == (wanted > 0))
    check("no difference is white", near(browser.color_at_pixel(0, 0), [255, 255, 255]))
    browser.set_range("#scale", -3)
    stronger = browser.color_at_pixel(x, y)
    check("a smaller scale gives stronger colours", sum(stronger) < sum(color))
    check("the legend follows", browser.text("#legend-high") == "+0.0010")
    browser.set_range("#scale", -0.5)
    browser.screenshot(shots / "difference.png")

    browser.type("#canvas", "1")
    zoom = browser.run("return state.zoom")
    browser.click("#zoom-in")
    check("zoom grows", browser.run("return state.zoom") > zoom)
    browser.type("#canvas", "0")
    check("key 0 shows all again", browser.run("return state.zoom") == zoom)

    browser.click("button.go")
    check("the worst pixel's button selects it", browser.text("#place") == f"({x}, {y})")
    check("and tells its values", all(abs(float(browser.text(f"#reference-{c}")) - a[c]) < 1e-6 and
                                      abs(float(browser.text(f"#picture-{c}")) - b[c]) < 1e-6 for c in range(3)))
    # Nearest neighbour: the corners of an enlarged pixel have its middle's colour.
    corners = browser.run("""const side = state.zoom, left = state.left + arguments[0] * side, top = state.top + arguments[1] * side;
        return [[0.2, 0.2], [0.8, 0.2], [0.5, 0.5], [0.8, 0.8]].map(([u, v]) =>
            context.getImageData(Math.floor(left + u * side), Math.floor(top + v * side), 1, 1).data.join())""", x, y)
    check("zoom shows pixels as squares", browser.run("return state.zoom") >= 16 and len(set(corners)) == 1)
    browser.screenshot(shots / "pixels.png")
    browser.type("#canvas", KEYS["right"] + KEYS["down"])
    check("arrow keys move over pixels", browser.text("#place") == f"({x + 1}, {y + 1})")
    browser.type("#canvas", KEYS["space"])
    check("Space flips", browser.run("return canvas.dataset.shown") == "picture")

    browser.run("location.hash = document.querySelector('a[href^=\"#pixel-\"]').hash")
    time.sleep(0.2)
    check("a link opens its pixel's details", browser.run("return document.querySelector('details').open"))
    browser.run("document.querySelector('#numbers-head').scrollIntoView()")
    browser.screenshot(shots / "numbers.png")
    browser.run("document.querySelector('#worst-head').scrollIntoView()")
    browser.screenshot(shots / "worst.png")
    nameless = browser.run("""return [...document.querySelectorAll('input, select, button, canvas, img')].filter(
        (e) => !(e.labels?.length || e.textContent.trim() || e.alt || e.getAttribute('aria-label'))).map((e) => e.outerHTML)""")
    check(f"every control has a name {nameless}", nameless == [])
    check("the console is silent", browser.console() == [])

    pdf = base64.b64decode(browser.send("POST", "/print", {"background": True}))
    check("it prints", pdf.startswith(b"%PDF"))
    (shots / "print.pdf").write_bytes(pdf)


def is_blank(png):
    """Whether a screenshot of a page holds next to nothing: one colour packs to a few kilobytes."""
    return not png.startswith(b"\x89PNG") or len(png) < 10000


def look_at_povrays(browser, meniscus, folder, shots):
    """The report on a scene beside POV-Ray: each worst pixel tells what both renderers do there."""
    subprocess.run([meniscus, "compare", "ball.scene", "-W", str(WIDTH), "-H", str(HEIGHT), "--declare", "Ior=1.5", "--report", "p.html"],
                   cwd=folder, check=True, capture_output=True)
    open_report(browser, folder / "p.html")
    check("beside POV-Ray: the viewer is ready", browser.run("return !document.querySelector('.viewer').hidden"))
    browser.run("location.hash = document.querySelector('a[href^=\"#pixel-\"]').hash")
    time.sleep(0.2)
    details = browser.run("return document.querySelector('details[open]').textContent")
    check("a worst pixel's link opens both renderers' values", "POV-Ray: linear" in details and "Meniscus: linear" in details)
    check("the ray tree, and the commands for both",
          all(words in details for words in ("meniscus inspect ball.scene", "povray +I", "reflect", "refract")))
    check("the console is silent there, too", browser.console() == [])
    browser.run("document.querySelector('details[open]').scrollIntoView()")
    browser.screenshot(shots / "povray.png")


def shoot(report, chromedriver, picture):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(chromedriver, folder)
        try:
            open_report(browser, pathlib.Path(report).resolve())
            browser.type("#canvas", "3")
            browser.set_range("#slider", 50)
            browser.screenshot_of(".viewer", pathlib.Path(picture))
        finally:
            browser.close()


def main():
    if sys.argv[1] == "--shoot":
        return shoot(*sys.argv[2:5])
    meniscus, chromedriver = (str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3])
    shots = pathlib.Path(sys.argv[3]).resolve()
    shots.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name)
        comparison = make_report(meniscus, folder)
        browser = Browser(chromedriver, folder / "profile")
        try:
            look(browser, meniscus, folder, comparison, shots)
            look_at_povrays(browser, meniscus, folder, shots)
        finally:
            browser.close()
    for path in sorted(shots.glob("*.png")):
        check(f"{path.name} shows something", not is_blank(path.read_bytes()))


if __name__ == "__main__":
    main()
