# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of pages share: a headless Chromium, and a page that is open in it."""
import argparse
import json
import os
import shutil
import sys
import tempfile
from pathlib import Path

SKIPPED = 77

try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    print("skipped: python3-selenium is not installed")
    sys.exit(SKIPPED)


class Browser:
    """Chromium for the time of a with-block. webgl: whether pages can draw with it, in software."""

    def __init__(self, width=1280, height=900, webgl=True):
        self.size = (width, height)
        self.graphics = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader") if webgl else ("--disable-3d-apis",)

    def __enter__(self):
        chromium, driver = shutil.which("chromium"), shutil.which("chromedriver")
        if not chromium or not driver:
            print("skipped: chromium and chromium-driver are not installed")
            sys.exit(SKIPPED)
        options = webdriver.ChromeOptions()
        options.binary_location = chromium
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
                         "--window-size=%d,%d" % self.size, *self.graphics):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.home = tempfile.TemporaryDirectory()  # the browser's profile and caches
        os.environ["HOME"] = self.home.name
        self.driver = webdriver.Chrome(service=webdriver.chrome.service.Service(driver), options=options)
        return self.driver

    def __exit__(self, *_):
        self.driver.quit()
        self.home.cleanup()


class Page:
    """A page that is open, and what a reader does with it."""

    def __init__(self, driver, address):
        self.driver = driver
        driver.get(address)
        self.data = json.loads(self.run("return document.getElementById('page-data').textContent"))

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def texts(self, selector):
        return self.run("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    def pointer(self):
        """Actions of the pointer, which by default takes a quarter of a second for each movement."""
        return ActionChains(self.driver, duration=0)

    def point_at(self, element, x=0, y=0):
        """x and y: from the element's middle, in pixels."""
        self.run("arguments[0].scrollIntoView({block: 'center'})", element)
        self.pointer().move_to_element_with_offset(element, x, y).perform()

    def drag(self, element, start, way):
        self.run("arguments[0].scrollIntoView({block: 'center'})", element)
        self.pointer().move_to_element_with_offset(element, *start).click_and_hold().move_by_offset(*way).release().perform()
        self.drawn()

    def click(self, element):
        self.run("arguments[0].scrollIntoView({block: 'center'})", element)
        element.click()

    def tooltip(self):
        tooltip = self.one("#tooltip")
        return tooltip.text if tooltip.is_displayed() else ""

    def resize(self, width, height):
        """Changes the size of the window, and waits until the page has been drawn in it."""
        self.driver.set_window_size(width, height)
        # The page learns its size later than the window.
        WebDriverWait(self.driver, 120).until(lambda _: self.run("return innerWidth === arguments[0]", width))
        self.drawn()

    def drawn(self):
        """Waits until what is to be drawn is drawn."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()))")

    def read(self, canvas, script, *arguments):
        """What a script answers that has the canvas' width, height and data (as of an ImageData), and arguments."""
        return self.run("""
            const [canvas, ...values] = arguments;
            const { width, height } = canvas;
            const context = Object.assign(document.createElement('canvas'), { width, height })
              .getContext('2d', { willReadFrequently: true });
            context.drawImage(canvas, 0, 0);
            const { data } = context.getImageData(0, 0, width, height);
            """ + script, canvas, *arguments)

    def pixels(self, canvas):
        """How many pixels of a canvas show something, and a text that differs between pictures."""
        return self.read(canvas, """
            let covered = 0;
            let hash = 0;
            for (let i = 0; i < data.length; i += 4) {
              hash = (31 * hash + data[i] + 256 * data[i + 1] + 65536 * data[i + 2] + data[i + 3]) % 4294967291;
              if (data[i + 3] === 255) ++covered;
            }
            return { share: 4 * covered / data.length, hash: String(hash) };
            """)


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def check_silence(page):
    """No message on the console, no request but for the file itself."""
    messages = [entry["message"] for entry in page.driver.get_log("browser")]
    expect(not messages, f"the console says {messages}")
    for entry in page.driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] != "Network.requestWillBeSent":
            continue
        address = message["params"]["request"]["url"]
        expect(address.startswith(("file:", "data:", "blob:")), f"the page asks for {address}")


def check_width(page):
    """No page is wider than a narrow window."""
    size = page.driver.get_window_size()
    for width in (1280, 500):
        page.resize(width, 900)
        beyond = page.run("return document.documentElement.scrollWidth - window.innerWidth")
        expect(beyond <= 0, f"the page is {beyond} pixels wider than a window of {width}")
    page.resize(size["width"], size["height"])


def check_theme(page):
    def ground():
        return page.run("return getComputedStyle(document.body).backgroundColor")

    before = ground()
    page.run("window.scrollTo(0, 0)")
    page.click(page.one("#theme"))
    expect(ground() != before, "the theme does not change")
    page.click(page.one("#theme"))


def set_theme(page, theme):
    if page.run("return document.documentElement.dataset.theme") != theme:
        page.run("document.getElementById('theme').click()")


def main(description, check):
    """Calls check with the page and the folder of screenshots that the command line names; returns the exit status."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("page", type=Path)
    parser.add_argument("--screenshots", type=Path, help="folder for pictures of the page")
    arguments = parser.parse_args()
    try:
        check(arguments.page.resolve(), arguments.screenshots)
    except AssertionError as error:
        print(f"{arguments.page}: {error}", file=sys.stderr)
        return 1
    print(f"{arguments.page}: the page works")
    return 0
