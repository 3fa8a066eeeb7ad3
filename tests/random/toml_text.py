"""A deck of dicts, lists, numbers and texts as TOML."""

NAMED = ("section", "rod", "body", "function", "spring", "bushing", "joint", "gear", "tendon", "obstacle", "input")


def text_of(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {text_of(entry)}" for key, entry in value.items()) + " }"
    return "[" + ", ".join(text_of(entry) for entry in value) + "]"


def table(heading, entries):
    return [heading, *(f"{key} = {text_of(value)}" for key, value in entries.items()), ""]


def toml_text(deck):
    lines = [f"{key} = {text_of(value)}" for key, value in deck.items()
             if not isinstance(value, dict) and not is_table_list(value)]
    for key, value in deck.items():
        if key in NAMED:
            for name, entries in value.items():
                lines += table(f"[{key}.{name}]", entries)
        elif isinstance(value, dict):
            lines += table(f"[{key}]", value)
        elif is_table_list(value):
            for entries in value:
                lines += table(f"[[{key}]]", entries)
    return "\n".join(lines) + "\n"


def is_table_list(value):
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)
