"""Why a law cannot be compiled, in a sentence."""

import re
from collections.abc import Callable
from pathlib import Path

# What the compiler says of what laws must not do, and what that means here.
_MEANT = {
    "Cannot modify readonly array": "it writes an array of End that is no result, memory or message of its own",
    "NRT required but not enabled": "it makes a new array, as operations on whole arrays do; loop over the numbers",
}
_FRAMES = re.compile(
    r"Failed in |During: |File \"|Overload|raised from|- Resolution|- Of which|There are |With argument"
)


def reason(error: Exception, function: Callable[..., object]) -> str:
    """The deepest cause that the compiler tells, and where in the function's file it is.

    Args:
        error: of the compiler.
        function: that it could not compile.
    """
    code = getattr(function, "__code__", None)
    if code is None:
        return f"{function!r:.80} is no function written in Python"
    text = str(error)
    for told, meant in _MEANT.items():
        if told in text:
            said = meant
            break
    else:
        lines = [line.strip() for line in text.splitlines()]
        said = next((line.rstrip(" .") for line in lines if line and not _FRAMES.match(line)), type(error).__name__)
        said = said.partition(" Raised from ")[0].rstrip(" .")
        if said.endswith("found for signature:"):
            said = (
                f"{said.removesuffix(' found for signature:')} for {next(line for line in lines if '>>>' in line)[4:]}"
            )
    source = Path(code.co_filename).name
    places = re.findall(rf'{re.escape(source)}"?(?:, line |:| \()(\d+)', text)
    where = f"{source}, line {places[-1]}" if places else f"{source}, function {code.co_name}"
    return f"{said} ({where})"
