"""What the documentation site needs besides its pages: reference pages of all rooms, and formulas as MathML."""

import ast
import re
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

PACKAGE = Path(__file__).parents[1] / "src" / "cotouch"
# What a user calls comes first; kernels come last.
ORDER = ("scenario", "simulation", "network", "planning", "body", "peer", "session", "members", "hands", "observers",
         "samples", "control", "traversal", "recording", "haptics", "device", "interaction", "drivers", "web", "study",
         "pacing", "files", "coupling", "mechanics", "kernels")  # fmt: skip
INTERNAL = {"cli", "meshfile"}
RESULTS = "benchmarks/RESULTS.md"
FORMULA = re.compile(r"^```math\n(.*?)^```|\$`(.+?)`\$", re.MULTILINE | re.DOTALL)


def _rooms() -> dict[str, str]:
    """Every room with exports, in the order above, and the first sentence of what it says of itself."""
    found = dict[str, str]()
    for file in PACKAGE.glob("*/__init__.py"):
        if file.parent.name in INTERNAL:
            continue
        tree = ast.parse(file.read_text(encoding="utf-8"))
        if any(isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__" for node in tree.body):
            found[file.parent.name] = re.split(r"(?<=\.)\s", ast.get_docstring(tree) or "")[0]
    last = len(ORDER)
    return dict(sorted(found.items(), key=lambda room: ORDER.index(room[0]) if room[0] in ORDER else last))


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Lists the reference in the navigation."""
    rooms = [f"reference/{name}.md" for name in ("index", *_rooms(), "errors")]
    for entry in config.nav or []:
        if "API reference" in entry:
            entry["API reference"] = rooms
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Adds the reference, a page for each room, and the benchmarks."""
    rooms = _rooms()
    pages = {name: f"# cotouch.{name}\n\n::: cotouch.{name}\n" for name in rooms}
    pages["errors"] = "# cotouch.errors\n\n::: cotouch.errors\n"
    table = "\n".join(f"| [`{name}`]({name}.md) | {text} |" for name, text in rooms.items())
    pages["index"] = (
        "# API reference\n\nThe rooms of the package, and below them the names that `import cotouch` provides.\n\n"
        "| room | what it is |\n|---|---|\n"
        f"{table}\n| [`errors`](errors.md) | Every error that cotouch raises on purpose, as one tree. |\n\n"
        "## cotouch\n\n::: cotouch\n"
    )
    for name, text in pages.items():
        files.append(File.generated(config, f"reference/{name}.md", content=text))
    results = (PACKAGE.parents[1] / RESULTS).read_text(encoding="utf-8")
    files.append(File.generated(config, "benchmarks.md", content=results))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Takes formulas out, so that Markdown leaves them alone; commands are drawn as a shell's."""
    formulas = list[str]()

    def out(match: re.Match[str]) -> str:
        block, inline = match.groups()
        formula = convert(block or inline, display="block" if block else "inline")
        formulas.append(formula.replace("<mo>&#x02016;</mo>", '<mo stretchy="false">&#x02016;</mo>'))
        return f"FORMULA{len(formulas) - 1}X"

    markdown = FORMULA.sub(out, markdown).replace(f"](../{RESULTS}", "](benchmarks.md")
    markdown = markdown.replace("\n```console\n", "\n```bash\n")  # as a console, commands would be drawn as output
    page.meta["formulas"] = formulas
    return markdown


def on_page_content(html: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Puts them back as MathML, which browsers draw by themselves; short code in a line is never broken."""
    formulas: list[Any] = page.meta["formulas"]
    html = re.sub(r"<code>(?=[^<\n]{1,24}</code>)", '<code class="short">', html)
    return re.sub(r"FORMULA(\d+)X", lambda match: formulas[int(match[1])], html)


def on_post_page(output: str, page: Page, config: MkDocsConfig) -> str:
    """Takes the script that lets the search run without a server from this folder, not from the network."""
    here = "../" * page.url.count("/")
    return output.replace("https://unpkg.com/iframe-worker/shim", f"{here}iframe-worker.js")
