"""A hook of mkdocs: the generated pages of the deck reference in the navigation, the deck first."""

from pathlib import Path


def on_config(config):
    names = [page.stem for page in sorted(Path(config["docs_dir"], "reference").glob("*.md"))]
    names.sort(key=lambda name: name != "deck")
    pages = [{name.replace("_", " ").capitalize(): f"reference/{name}.md"} for name in names]
    for entry in config["nav"]:
        if "Deck reference" in entry:
            entry["Deck reference"] = pages
    return config
