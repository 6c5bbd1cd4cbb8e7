"""How a page looks and whether all of it works, in each of the combinations of width and colours that readers have."""

import os
from pathlib import Path

HERE = Path(__file__).resolve().parent
COMBINATIONS = [(width, dark) for width in (400, 1400) for dark in (False, True)]
RECORDER, CLICKS, CONTRAST = ((HERE / f"{name}.js").read_text(encoding="utf-8")
                              for name in ("record_colours", "click_everything", "measure_contrast"))
LEGIBLE = 4.5  # contrast of words
VISIBLE = 3  # of lines


def keep_a_picture(page, name, width, dark):
    """In the folder that PICTURES names."""
    if os.environ.get("PICTURES"):
        page.picture(Path(os.environ["PICTURES"]) / f"{name}-{width}-{'dark' if dark else 'light'}.png")


def assert_it_fits(case, page):
    """No page is moved sideways; what is too wide is moved in its own box."""
    case.assertLessEqual(page.run("document.documentElement.scrollWidth - window.innerWidth"), 0)


def assert_words_are_legible(case, page):
    """Once nothing moves or fades any more."""
    page.wait("document.getAnimations().every((one) => one.playState !== 'running')")
    case.assertEqual(page.run(f"({CONTRAST})({LEGIBLE})"), [])


def assert_all_can_be_clicked(case, page, number):
    """Everything is reached, everything changes something; the number of controls."""
    found = page.run(f"({CLICKS})({number}, {len(COMBINATIONS)})")
    case.assertEqual((found["unreached"], found["idle"]), ([], []))
    return found["done"]


def luminance(colour):
    """Of '#rrggbb', 0 to 1."""
    parts = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one, other):
    """Of two colours as '#rrggbb': 1 to 21."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)
