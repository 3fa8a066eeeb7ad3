"""Runs `gxrod verify` and keeps what it found in results.json: rounded, so that only what changed differs."""

import json
import math
import subprocess

from .cases import KEPT, list_cases
from .comparison import ORDER

ERROR_DIGITS = 4
KEYS_OF_CHECK = ("what", "reference", "uncertainty", "value", "error", "tolerance", "order")


def run_cases(program, names):
    """What the program prints of these cases as JSON, and its exit code."""
    arguments = names or ["--all"]
    done = subprocess.run([program, "verify", *arguments, "--json"], text=True, stdout=subprocess.PIPE, check=False)
    return (json.loads(done.stdout) if done.stdout else {}), done.returncode


def round_to(value, digits):
    """To significant digits; what is no finite number stays."""
    if not isinstance(value, float) or not math.isfinite(value) or value == 0.0:
        return value
    return float(f"{value:.{digits - 1}e}")


def round_row(row):
    """Errors and other measured numbers of a run."""
    # Times are kept elsewhere; the energy error of an example is that of its ledger, which its checks look at.
    dropped = {"seconds", "energy_error"} if "refinement" in row else {"seconds"}
    kept = {key: round_to(value, ERROR_DIGITS) for key, value in row.items() if key not in dropped}
    if kept.get("order") is not None:
        kept["order"] = round(kept["order"], 2)
    return kept


def round_value(check):
    """A value to the second digit in which it differs from its reference: the rest says nothing."""
    pairs = [(found, known) for found, known in zip(check["value"], check["reference"]) if known is not None]
    distance = math.sqrt(sum((found - known) ** 2 for found, known in pairs))
    size = max(abs(number) for pair in pairs for number in pair)
    finest = max(distance, check["uncertainty"], 1e-15 * size, 1e-16)
    decimals = 1 - math.floor(math.log10(finest))
    return [None if found is None else round(found, decimals) + 0.0 for found in check["value"]]


def round_check(check):
    kept = {key: check[key] for key in KEYS_OF_CHECK}
    if check["what"].startswith(ORDER):
        kept["value"], kept["error"] = [round(check["value"][0], 2)], round(check["error"], 2)
        return kept
    kept["value"] = round_value(check)
    kept["error"] = round_to(check["error"], ERROR_DIGITS)
    if kept["order"] is not None:
        kept["order"] = round(kept["order"], 2)
    return kept


def gather(found, sentences):
    """{case: kind, source, sentence, rows, checks}, of what a run printed."""
    cases = {}
    for name, rows in found.items():
        if name == "checks":
            continue
        checks = [check for check in found["checks"] if check["case"] == name]
        cases[name] = {"kind": checks[0]["kind"], "source": checks[0]["source"], "sentence": sentences[name],
                       "rows": [round_row(row) for row in rows], "checks": [round_check(check) for check in checks]}
    return cases


def gather_seconds(found):
    return {check["case"]: round_to(check["case_seconds"], 1) for check in found["checks"]}


def run_book(program, names, before):
    """What results.json is to hold, of all cases, or of these while the others stay as they were before. Ends the
    script where a value missed its reference."""
    found, code = run_cases(program, names)
    if code:
        raise SystemExit(f"`gxrod verify` ends with exit code {code}: nothing was kept")
    cases, seconds = gather(found, list_cases(program)), gather_seconds(found)
    return {"cases": before["cases"] | cases, "seconds": before["seconds"] | seconds} if names else {
        "cases": cases, "seconds": seconds}


def write_kept(kept):
    """A line for each row and check."""
    lines = ["{", '"seconds": ' + json.dumps(kept["seconds"]) + ",", '"cases": {']
    for index, (name, case) in enumerate(kept["cases"].items()):
        lines.append(f'"{name}": {{')
        lines += [f'  "{key}": {json.dumps(case[key], ensure_ascii=False)},' for key in ("kind", "source", "sentence")]
        lines += [*lines_of_list("rows", case["rows"], ","), *lines_of_list("checks", case["checks"], "")]
        lines.append("}" if index + 1 == len(kept["cases"]) else "},")
    KEPT.write_text("\n".join([*lines, "}", "}"]) + "\n", encoding="utf-8")


def lines_of_list(key, entries, end):
    texts = [json.dumps(entry, ensure_ascii=False) for entry in entries]
    return [f'  "{key}": [', *(f"    {text}," for text in texts[:-1]), f"    {texts[-1]}", "  ]" + end]


def read_kept():
    return json.loads(KEPT.read_text(encoding="utf-8"))
