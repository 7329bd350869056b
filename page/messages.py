"""Writes what the page may say as TypeScript, from the models that check it: `python page/messages.py`.

The result is src/messages.ts; tests/web/test_messages.py holds it to the models.
"""

import json
from inspect import cleandoc
from pathlib import Path
from typing import Any

from cotouch.observers import COMMANDS, HAND_MODES
from cotouch.web import Hello, TakeControl

MESSAGES = Path(__file__).parent / "src" / "messages.ts"
_HEAD = "// What the page may say, and the server checks; made by messages.py from the server's models."
_NAMES = {"integer": "number", "number": "number", "boolean": "boolean", "string": "string", "null": "null"}


def messages() -> str:
    """The text of src/messages.ts."""
    commands: dict[str, Any] = COMMANDS.json_schema()
    names = [one["$ref"].rpartition("/")[2] for one in commands["oneOf"]]
    parts = [
        _HEAD,
        "/** How a hand moves, by the number that stands for it in frames. */\n"
        f"export const HAND_MODES = {_list(HAND_MODES)} as const;\n"
        "export type HandMode = (typeof HAND_MODES)[number];",
        *(_interface(name, commands["$defs"][name]) for name in names),
        "/** What a session may be asked for. */\n"
        f"export type Command = {' | '.join(names)};\n"
        'export type Doable = Command["what"];',
        _interface("TakeControl", TakeControl.model_json_schema()),
        _interface("Hello", Hello.model_json_schema()),
    ]
    return "\n\n".join(parts) + "\n"


def _interface(name: str, schema: dict[str, Any]) -> str:
    """A model; what the page may leave out has a question mark."""
    said = cleandoc(schema["description"]).splitlines()[0]
    needed = {*schema.get("required", ()), "what", "type"}
    lines = [
        f"  {part}{'' if part in needed else '?'}: {_type(entry)};"
        + (f" // {entry['description']}" if "description" in entry else "")
        for part, entry in schema["properties"].items()
    ]
    return "\n".join([f"/** {said} */", f"export interface {name} {{", *lines, "}"])


def _type(entry: dict[str, Any]) -> str:
    """Of one part."""
    if "anyOf" in entry:
        return " | ".join(_type(one) for one in entry["anyOf"])
    if "const" in entry:
        return json.dumps(entry["const"])
    if "enum" in entry:
        return " | ".join(map(json.dumps, entry["enum"]))
    if "prefixItems" in entry:
        return f"readonly [{', '.join(_type(one) for one in entry['prefixItems'])}]"
    if entry["type"] == "array":
        return f"readonly ({_type(entry['items'])})[]"
    return _NAMES[entry["type"]]


def _list(words: tuple[str, ...]) -> str:
    return f"[{', '.join(map(json.dumps, words))}]"


if __name__ == "__main__":
    MESSAGES.write_text(messages(), encoding="utf-8")
