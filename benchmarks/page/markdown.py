"""Pieces of the page."""


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |" for line in lines) + "\n"


def number(value, digits=3):
    """Of so many significant digits, without an exponent where that is readable."""
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e+" in text and value < 1e7 else text


def times(ratio):
    return f"{number(ratio)}x"


def percent(share):
    return f"{100 * share:+.2f} %"


def code(text):
    return "".join(f"    {line}\n" for line in text.rstrip().splitlines())
