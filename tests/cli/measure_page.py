# SPDX-License-Identifier: MIT
"""The page of polhode measure in headless Chromium: no errors, no requests, figures that are drawn, light and dark."""

import html
import json
import re
import shutil
import subprocess
import unittest

import sandbox
from sandbox import Sandbox

CALL = ("measure", "argon", "density", "2 %", "viscosity", "50 %", "diffusion", "30 %", "--molecules", "64", "--at", "160 K, 500 bar", "--output", "out")
SCHEMES = {"dark": "0", "light": "1"}  # values of Chromium's setting preferredColorScheme

# Errors are counted from the start of the page; the rest is read after the page has been laid out.
FIRST = "<script>const failures = []; addEventListener('error', e => failures.push(String(e.message)), true);</script>"
LAST = """<script>addEventListener('load', () => {
  const box = element => { const b = element.getBoundingClientRect(); return [b.width, b.height]; };
  const points = [...document.querySelectorAll('svg path, svg polyline, svg polygon')].map(e => e.getAttribute('d') || e.getAttribute('points'));
  const seen = { failures, requests: performance.getEntriesByType('resource').map(e => e.name),
                 figures: [...document.querySelectorAll('svg')].map(box), points, text: document.body.innerText,
                 ground: getComputedStyle(document.body).backgroundColor, ink: getComputedStyle(document.body).color,
                 overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth };
  const out = document.createElement('pre'); out.id = 'seen'; out.textContent = JSON.stringify(seen); document.body.append(out);
});</script>"""


def brightness(color):
    return sum(map(int, re.findall(r"\d+", color)[:3])) / 3


class Page(Sandbox):
    def seen(self, page, scheme="light", width=1000):
        """What Chromium shows of a page, and the messages of its console."""
        text = (self.folder / page).read_text(encoding="utf-8")
        self.write("probe.html", text.replace("<head>", "<head>" + FIRST, 1).replace("</body>", LAST + "</body>", 1))
        done = subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run",
                               f"--user-data-dir={self.folder / 'profile'}", f"--blink-settings=preferredColorScheme={SCHEMES[scheme]}",
                               f"--window-size={width},900", "--enable-logging=stderr", "--dump-dom", (self.folder / "probe.html").as_uri()],
                              capture_output=True, text=True, timeout=sandbox.LONGEST, check=False)
        found = re.search(r'<pre id="seen">(.*?)</pre>', done.stdout, re.DOTALL)
        self.assertIsNotNone(found, done.stderr)
        return json.loads(html.unescape(found.group(1))) | {"console": re.findall(r"CONSOLE.*", done.stderr)}

    @unittest.skipUnless(shutil.which("chromium"), "chromium is not installed")
    def test_the_page_in_chromium(self):
        process = self.polhode(*CALL)
        self.assertEqual(process.returncode, 0, process.err)
        of = {scheme: self.seen("out.html", scheme) for scheme in SCHEMES}
        for page in of.values():
            self.assertEqual([page["failures"], page["console"], page["requests"]], [[], [], []])
            self.assertGreaterEqual(len(page["figures"]), 5)  # three of convergence, the pressure tensor, the displacement
            self.assertTrue(all(width > 100 and height > 50 for width, height in page["figures"]), page["figures"])
            self.assertTrue(page["points"] and not any("nan" in p.lower() or "inf" in p.lower() for p in page["points"]))
            for word in ("density", "viscosity", "diffusion", "95 % interval", "time-step bias", "Cite van Zon"):
                self.assertIn(word, page["text"])
        # Text and ground differ by more than half of the whole range, the other way round in the dark.
        self.assertGreater(brightness(of["light"]["ground"]) - brightness(of["light"]["ink"]), 128)
        self.assertGreater(brightness(of["dark"]["ink"]) - brightness(of["dark"]["ground"]), 128)
        self.assertLessEqual(self.seen("out.html", width=500)["overflow"], 0)

    @unittest.skipUnless(shutil.which("chromium"), "chromium is not installed")
    def test_a_wrong_page_is_seen(self):
        """A page with an error, a request or a broken figure does not pass."""
        self.write("bad.html", '<!doctype html><html><head></head><body><script>nothing()</script><img src="http://127.0.0.1:9/absent.png"><svg></svg></body></html>')
        page = self.seen("bad.html")
        self.assertTrue(page["failures"] and page["console"] and page["requests"], page)


if __name__ == "__main__":
    sandbox.main()
