# SPDX-License-Identifier: MIT
"""The page of `gnomon-study report` in headless Chromium without a network: page_test.py PROGRAM [FOLDER to keep page and screenshots in]

The same checks run on broken copies of the page, and have to find each of them."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

import fixture

BREAKS = {  # what is broken: (text of the page, what stands there instead)
    "script does not parse": ('"use strict";', '"use strict"; let let = ;'),
    "script stops": ("const filter = () => {", "const filter = () => { missing();"),
    "rows are not put back": ("body.append(...rows);", ""),
    "numbers sort as text": ("Number(cell.dataset.v)", "cell.dataset.v"),
    "filter shows all": ("row.hidden = !words.every", "row.hidden = words.length < 0 && !words.every"),
    "slider is not heard": ('slider.addEventListener("input", place);', ""),
    "zoom does nothing": ("zoom = next;", ""),
    "keys are not heard": ('"+": actions.in,', ""),
    "a picture from the network": ('<h2 id="all">', '<img alt="" src="https://example.org/a.png"><h2 id="all">'),
    "a picture is broken": ("data:image/png;base64,iVBORw0KGgo", "data:image/png;base64,AAAAAAAAAAA"),
}


def browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--host-resolver-rules=MAP * ~NOTFOUND"):
        options.add_argument(argument)
    if os.geteuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def column(driver, table, index):
    return driver.execute_script("""return [...document.querySelectorAll(`#${arguments[0]} tbody tr:not([hidden])`)]
                                    .map((row) => [row.cells[arguments[1]].dataset.v, row.cells[arguments[1]].textContent])""", table, index)


def check_sort(driver, failures):
    headers = driver.execute_script("return [...document.querySelectorAll('#rows th')].map((header) => header.textContent)")
    index = headers.index("total, ms")
    before = column(driver, "rows", index)
    button = driver.find_elements(By.CSS_SELECTOR, "#rows th button")[index]
    for ascending in (True, False):
        driver.execute_script("arguments[0].click()", button)
        cells = column(driver, "rows", index)
        values = [float(value) for value, text in cells if value is not None]
        if values != sorted(values, reverse=not ascending) or len(values) < 50:
            failures.append(f"numbers are not {'ascending' if ascending else 'descending'} after a click")
        if any(value is not None for value, text in cells[len(values):]) or "unavailable" not in cells[-1][1]:
            failures.append("rows that are unavailable are not last")
        if sorted(map(str, cells)) != sorted(map(str, before)) or cells == before:
            failures.append("sorting lost rows, or did nothing")
    names = headers.index("technique")
    driver.execute_script("arguments[0].click()", driver.find_elements(By.CSS_SELECTOR, "#rows th button")[names])
    texts = [text for value, text in column(driver, "rows", names)]
    if texts != sorted(texts):
        failures.append("words are not in order after a click")


def check_filter(driver, failures):
    box = driver.find_element(By.CSS_SELECTOR, "#rows input")
    everything = len(column(driver, "rows", 0))
    box.send_keys("garden d-hybrid certified")
    shown = [row for row in driver.find_elements(By.CSS_SELECTOR, "#rows tbody tr") if row.is_displayed()]
    texts = [row.get_attribute("textContent") for row in shown]
    if not 0 < len(texts) < everything or not all("garden" in text and "d-hybrid" in text and "certified" in text for text in texts):
        failures.append("the filter shows other rows than those with all words")
    if f"{len(texts)} of" not in driver.find_element(By.CSS_SELECTOR, "#rows .count").text:
        failures.append("the filter counts wrong")
    box.send_keys(Keys.CONTROL, "a")
    box.send_keys(Keys.DELETE)
    if len(column(driver, "rows", 0)) != everything:
        failures.append("an empty filter does not show all rows again")


def check_pictures(driver, failures):
    compare = driver.find_element(By.CSS_SELECTOR, ".compare")
    slider, view = compare.find_element(By.CSS_SELECTOR, "input[type=range]"), compare.find_element(By.CSS_SELECTOR, ".view")
    left, layers = compare.find_element(By.CSS_SELECTOR, "img.left"), compare.find_element(By.CSS_SELECTOR, ".layers")

    def clip():
        return left.value_of_css_property("clip-path")

    def transform():
        return layers.get_attribute("style")

    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", compare)
    before, edge = clip(), compare.find_element(By.CSS_SELECTOR, ".edge").get_attribute("style")
    slider.send_keys(Keys.HOME)
    if clip() == before or "100%" not in clip() or compare.find_element(By.CSS_SELECTOR, ".edge").get_attribute("style") == edge:
        failures.append("the slider does not move the edge between the pictures")
    slider.send_keys(Keys.END)
    if "100%" in clip():
        failures.append("the slider at its end hides the left picture")
    states = [transform()]
    compare.find_element(By.CSS_SELECTOR, "button[data-zoom=in]").click()
    states.append(transform())
    view.send_keys("+")
    states.append(transform())
    view.send_keys(Keys.ARROW_RIGHT)
    states.append(transform())
    ActionChains(driver).move_to_element(view).click().scroll_by_amount(0, -120).perform()
    driver.execute_script("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -200, cancelable: true, clientX: 300, clientY: 300}))", view)
    states.append(transform())
    if len(set(states)) != len(states):
        failures.append("a button, a key or the wheel does not zoom or move")
    compare.find_element(By.CSS_SELECTOR, "button[data-zoom=reset]").click()
    if transform() != states[0]:
        failures.append("'whole picture' does not go back")
    source = left.get_attribute("src")
    compare.find_element(By.CSS_SELECTOR, "select option[value=wrong]").click()
    if left.get_attribute("src") == source:
        failures.append("the wrong samples cannot be chosen")


def check(driver, page, screenshots=None):
    """All that is the matter with a page."""
    failures = []
    references = re.findall(r"""(?:src|href)=["'](?!data:|#)[^"']*|https?://[^"'\s<]*|url\((?!data:)[^)]*""", page.read_text())
    if references:
        failures.append(f"refers to {references[:3]}")
    driver.set_window_size(1280, 900)
    driver.get(page.as_uri())
    try:
        broken = driver.execute_script("""return Promise.all([...document.images].map((image) => image.decode().then(() => 0, () => 1)))
                                          .then((all) => all.reduce((a, b) => a + b, 0))""")
        if broken or len(driver.find_elements(By.CSS_SELECTOR, "img.chart")) < 10:
            failures.append("pictures are broken or missing")
        check_sort(driver, failures)
        check_filter(driver, failures)
        check_pictures(driver, failures)
    except Exception as error:  # a page too broken to be asked
        failures.append(f"{type(error).__name__}: {str(error).splitlines()[0]}")
    for width in (1280, 700):
        driver.set_window_size(width, 900)
        if driver.execute_script("return document.documentElement.scrollWidth > innerWidth"):
            failures.append(f"wider than a window of {width} pixels")
        for name, place in (("top", "h1"), ("prices", "#pay"), ("pictures", "#pictures"), ("rows", "#all")):
            driver.execute_script(f"document.querySelector('{place}').scrollIntoView()")
            if screenshots:
                driver.save_screenshot(str(screenshots / f"{width}-{name}.png"))
    if len(driver.get_screenshot_as_png()) < 15000:
        failures.append("the screenshot is blank")
    failures += [f"console: {entry['message']}" for entry in driver.get_log("browser")]
    return failures


def main(program, keep=None):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(keep or temporary).resolve()
        results = fixture.write(pathlib.Path(temporary) / "study")
        subprocess.run([program, "report", str(results), "--out", str(folder)], check=True)
        page = folder / "index.html"
        with browser() as driver:
            failures = check(driver, page, folder if keep else None)
            for failure in failures:
                print("page:", failure)
            text = page.read_text()
            for what, (old, new) in BREAKS.items():
                if old not in text:
                    print(f"the page holds no '{old}' to break: {what}")
                    failures.append(what)
                    continue
                broken = pathlib.Path(temporary) / "broken.html"
                broken.write_text(text.replace(old, new, 1))
                found = check(driver, broken)
                print(f"broken on purpose ({what}):", found[0][:120] if found else "NOT FOUND")
                if not found:
                    failures.append(what)
        return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
