"""Which keys and choices of the deck's JSON Schema a deck uses: every key by its path, every word of a key, and every
form that its value may have (a number or an expression, one word or a list, a vector or a matrix or a point)."""

FREE_NAME = "*"


def resolve(schema, root):
    while "$ref" in schema:
        schema = root["$defs"][schema["$ref"].rsplit("/", 1)[1]]
    return schema


def tables_of(schema):
    """The tables of an object by name; FREE_NAME for those that a deck names."""
    named = dict(schema.get("properties", {}))
    for pattern in schema.get("patternProperties", {}).values():
        named[FREE_NAME] = pattern
    return named


def list_items(schema, root, path=""):
    """All that there is to be used, as texts: "rod.*.order", "rod.*.element = simo", "load[].force[] as string"."""
    schema = resolve(schema, root)
    for option in schema.get("anyOf", []):
        form = resolve(option, root)
        if "required" in form and "type" not in form and "enum" not in form:
            continue  # a rule about keys
        yield f"{path} as {form_of(form)}"
        yield from list_items(form, root, path)
    for word in schema.get("enum", []):
        yield f"{path} = {word}"
    for name, entry in tables_of(schema).items():
        inner = f"{path}.{name}" if path else name
        yield inner
        yield from list_items(entry, root, inner)
    if "items" in schema:
        yield from list_items(schema["items"], root, path + "[]")


def form_of(schema):
    if "enum" in schema:
        return "word"
    if schema.get("type") == "array":
        inner = schema["items"]
        return "array of arrays" if inner.get("type") == "array" else "array"
    return "number" if schema.get("type") in ("number", "integer") else str(schema.get("type"))


def form_of_value(value):
    if isinstance(value, list):
        return "array of arrays" if isinstance(value[0], list) else "array"
    return "string" if isinstance(value, str) else "number"


def list_used(value, schema, root, path=""):
    """Those of the items that a deck, or a part of it, uses."""
    schema = resolve(schema, root)
    if "anyOf" in schema and isinstance(value, dict):
        options = (resolve(option, root) for option in schema["anyOf"])
        schema = next((option for option in options if option.get("type") == "object"), schema)
    elif "anyOf" in schema:
        yield from list_used_option(value, schema["anyOf"], root, path)
    if value in schema.get("enum", []):
        yield f"{path} = {value}"
    if isinstance(value, dict):
        named = tables_of(schema)
        for name, entry in value.items():
            key = name if name in named else FREE_NAME
            inner = f"{path}.{key}" if path else key
            yield inner
            yield from list_used(entry, named[key], root, inner)
    elif isinstance(value, list) and "items" in schema:
        for entry in value:
            yield from list_used(entry, schema["items"], root, path + "[]")


def list_used_option(value, options, root, path):
    for option in options:
        form = resolve(option, root)
        if "enum" in form and isinstance(value, str) and value in form["enum"]:
            yield f"{path} as word"
        elif form_of(form) != form_of_value(value):
            continue
        else:
            yield f"{path} as {form_of(form)}"
        yield from list_used(value, form, root, path)
